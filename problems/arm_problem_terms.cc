// The terms of the objective: where each residual gets its samples, unknowns and weight.
#include <algorithm>
#include <cmath>

#include "problems/arm_problem.h"
#include "problems/residuals/accelerometer.h"
#include "problems/residuals/as_mounted.h"
#include "problems/residuals/elbow_adduction.h"
#include "problems/residuals/gyro_bias.h"
#include "problems/residuals/gyroscope.h"
#include "problems/residuals/in_body_axes.h"
#include "problems/residuals/prior.h"
#include "problems/residuals/range_of_motion.h"
#include "problems/residuals/segment_chain.h"
#include "problems/residuals/segment_length.h"
#include "problems/residuals/shoulder_process.h"
#include "problems/residuals/skin.h"
#include "problems/residuals/thorax_shoulder.h"
#include "problems/residuals/zero_velocity.h"

namespace brachium {
namespace {

using Eigen::Vector3d;
using Scalar = Eigen::Matrix<double, 1, 1>;

constexpr double kGaugeSigma = 1e-4;         // of the first place [m]
constexpr double kElbowSwing = 0.2;          // of an elbow, first joint of a chain, per axis [m]
constexpr double kLostAttitude = 2.0;        // by the longest gap: more than that is a turn [rad]
constexpr double kStartVelocitySigma = 2.0;  // a person may walk into a trial [m/s]
constexpr double kFlexionLimits[] = {-5 * kDegree, 160 * kDegree};

std::size_t U(int i) { return static_cast<std::size_t>(i); }

double Square(double x) { return x * x; }

// The middle of the interval that begins at a knot [s].
double Middle(const Timeline& timeline, int knot) {
  return 0.5 * (timeline.knots[U(knot)] + timeline.knots[U(knot) + 1]);
}

// A rest that is none says its wrong thing linearly from here on, not with the square [sd].
constexpr double kRestOutlier = 3.0;

std::shared_ptr<ceres::LossFunction> LossOf(ResidualKind kind) {
  static const auto huber = std::make_shared<ceres::HuberLoss>(kRestOutlier);
  const bool of_a_rest = kind == ResidualKind::kZeroVelocity || kind == ResidualKind::kGyroBiasRest;
  return of_a_rest ? huber : nullptr;
}

}  // namespace

template <typename Residual>
void ArmProblem::Add(Residual residual, ResidualKind kind, std::vector<int> unknowns, int sensor,
                     int first, int last) {
  terms_.push_back({std::unique_ptr<TangentCost>(MakeCost(std::move(residual))),
                    std::move(unknowns), kind, sensor, first, last, LossOf(kind)});
}

// What is known for certain is held.
template <int kSize>
void ArmProblem::AddConstant(UnknownKind kind, int sensor,
                             const Eigen::Matrix<double, kSize, 1>& mean,
                             const Eigen::Matrix<double, kSize, 1>& sigma) {
  const bool held = sigma.isZero(0.0);
  constants_.push_back({kind, -1, sensor, held});
  if (!held)
    Add(Prior<kSize>(mean, sigma), ResidualKind::kPrior,
        {first_constant_ + static_cast<int>(constants_.size()) - 1}, sensor, 0, 0);
}

void ArmProblem::AddSensorConstants(int sensor) {
  const Recording& recording = observations_.recordings[U(sensor)];
  const bool alone = size_.sensors == 1;
  const auto add = [&](UnknownKind kind, const Vector3d& mean, double sigma) {
    AddConstant<3>(kind, sensor, mean, Vector3d::Constant(sigma));
  };
  const Mounting mounting = recording.mounting.value_or(Mounting{.q_sigma = 0.0});
  const bool own_clock = !alone && sensor != clock_sensor_;
  add(UnknownKind::kGyroScale, Vector3d::Zero(), options_.gyro_scale_sigma);
  add(UnknownKind::kAccelBias, Vector3d::Zero(), recording.noise.accel_bias_sigma);
  add(UnknownKind::kAccelScale, Vector3d::Zero(), options_.accel_scale_sigma);
  add(UnknownKind::kMounting, Vector3d::Zero(), ShowsMounting(sensor) ? mounting.q_sigma : 0.0);
  add(UnknownKind::kSensorPosition, alone ? Vector3d::Zero() : mounting.p_BS_B,
      alone ? 0.0 : mounting.p_sigma);
  AddConstant<1>(UnknownKind::kClockOffset, sensor, Scalar::Zero(),
                 Scalar(own_clock ? options_.clock_offset_sigma_s : 0.0));
  const bool is_link = sensor + 1 < size_.sensors && sensor >= FirstOfArm();
  if (is_link || IsTouching(recording.segment)) {
    const SegmentGeometry& geometry = observations_.arm.segments.at(recording.segment);
    constants_.push_back({UnknownKind::kJointVector, -1, sensor, geometry.sigma == 0.0});
    if (geometry.sigma > 0.0)
      Add(SegmentLength(geometry.p_distal_B, geometry.sigma), ResidualKind::kSegmentLength,
          {Constant(UnknownKind::kJointVector, sensor)}, sensor, 0, 0);
  }
}

void ArmProblem::AddConstants() {
  for (int sensor = 0; sensor < size_.sensors; ++sensor) AddSensorConstants(sensor);
  if (size_.sensors > 1 && size_.roots == 1)
    constants_.push_back({UnknownKind::kShoulderMean, -1, -1});
  for (int contact = 0; contact < size_.contacts; ++contact) {
    const bool is_height = observations_.contacts[U(contact)].height_only;
    constants_.push_back(
        {is_height ? UnknownKind::kContactHeight : UnknownKind::kContactPlace, -1, contact});
  }
  if (!HasElbow()) return;
  const ElbowModel& elbow = observations_.arm.elbow;
  AddConstant<2>(UnknownKind::kCarryingAngle, -1, {elbow.carrying_angle, 0.0},
                 {elbow.carrying_angle_sigma, elbow.carrying_slope_sigma});
}

double ArmProblem::GapVariance(const Preintegrated& interval) {
  return std::min(interval.gyro_gap_variance, Square(kLostAttitude));
}

std::unique_ptr<TangentCost> ArmProblem::MakeGyroscope(int knot, int sensor) const {
  const Preintegrated& interval = Interval(knot, sensor);
  const Recording& recording = observations_.recordings[U(sensor)];
  const double variance = 0.5 * Square(recording.noise.gyro_density) * interval.duration +
                          2 * options_.unmodelled_correlation_s * Square(options_.gyro_cross_axis) *
                              interval.rate_squared +
                          GapVariance(interval);
  const Eigen::Quaterniond q_BS =
      recording.mounting ? recording.mounting->q_BS : Eigen::Quaterniond::Identity();
  return std::unique_ptr<TangentCost>(MakeCost(Gyroscope(
      interval, q_BS, timeline_.NodeFraction(Middle(timeline_, knot)), std::sqrt(variance))));
}

void ArmProblem::AddGyroscope(int knot, int sensor) {
  const int node = timeline_.NodeBefore(Middle(timeline_, knot));
  terms_.push_back({MakeGyroscope(knot, sensor),
                    {Attitude(knot, sensor), Attitude(knot + 1, sensor), GyroBias(node, sensor),
                     GyroBias(node + 1, sensor), Constant(UnknownKind::kGyroScale, sensor),
                     Constant(UnknownKind::kClockOffset, sensor)},
                    ResidualKind::kGyroscope,
                    sensor,
                    knot,
                    knot + 1});
}

double ArmProblem::UnmodelledDensity(int knot, int sensor, double sigma) const {
  const Preintegrated& interval = Interval(knot, sensor);
  const double turning = Square(options_.accel_size_m) * interval.force_spread / interval.duration;
  return 2 * options_.unmodelled_correlation_s * (Square(sigma) + turning) +
         interval.accel_gap_variance / interval.duration;
}

std::unique_ptr<TangentCost> ArmProblem::MakeAccelerometer(int knot, int sensor) const {
  const Preintegrated& interval = Interval(knot, sensor);
  const Recording& recording = observations_.recordings[U(sensor)];
  const double density = 0.5 * Square(recording.noise.accel_density) +
                         UnmodelledDensity(knot, sensor, unmodelled_[U(sensor)].acceleration);
  const Whitening2 whitening =
      Whitening2::FromCovariance(WhiteAccelerationCovariance(density, interval.duration));
  const Eigen::Quaterniond q_BS =
      recording.mounting ? recording.mounting->q_BS : Eigen::Quaterniond::Identity();
  const double alpha = timeline_.NodeFraction(Middle(timeline_, knot));
  return std::unique_ptr<TangentCost>(
      MakeCost(Accelerometer(interval, q_BS, alpha, observations_.gravity, whitening)));
}

void ArmProblem::AddAccelerometer(int knot, int sensor) {
  const int node = timeline_.NodeBefore(Middle(timeline_, knot));
  terms_.push_back(
      {MakeAccelerometer(knot, sensor),
       {Attitude(knot, sensor), Place(knot, sensor), Place(knot + 1, sensor),
        Velocity(knot, sensor), Velocity(knot + 1, sensor), GyroBias(node, sensor),
        GyroBias(node + 1, sensor), Constant(UnknownKind::kGyroScale, sensor),
        Constant(UnknownKind::kAccelBias, sensor), Constant(UnknownKind::kAccelScale, sensor),
        Constant(UnknownKind::kClockOffset, sensor)},
       ResidualKind::kAccelerometer,
       sensor,
       knot,
       knot + 1});
}

double ArmProblem::KnotSpan(int knot) const {
  const auto& knots = timeline_.knots;
  const int before = std::max(knot - 1, 0), after = std::min(knot + 1, timeline_.Intervals());
  return 0.5 * (knots[U(after)] - knots[U(before)]);
}

std::unique_ptr<TangentCost> ArmProblem::MakeChain(int knot, int sensor) const {
  const double sigma = unmodelled_[U(sensor)].quiver *
                       std::sqrt(2 * options_.unmodelled_correlation_s / KnotSpan(knot));
  const auto make = [&]() -> TangentCost* {
    switch (Chain(sensor).size()) {
      case 1:
        return MakeCost(AsMounted(SegmentChain<1>(sigma)));
      case 2:
        return MakeCost(AsMounted(SegmentChain<2>(sigma)));
      case 3:
        return MakeCost(AsMounted(SegmentChain<3>(sigma)));
      default:
        return MakeCost(AsMounted(SegmentChain<4>(sigma)));
    }
  };
  return std::unique_ptr<TangentCost>(make());
}

std::vector<int> ArmProblem::OfSegments(int knot, const std::vector<int>& sensors,
                                        const std::vector<int>& others) const {
  std::vector<int> unknowns;
  for (const int sensor : sensors) unknowns.push_back(Attitude(knot, sensor));
  unknowns.insert(unknowns.end(), others.begin(), others.end());
  for (const int sensor : sensors) unknowns.push_back(Constant(UnknownKind::kMounting, sensor));
  for (const int sensor : sensors) unknowns.push_back(Skin(knot, sensor));
  return unknowns;
}

void ArmProblem::AddChain(int knot, int sensor) {
  const std::vector<int> chain = Chain(sensor);
  std::vector<int> others{Root(knot, RootOf(sensor)), Place(knot, sensor),
                          Constant(UnknownKind::kSensorPosition, sensor)};
  for (const int link : chain)
    if (link != sensor) others.push_back(Constant(UnknownKind::kJointVector, link));
  terms_.push_back({MakeChain(knot, sensor), OfSegments(knot, chain, others),
                    ResidualKind::kSegmentChain, sensor, knot, knot});
}

void ArmProblem::AddSkin(int sensor) {
  if (options_.soft_tissue_deg == 0.0) return;
  const double sigma = options_.soft_tissue_deg * kDegree;
  for (int knot = 0; knot < size_.knots; ++knot) {
    if (knot == 0)
      Add(SkinStart(sigma), ResidualKind::kSkinProcess, {Skin(0, sensor)}, sensor, 0, 0);
    else
      Add(SkinProcess(FirstOrderStep::Over(timeline_.knots[U(knot)] - timeline_.knots[U(knot) - 1],
                                           sigma, options_.soft_tissue_correlation_s)),
          ResidualKind::kSkinProcess, {Skin(knot - 1, sensor), Skin(knot, sensor)}, sensor,
          knot - 1, knot);
  }
}

void ArmProblem::AddElbow() {
  const int upper = SensorOn(Segment::kUpperArm), fore = SensorOn(Segment::kForearm);
  const int carrying = Constant(UnknownKind::kCarryingAngle, -1);
  if (carrying < 0) return;
  const Side side = observations_.arm.side;
  const double sigma = options_.elbow_adduction_sigma_deg * kDegree;
  const double stop = options_.range_of_motion_sigma_deg * kDegree;
  const double wobble = std::sqrt(2 * options_.elbow_wobble_correlation_s) *
                        options_.elbow_wobble_sigma_deg * kDegree;
  Add(Prior<1>(Scalar::Zero(), Scalar(sigma)), ResidualKind::kAdductionProcess, {Adduction(0)}, -1,
      0, 0);
  for (int knot = 0; knot < size_.knots; ++knot) {
    Add(AsMounted(ElbowRangeOfMotion(kFlexionLimits[0], kFlexionLimits[1], stop)),
        ResidualKind::kRangeOfMotion, OfSegments(knot, {upper, fore}, {}), -1, knot, knot);
    const int before = std::max(knot, 1) - 1;
    const double step = timeline_.knots[U(before) + 1] - timeline_.knots[U(before)];
    Add(AsMounted(ElbowAdduction(side, wobble / std::sqrt(step))), ResidualKind::kElbowAdduction,
        OfSegments(knot, {upper, fore}, {carrying, Adduction(knot)}), -1, knot, knot);
    if (knot > 0)
      Add(AdductionProcess(
              FirstOrderStep::Over(step, sigma, options_.elbow_adduction_correlation_s)),
          ResidualKind::kAdductionProcess, {Adduction(before), Adduction(knot)}, -1, before, knot);
  }
}

void ArmProblem::AddShoulder() {
  if (size_.sensors == 1) return;
  ShoulderModel shoulder = observations_.arm.shoulder;
  if (observations_.recordings[U(FirstOfArm())].segment > Segment::kUpperArm)
    shoulder.sigma = std::hypot(shoulder.sigma, kElbowSwing);
  const Vector3d p_shoulder_T =
      has_thorax_ ? observations_.arm.segments.at(Segment::kThorax).p_distal_B : Vector3d::Zero();
  const int mean = Constant(UnknownKind::kShoulderMean, -1);
  for (int knot = 0; knot < size_.knots; ++knot) {
    const auto step =
        knot == 0 ? FirstOrderStep::Start(shoulder.sigma)
                  : FirstOrderStep::Over(timeline_.knots[U(knot)] - timeline_.knots[U(knot) - 1],
                                         shoulder.sigma, shoulder.correlation_time);
    if (has_thorax_ && knot == 0)
      Add(ThoraxShoulderStart(p_shoulder_T, shoulder.sigma), ResidualKind::kShoulderProcess,
          {Attitude(0, 0), Root(0, 0), Root(0, 1)}, -1, 0, 0);
    else if (has_thorax_)
      Add(ThoraxShoulder(p_shoulder_T, step), ResidualKind::kShoulderProcess,
          {Attitude(knot - 1, 0), Root(knot - 1, 0), Root(knot - 1, 1), Attitude(knot, 0),
           Root(knot, 0), Root(knot, 1)},
          -1, knot - 1, knot);
    else if (knot == 0)
      Add(InBodyAxes(ShoulderProcessStart(shoulder.sigma)), ResidualKind::kShoulderProcess,
          {Attitude(0, 0), Root(0, 0), mean}, -1, 0, 0);
    else
      Add(InBodyAxes(ShoulderProcess(step)), ResidualKind::kShoulderProcess,
          {Attitude(knot, 0), Root(knot - 1, 0), Root(knot, 0), mean}, -1, knot - 1, knot);
  }
}

void ArmProblem::AddRests(int sensor) {
  const Recording& recording = observations_.recordings[U(sensor)];
  const double behind = Interval(0, sensor).clock_offset;
  for (const RestInterval& rest : rests_[U(sensor)]) {
    const double rest_start = rest.start + behind, rest_end = rest.end + behind;
    if (rest_end < timeline_.knots.front()) continue;
    // What rocks faster rocks for a shorter time: the way it goes stays the same.
    const double sigma = options_.zero_velocity_sigma_m_s * rest.slack,
                 correlation = options_.zero_velocity_correlation_s / rest.slack;
    const int first = timeline_.KnotBefore(rest_start), last = timeline_.KnotBefore(rest_end);
    for (int knot = first; knot <= last; ++knot) {
      if (timeline_.knots[U(knot)] < rest_start) continue;
      if (knot == 0 || timeline_.knots[U(knot) - 1] < rest_start)
        Add(InBodyAxes(ZeroVelocityStart(sigma, rest.probability)), ResidualKind::kZeroVelocity,
            {Attitude(knot, sensor), Velocity(knot, sensor)}, sensor, knot, knot);
      else
        Add(InBodyAxes(ZeroVelocity(
                FirstOrderStep::Over(timeline_.knots[U(knot)] - timeline_.knots[U(knot) - 1], sigma,
                                     correlation),
                rest.probability)),
            ResidualKind::kZeroVelocity,
            {Attitude(knot, sensor), Velocity(knot - 1, sensor), Velocity(knot, sensor)}, sensor,
            knot - 1, knot);
    }
    if (rest.slack > 1.0) continue;  // a rocking sensor's mean rate is not its bias
    for (int node = timeline_.NodeBefore(rest_start); node + 1 < size_.nodes; ++node) {
      const double begin = timeline_.NodeTime(node), end = timeline_.NodeTime(node + 1);
      if (begin >= rest_end) break;
      const RestInterval part = PartOfRest(recording, rest, begin - behind, end - behind);
      if (part.probability <= 0.0 || part.end <= part.start) continue;
      const double T = part.end - part.start;
      const double sway = std::max(part.sway, options_.rest_sway_deg * kDegree);
      const double variance = 0.5 * Square(recording.noise.gyro_density) / T + 2 * Square(sway / T);
      const double middle = 0.5 * (part.start + part.end) + behind;
      const int knot = timeline_.KnotBefore(middle);
      Add(GyroBiasRest(part.mean_rate, timeline_.NodeFraction(middle), std::sqrt(variance),
                       part.probability),
          ResidualKind::kGyroBiasRest, {GyroBias(node, sensor), GyroBias(node + 1, sensor)}, sensor,
          knot, knot);
    }
  }
}

void ArmProblem::AddBiasWalk(int sensor) {
  const ImuNoise& noise = observations_.recordings[U(sensor)].noise;
  Add(Prior<3>(Vector3d::Zero(), Vector3d::Constant(noise.gyro_bias_sigma)), ResidualKind::kPrior,
      {GyroBias(0, sensor)}, sensor, 0, 0);
  for (int node = 0; node + 1 < size_.nodes; ++node)
    Add(GyroBiasWalk(noise.gyro_bias_walk, timeline_.NodeTime(node + 1) - timeline_.NodeTime(node)),
        ResidualKind::kGyroBiasWalk, {GyroBias(node, sensor), GyroBias(node + 1, sensor)}, sensor,
        timeline_.nodes[U(node)], timeline_.nodes[U(node)]);
}

void ArmProblem::AddStart() {
  Add(Prior<3>(Vector3d::Zero(), Vector3d::Constant(kGaugeSigma)), ResidualKind::kPlaceGauge,
      {Root(0, 0)}, -1, 0, 0);
  for (int sensor = 0; sensor < size_.sensors; ++sensor)
    Add(InBodyAxes(Prior<3>(Vector3d::Zero(), Vector3d::Constant(kStartVelocitySigma))),
        ResidualKind::kPrior, {Attitude(0, sensor), Velocity(0, sensor)}, sensor, 0, 0);
}

}  // namespace brachium
