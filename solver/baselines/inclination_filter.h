// The Kalman filter of Luinge & Veltink (2005) for one segment or several: the gyroscope turns the
// attitude, the accelerometer, less a predicted acceleration, corrects the inclination.
//
// State     error of each segment {θ; δb}: R = R^ Exp(θ) in segment axes [rad], b = b^ + δb [rad/s].
//           Segments share one covariance P, so that a measurement of two keeps what it says of both.
// Predict   R^ <- R^ dR(w - b^),  F = [dRᵀ, ∂dR/∂b; 0, I],  Q = diag(N²T/2 (+ gap), walk² T).
// Measure   a⁻ = c a⁺ in W,  c = exp(-2π f T),  P_a⁻ = c² P_a⁺ + σ_a² (1 - c²) I
//           Z_G = R^ᵀ e_z,  Z_A = (y - a⁻)/|y - a⁻|
//           Bᵀ(Z_A - Z_G) = Bᵀ[Z_G]x θ + n,  cov(n) = Bᵀ(P_a⁻ + s² I)B / g²,  B ⟂ Z_G (two columns)
//           then  a⁺ = y - g R^ᵀ e_z,  P_a⁺ = s² I + g² [Z]x P_θ [Z]xᵀ
//           s² = N_a²/(2h) + (bias sd)²: white noise of a sample and the unknown bias.
// Blind to  the heading: the row of e_z in Bᵀ[Z_G]x is zero by construction.
// Departs   from the paper as far as it leaves room: rates are summed over whole cells to third
//           order (a sample is a mean; the state stands at its centre); a gap is bridged by the
//           neighbours' mean with the variance it deserves, and a forgotten acceleration; the
//           acceleration is carried in W. Errors of a⁺ and of θ are taken as independent though they
//           are nearly the same. Inclinations are therefore claimed too certain, and wrong ones
//           righted slowly, the more so the lower f is: with the correlation, H = (1 - c) Bᵀ[Z_G]x
//           and cov(n) = (σ_a² (1 - c²) + s² (1 + c²)) I / g², simulated inclinations were one to
//           three tenths better; but the elbow's constraint, too certain itself, then bent them more,
//           and `luinge` was a quarter worse.
// Source    Luinge & Veltink, Med. Biol. Eng. Comput. 43 (2005) 273-282.
#pragma once

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <numbers>

#include "problems/rotation.h"
#include "solver/baselines/tracks.h"

namespace brachium {

// The acceleration of a segment as a first-order process. The paper's figures are not established;
// these are ours, see luinge.h.
struct AccelerationModel {
  double cutoff_hz = 0.0;     // f
  double sigma = 0.0;         // σ_a per axis [m/s²]
  double gravity = kGravity;  // [m/s²]
};

template <int kSegments>
struct FilterState {
  static constexpr int kSize = 6 * kSegments;  // {θ; δb} of each segment
  using Vector = Eigen::Matrix<double, kSize, 1>;
  using Matrix = Eigen::Matrix<double, kSize, kSize>;

  double time = 0.0;  // [s]
  std::array<Eigen::Quaterniond, kSegments> q_WB;
  std::array<Eigen::Vector3d, kSegments> gyro_bias;  // segment axes [rad/s]
  Matrix P;

  void Add(const Vector& error) {
    for (std::size_t i = 0; i < kSegments; ++i) {
      const auto row = static_cast<Eigen::Index>(6 * i);
      q_WB[i] = (q_WB[i] * Exp<double>(error.template segment<3>(row))).normalized();
      gyro_bias[i] += error.template segment<3>(row + 3);
    }
  }

  // The error that Add() needs to bring `from` here.
  Vector Minus(const FilterState& from) const {
    Vector error;
    for (std::size_t i = 0; i < kSegments; ++i) {
      const auto row = static_cast<Eigen::Index>(6 * i);
      error.template segment<3>(row) = Log<double>(from.q_WB[i].conjugate() * q_WB[i]);
      error.template segment<3>(row + 3) = gyro_bias[i] - from.gyro_bias[i];
    }
    return error;
  }
};

// The matrix F that carries errors on to a later instant: of each segment [dRᵀ, ∂dR/∂b; 0, I].
template <int kSegments>
struct ErrorTransition {
  std::array<Eigen::Matrix3d, kSegments> back, dR_db;

