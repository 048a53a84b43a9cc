#include "problems/preintegration.h"

#include <algorithm>
#include <cmath>

#include "problems/rotation.h"
#include "problems/sampling.h"
#include "problems/saturation.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

// How far a signal can leave the straight line across a gap of length h: a curvature times h², no
// more than what an arm reaches at all.
constexpr double kRateCurvature = 50.0;    // [rad/s³]
constexpr double kRateLimit = 3.0;         // [rad/s]
constexpr double kForceCurvature = 100.0;  // [m/s⁴]
constexpr double kForceLimit = 10.0;       // [m/s²]

// Half of the time over which a signal is taken for a parabola to tell it from its noise [s].
constexpr double kSmoothed = 0.05;

// The turn of a part of a cell of length h, and what a bias changes of it.
struct PartTurn {
  PartTurn(double h, const Vector3d& w, const Vector3d& w_slope) {
    const Vector3d turn = w * h + w.cross(w_slope) * (h * h * h / 12);
    dq = Exp<double>(turn);
    R_back = dq.conjugate().toRotationMatrix();
    J = RightJacobian(turn) * h;
  }
  Eigen::Quaterniond dq;
  Eigen::Matrix3d R_back, J;
};

}  // namespace

struct Preintegrator::Cell {
  double h;
  Vector3d w, f, w_slope, f_slope;
};

Preintegrator::Preintegrator(const Recording& recording) : period_(SamplingPeriod(recording)) {
  const std::size_t n = recording.size();
  const std::vector<double>& time = recording.time;
  const auto is_gap = [&](std::size_t i) { return time[i + 1] - time[i] > kGapFactor * period_; };
  std::size_t cells = n + 2;
  for (std::size_t i = 0; i + 1 < n; ++i) cells += is_gap(i) ? 1 : 0;
  edges_.reserve(cells + 1);
  for (auto* numbers : {&centres_, &gyro_unknown_, &accel_unknown_}) numbers->reserve(cells);
  for (auto* vectors : {&gyr_, &acc_}) vectors->reserve(cells);

  double begin = time[0] - period_ / 2;
  AddCell(begin - kHeld, begin - kHeld / 2, recording.gyr_S[0], recording.acc_S[0], kHeld);
  for (std::size_t i = 0; i < n; ++i) {
    AddCell(begin, time[i], recording.gyr_S[i], recording.acc_S[i], 0.0);
    if (i + 1 == n) break;
    const double step = time[i + 1] - time[i];
    begin = time[i] + step / 2;
    if (!is_gap(i)) continue;
    AddCell(time[i] + period_ / 2, begin, 0.5 * (recording.gyr_S[i] + recording.gyr_S[i + 1]),
            0.5 * (recording.acc_S[i] + recording.acc_S[i + 1]), step - period_);
    begin = time[i + 1] - period_ / 2;
  }
  const double end = time[n - 1] + period_ / 2;
  AddCell(end, end + kHeld / 2, recording.gyr_S[n - 1], recording.acc_S[n - 1], kHeld);
  edges_.push_back(end + kHeld);
  DoubtSaturated(recording);
}

// `gap`: for how long there was no sample.
void Preintegrator::AddCell(double begin, double centre, const Vector3d& gyr, const Vector3d& acc,
                            double gap) {
  const double rate_error = std::min(kRateCurvature * gap * gap, kRateLimit);
  const double force_error = std::min(kForceCurvature * gap * gap, kForceLimit);
  edges_.push_back(begin);
  centres_.push_back(centre);
  gyr_.push_back(gyr);
  acc_.push_back(acc);
  gyro_unknown_.push_back(rate_error * rate_error * gap);
  accel_unknown_.push_back(force_error * force_error * gap);
}

