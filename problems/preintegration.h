// The motion of one sensor between two knots, summed once from its samples.
//
// Over an interval of length D that starts at attitude R, velocity v and position p of the sensor,
//   R_end = R dR,   v_end = v + g D + R dv,   p_end = p + v D + g D²/2 + R dp.
// Each sample is the mean over its cell; a cell is clipped to the interval. Within a cell the rate
// and the specific force are straight lines (mean and slope from the neighbours), which keeps coning
// and sculling to third order in the cell length h. With w, w', f, f' at the cell's centre and
//   R_m = dR Exp(w h/2 - w' h²/8)                        the attitude at the middle of the cell,
//   f_m = f + h²/12 (w×f' + w'×f/2 + w×(w×f)/2),
//   dp += dv h + R_m (f_m h²/2 - (w×f + f') h³/12),   dv += R_m f_m h,
//   dR  = dR Exp(w h + w×w' h³/12).
// A clock that is behind the true time by c stamps its samples c too early: what a true interval holds
// are the samples of c before it, which changes the sums by what enters at the one end and leaves at
// the other. With w_0, f_0 at the start and w_1, f_1 at the end,
//   dR -> dR Exp(dR_dc c),   dR_dc = dRᵀ w_0 - w_1,
//   dv_dc = w_0 × dv - dR f_1 + f_0,   dp_dc = w_0 × dp - dv + D f_0.
// These four are smoothed: of single samples the noise would pass for movement that tells the clock,
// and slow movement would be believed to show hardly any offset.
// Sources: Forster et al., IEEE T-RO 33 (2017), for the bias corrections; Savage, J. Guid. Control
// Dyn. 21 (1998), for coning and sculling.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <vector>

#include "problems/imu.h"

namespace brachium {

struct Preintegrated {
  double duration = 0.0;                                   // D [s]
  Eigen::Quaterniond dq = Eigen::Quaterniond::Identity();  // dR
  Eigen::Vector3d dv = Eigen::Vector3d::Zero();            // [m/s]
  Eigen::Vector3d dp = Eigen::Vector3d::Zero();            // [m]
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();     // taken off while summing [rad/s]
  double clock_offset = 0.0;  // that the clock was taken to be behind while summing [s]

  // First-order changes with biases and scale errors: dR -> dR Exp(dR_dbg δ), dv -> dv + dv_dbg δ,
  // and so on; w = gyr - b_g - s_g∘gyr, f = acc - b_a - s_a∘acc.
  Eigen::Matrix3d dR_dbg = Eigen::Matrix3d::Zero(), dR_dsg = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d dv_dsg = Eigen::Matrix3d::Zero(), dp_dsg = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d dv_dbg = Eigen::Matrix3d::Zero(), dp_dbg = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d dv_dba = Eigen::Matrix3d::Zero(), dp_dba = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d dv_dsa = Eigen::Matrix3d::Zero(), dp_dsa = Eigen::Matrix3d::Zero();

  // First-order changes with what the clock is further behind, c.
  Eigen::Vector3d dR_dc = Eigen::Vector3d::Zero();
  Eigen::Vector3d dv_dc = Eigen::Vector3d::Zero(), dp_dc = Eigen::Vector3d::Zero();

  // What the weights are made of: integrals over the interval.
  double rate_squared = 0.0;  // of |w|² [rad²/s]
  double force_spread = 0.0;  // of (|w'| + |w|²)² [1/s³]: times a lever arm squared, (m/s²)² s
  double gyro_gap_variance =
      0.0;  // [rad²] that samples which are missing or out of range add to dR
  double accel_gap_variance = 0.0;  // [m²/s²] the same of dv; both per axis
};

// The attitude's part alone.
struct Turned {
  double duration = 0.0;                                   // D [s]
  Eigen::Quaterniond dq = Eigen::Quaterniond::Identity();  // dR
  Eigen::Matrix3d dR_dbg = Eigen::Matrix3d::Zero();
  double gyro_gap_variance = 0.0;  // [rad²]
};

// Sums a recording between successive knots. Knots outside the recording's cells are an error.
class Preintegrator {
 public:
  explicit Preintegrator(const Recording& recording);

  // First and last instant that the cells cover [s].
  double Begin() const { return edges().front(); }
  double End() const { return edges().back(); }

  // Where one cell ends and the next begins, first and last edge included [s].
  std::span<const double> edges() const { return {&edges_[1], edges_.size() - 2}; }
  double Period() const { return period_; }

  // Over [start, end], with this gyro bias taken off, by a clock that is behind by `clock_offset`.
  // Begin() <= start < end <= End(); samples that the offset asks for beyond these are taken to be as
  // the nearest, with a variance, as far as kHeld.
  Preintegrated Sum(double start, double end, const Eigen::Vector3d& gyro_bias,
                    double clock_offset = 0.0) const;
  static constexpr double kHeld = 0.2;  // [s]

  // The same of the attitude only, several times as fast.
  Turned Turn(double start, double end, const Eigen::Vector3d& gyro_bias,
              double clock_offset = 0.0) const;

 private:
  struct Cell;
  std::size_t Cells() const { return gyr_.size(); }
  Cell Clip(std::size_t cell, double start, double end) const;
  Eigen::Vector3d Slope(const std::vector<Eigen::Vector3d>& values, std::size_t cell) const;
  std::size_t CellAt(double time) const;
  Eigen::Vector3d Smooth(const std::vector<Eigen::Vector3d>& values, std::size_t cell) const;
  // Smooth, and straight between the cells' centres. `time` within the cells.
  Eigen::Vector3d At(const std::vector<Eigen::Vector3d>& values, double time) const;
  void AddCell(double begin, double centre, const Eigen::Vector3d& gyr, const Eigen::Vector3d& acc,
               double gap);
  void DoubtSaturated(const Recording& recording);

  double period_;
  std::vector<double> edges_;  // cell i lies between edges i and i+1; the first and the last hold
  std::vector<double> centres_;
  // What is not known of a cell, as densities: where there is no sample and the mean of the
  // neighbours stands in, and where the sensor was out of its range.
  std::vector<double> gyro_unknown_;   // [rad²/s]
  std::vector<double> accel_unknown_;  // [m²/s³]
  std::vector<Eigen::Vector3d> gyr_, acc_;
};

}  // namespace brachium