  // M Fᵀ
  template <typename Matrix>
  Matrix TransposedAfter(const Matrix& M) const {
    Matrix product = M;
    for (std::size_t i = 0; i < kSegments; ++i) {
      const auto at = static_cast<Eigen::Index>(6 * i);
      product.template middleCols<3>(at).noalias() =
          M.template middleCols<3>(at) * back[i].transpose() +
          M.template middleCols<3>(at + 3) * dR_db[i].transpose();
    }
    return product;
  }
};

template <int kSegments>
class InclinationFilter {
 public:
  using State = FilterState<kSegments>;
  using Members = std::array<const Track*, kSegments>;
  template <int kRows>
  using Attitudes = std::array<Eigen::Matrix<double, kRows, 3>, kSegments>;

  // The tracks must outlive the filter; it begins at `start` with what they know.
  InclinationFilter(const Members& members, const AccelerationModel& model, double start)
      : members_(members), model_(model) {
    state_.time = start;
    state_.P.setZero();
    for (std::size_t i = 0; i < kSegments; ++i) {
      const Track& track = *members[i];
      state_.q_WB[i] = track.q_WB;
      state_.gyro_bias[i] = track.gyro_bias;
      const double inclination = track.inclination_sigma, heading = track.heading_sigma;
      const Eigen::Matrix3d R_BW = track.q_WB.conjugate().toRotationMatrix();
      const Eigen::Vector3d sigma_W(inclination, inclination, heading);
      const auto row = static_cast<Eigen::Index>(6 * i);
      state_.P.template block<3, 3>(row, row) =
          R_BW * sigma_W.cwiseAbs2().asDiagonal() * R_BW.transpose();
      state_.P.template block<3, 3>(row + 3, row + 3)
          .diagonal()
          .setConstant(track.gyro_bias_sigma * track.gyro_bias_sigma);
      acceleration_[i] = {Eigen::Vector3d::Zero(),
                          model.sigma * model.sigma * Eigen::Matrix3d::Identity(), start};
    }
  }

  const State& state() const { return state_; }

  // Moves a state on to a later instant [s]; gives the transition of the errors on the way.
  static ErrorTransition<kSegments> Predict(const Members& members, double time, State& state) {
    ErrorTransition<kSegments> F;
    typename State::Vector Q;
    for (std::size_t i = 0; i < kSegments; ++i) {
      const ImuNoise& noise = members[i]->recording.noise;
      const Turned turned = members[i]->samples.Turn(state.time, time, state.gyro_bias[i]);
      state.q_WB[i] = (state.q_WB[i] * turned.dq).normalized();
      F.back[i] = turned.dq.conjugate().toRotationMatrix();
      F.dR_db[i] = turned.dR_dbg;
      const auto row = static_cast<Eigen::Index>(6 * i);
      Q.template segment<3>(row).setConstant(0.5 * noise.gyro_density * noise.gyro_density *
                                                 turned.duration +
                                             turned.gyro_gap_variance);
      Q.template segment<3>(row + 3).setConstant(noise.gyro_bias_walk * noise.gyro_bias_walk *
                                                 turned.duration);
    }
    const typename State::Matrix FP = F.TransposedAfter(state.P).transpose();
    state.P = F.TransposedAfter(FP);
    state.P.diagonal() += Q;
    state.time = time;
    return F;
  }

  void Predict(double time) {
    if (time > state_.time) Predict(members_, time, state_);
  }