// The hidden excess is one number for a whole run: its variance grows with the run's length squared.
void Preintegrator::DoubtSaturated(const Recording& recording) {
  const auto doubt = [&](const std::vector<Vector3d>& samples, double least,
                         std::vector<double>& unknown) {
    for (const SaturatedRun& run : FindSaturatedRuns(samples, least)) {
      const double excess = HiddenExcess(recording.time, samples, run);
      const std::size_t first = CellAt(recording.time[run.first]);
      const std::size_t last = CellAt(recording.time[run.last - 1]);
      const double density = excess * excess * (edges_[last + 1] - edges_[first]);
      for (std::size_t cell = first; cell <= last; ++cell) unknown[cell] += density;
    }
  };
  doubt(recording.gyr_S, kSmallestGyroRange, gyro_unknown_);
  doubt(recording.acc_S, kSmallestAccelRange, accel_unknown_);
}

// The part of a cell inside [start, end], its values moved along the slope to the part's centre.
Preintegrator::Cell Preintegrator::Clip(std::size_t cell, double start, double end) const {
  const double from = std::max(start, edges_[cell]), to = std::min(end, edges_[cell + 1]);
  const double shift = 0.5 * (from + to) - 0.5 * (edges_[cell] + edges_[cell + 1]);
  const Vector3d w_slope = Slope(gyr_, cell), f_slope = Slope(acc_, cell);
  return {to - from, gyr_[cell] + shift * w_slope, acc_[cell] + shift * f_slope, w_slope, f_slope};
}

// From the neighbours; what is held beyond the ends has none and is none.
Vector3d Preintegrator::Slope(const std::vector<Vector3d>& values, std::size_t cell) const {
  const std::size_t last = Cells() - 1;
  if (cell == 0 || cell == last) return Vector3d::Zero();
  const std::size_t before = std::max<std::size_t>(cell - 1, 1),
                    after = std::min(cell + 1, last - 1);
  return (values[after] - values[before]) / (centres_[after] - centres_[before]);
}

// On the parabola through its neighbours, as many on either side as kSmoothed and the ends allow.
// Source: Savitzky & Golay, Anal. Chem. 36 (1964).
Vector3d Preintegrator::Smooth(const std::vector<Vector3d>& values, std::size_t cell) const {
  const std::size_t last = Cells() - 2, i = std::clamp<std::size_t>(cell, 1, last);
  const auto reach = static_cast<std::size_t>(std::lround(kSmoothed / period_));
  const std::size_t m = std::min({reach, i - 1, last - i});
  const auto n = static_cast<double>(m);
  const double total = (2 * n - 1) * (2 * n + 1) * (2 * n + 3), top = 3 * (3 * n * n + 3 * n - 1);
  Vector3d sum = top * values[i];
  for (std::size_t j = 1; j <= m; ++j)
    sum += (top - 15 * static_cast<double>(j * j)) * (values[i - j] + values[i + j]);
  return sum / total;
}

std::size_t Preintegrator::CellAt(double time) const {
  const auto after = std::upper_bound(edges_.begin(), edges_.end(), time) - edges_.begin();
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - 1, 0));
}

Vector3d Preintegrator::At(const std::vector<Vector3d>& values, double time) const {
  const std::size_t cell = std::min(CellAt(time), Cells() - 1);
  const std::size_t before = time < centres_[cell] && cell > 0 ? cell - 1 : cell;
  const std::size_t after = std::min(before + 1, Cells() - 1);
  if (after == before) return Smooth(values, before);
  const double fraction = (time - centres_[before]) / (centres_[after] - centres_[before]);
  return (1 - fraction) * Smooth(values, before) + fraction * Smooth(values, after);
}

Turned Preintegrator::Turn(double start, double end, const Vector3d& gyro_bias,
                           double clock_offset) const {
  Turned turned;
  turned.duration = end - start;
  start -= clock_offset;
  end -= clock_offset;
  for (std::size_t i = CellAt(start); i < Cells() && edges_[i] < end; ++i) {
    const Cell cell = Clip(i, start, end);
    if (cell.h <= 0.0) continue;
    const PartTurn turn(cell.h, cell.w - gyro_bias, cell.w_slope);
    turned.dR_dbg = turn.R_back * turned.dR_dbg - turn.J;
    turned.dq = (turned.dq * turn.dq).normalized();
    turned.gyro_gap_variance += gyro_unknown_[i] * cell.h;
  }
  return turned;
}

Preintegrated Preintegrator::Sum(double start, double end, const Vector3d& gyro_bias,
                                 double clock_offset) const {
  Preintegrated sum;
  sum.duration = end - start;
  sum.gyro_bias = gyro_bias;
  sum.clock_offset = clock_offset;
  start -= clock_offset;
  end -= clock_offset;
  for (std::size_t i = CellAt(start); i < Cells() && edges_[i] < end; ++i) {
    const auto [h, gyr, f, w_slope, f_slope] = Clip(i, start, end);
    if (h <= 0.0) continue;
    const Vector3d w = gyr - gyro_bias;
    const Vector3d wxf = w.cross(f);
    const Vector3d f_m =
        f + h * h / 12 * (w.cross(f_slope) + 0.5 * w_slope.cross(f) + 0.5 * w.cross(wxf));
    const Vector3d half_turn = w * (h / 2) - w_slope * (h * h / 8);
    const Eigen::Quaterniond dq_half = Exp<double>(half_turn);
    const PartTurn turn(h, w, w_slope);
    const Eigen::Matrix3d R_m = (sum.dq * dq_half).toRotationMatrix();

    const Eigen::Matrix3d J_half = RightJacobian(half_turn) * (h / 2);
    const Eigen::Matrix3d R_half = dq_half.conjugate().toRotationMatrix();
    const Eigen::Matrix3d a_dphi = -R_m * Skew<double>(f);
    const Eigen::Matrix3d a_dbg = a_dphi * (R_half * sum.dR_dbg - J_half);
    const Eigen::Matrix3d a_dsg = a_dphi * (R_half * sum.dR_dsg - J_half * gyr.asDiagonal());
    const Eigen::Matrix3d a_dsa = -R_m * f.asDiagonal();
    sum.dp_dbg += sum.dv_dbg * h + a_dbg * (h * h / 2);
    sum.dv_dbg += a_dbg * h;
    sum.dp_dsg += sum.dv_dsg * h + a_dsg * (h * h / 2);
    sum.dv_dsg += a_dsg * h;
    sum.dp_dba += sum.dv_dba * h - R_m * (h * h / 2);
    sum.dv_dba -= R_m * h;
    sum.dp_dsa += sum.dv_dsa * h + a_dsa * (h * h / 2);
    sum.dv_dsa += a_dsa * h;
    sum.dR_dbg = turn.R_back * sum.dR_dbg - turn.J;
    sum.dR_dsg = turn.R_back * sum.dR_dsg - turn.J * gyr.asDiagonal();

    sum.dp += sum.dv * h + R_m * (f_m * (h * h / 2) - (wxf + f_slope) * (h * h * h / 12));
    sum.dv += R_m * f_m * h;
    sum.dq = (sum.dq * turn.dq).normalized();

    const double w_squared = w.squaredNorm();
    const double spread = w_slope.norm() + w_squared;
    sum.rate_squared += w_squared * h;
    sum.force_spread += spread * spread * h;
    sum.gyro_gap_variance += gyro_unknown_[i] * h;
    sum.accel_gap_variance += accel_unknown_[i] * h;
  }
  const Vector3d w_0 = At(gyr_, start) - gyro_bias, w_1 = At(gyr_, end) - gyro_bias;
  const Vector3d f_0 = At(acc_, start), f_1 = At(acc_, end);
  sum.dR_dc = sum.dq.conjugate() * w_0 - w_1;
  sum.dv_dc = w_0.cross(sum.dv) - sum.dq * f_1 + f_0;
  sum.dp_dc = w_0.cross(sum.dp) - sum.dv + sum.duration * f_0;
  return sum;
}

}  // namespace brachium