  // The accelerometer's sample of a segment at the state's instant.
  void Measure(std::size_t segment, std::size_t sample) {
    const Recording& recording = members_[segment]->recording;
    const Eigen::Vector3d& y = recording.acc_S[sample];
    const double s_squared = SampleVariance(*members_[segment]);
    Acceleration& a = acceleration_[segment];
    Forget(a);
    const Eigen::Matrix3d R = state_.q_WB[segment].toRotationMatrix();
    const Eigen::Vector3d Z_G = R.row(2).transpose();
    const Eigen::Vector3d Z_A = (y - R.transpose() * a.value_W).normalized();
    Eigen::Matrix<double, 3, 2> B;
    B.col(0) = Z_G.unitOrthogonal();
    B.col(1) = Z_G.cross(B.col(0));
    Attitudes<2> H;
    H.fill(Eigen::Matrix<double, 2, 3>::Zero());
    H[segment] = B.transpose() * Skew<double>(Z_G);
    const Eigen::Matrix<double, 3, 2> B_W = R * B;
    const Eigen::Matrix2d noise =
        (B_W.transpose() * a.P_W * B_W + s_squared * Eigen::Matrix2d::Identity()) /
        (model_.gravity * model_.gravity);
    Correct<2>(B.transpose() * (Z_A - Z_G), H, noise);

    const Eigen::Matrix3d R_WB = state_.q_WB[segment].toRotationMatrix();
    const Eigen::Matrix3d tilt =
        model_.gravity * R_WB * Skew<double>(Eigen::Vector3d(R_WB.row(2).transpose()));
    a.value_W = R_WB * y - model_.gravity * Eigen::Vector3d::UnitZ();
    const auto row = static_cast<Eigen::Index>(6 * segment);
    a.P_W = tilt * state_.P.template block<3, 3>(row, row) * tilt.transpose() +
            s_squared * Eigen::Matrix3d::Identity();
  }

  // A magnetometer's sample m: the field keeps the heading of `north_W`, a horizontal direction,
  //   δ = angle from R m to north about e_z = e_zᵀ R θ + n.
  void MeasureHeading(std::size_t segment, const Eigen::Vector3d& mag_B,
                      const Eigen::Vector2d& north_W, double sigma) {
    const Eigen::Matrix3d R = state_.q_WB[segment].toRotationMatrix();
    const Eigen::Vector2d m = (R * mag_B).head<2>();
    const double delta = std::atan2(m.x() * north_W.y() - m.y() * north_W.x(), m.dot(north_W));
    if (!std::isfinite(delta)) return;
    Attitudes<1> H;
    H.fill(Eigen::RowVector3d::Zero());
    H[segment] = R.row(2);
    Correct<1>(Eigen::Matrix<double, 1, 1>(delta), H, Eigen::Matrix<double, 1, 1>(sigma * sigma));
  }

  // z = Σ H_i θ_i + noise. With S = L Lᵀ and G = P Hᵀ L⁻ᵀ, P - K S Kᵀ is P - G Gᵀ: symmetric as
  // Joseph's form is, and equal to it at this gain.
  template <int kRows>
  void Correct(const Eigen::Matrix<double, kRows, 1>& z, const Attitudes<kRows>& H,
               const Eigen::Matrix<double, kRows, kRows>& noise) {
    Eigen::Matrix<double, State::kSize, kRows> PHT =
        state_.P.template leftCols<3>() * H[0].transpose();
    for (std::size_t i = 1; i < kSegments; ++i)
      PHT += state_.P.template middleCols<3>(static_cast<Eigen::Index>(6 * i)) * H[i].transpose();
    Eigen::Matrix<double, kRows, kRows> S = noise;
    for (std::size_t i = 0; i < kSegments; ++i)
      S += H[i] * PHT.template middleRows<3>(static_cast<Eigen::Index>(6 * i));
    const Eigen::LLT<Eigen::Matrix<double, kRows, kRows>> L(S);
    const Eigen::Matrix<double, State::kSize, kRows> G =
        L.matrixL().solve(PHT.transpose()).transpose();
    state_.P.noalias() -= G.lazyProduct(G.transpose());
    state_.Add(G * L.matrixL().solve(z));
  }

 private:
  struct Acceleration {
    Eigen::Vector3d value_W;  // [m/s²]
    Eigen::Matrix3d P_W;
    double time;  // [s]
  };

  static double SampleVariance(const Track& track) {
    const ImuNoise& noise = track.recording.noise;
    return 0.5 * noise.accel_density * noise.accel_density / track.samples.Period() +
           noise.accel_bias_sigma * noise.accel_bias_sigma;
  }

  void Forget(Acceleration& a) const {
    const double c = std::exp(-2 * std::numbers::pi * model_.cutoff_hz * (state_.time - a.time));
    a.value_W *= c;
    a.P_W = c * c * a.P_W + model_.sigma * model_.sigma * (1 - c * c) * Eigen::Matrix3d::Identity();
    a.time = state_.time;
  }

  Members members_;
  AccelerationModel model_;
  State state_;
  std::array<Acceleration, kSegments> acceleration_;
};

}  // namespace brachium
