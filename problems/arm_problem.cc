#include "problems/arm_problem.h"

#include <algorithm>
#include <cmath>

#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

std::size_t U(int i) { return static_cast<std::size_t>(i); }

}  // namespace

std::string_view Name(ResidualKind kind) {
  switch (kind) {
    case ResidualKind::kGyroscope:
      return "gyroscope";
    case ResidualKind::kAccelerometer:
      return "accelerometer";
    case ResidualKind::kSegmentChain:
      return "segment_chain";
    case ResidualKind::kElbowAdduction:
      return "elbow_adduction";
    case ResidualKind::kAdductionProcess:
      return "adduction_process";
    case ResidualKind::kSkinProcess:
      return "skin_process";
    case ResidualKind::kShoulderProcess:
      return "shoulder_process";
    case ResidualKind::kZeroVelocity:
      return "zero_velocity";
    case ResidualKind::kGyroBiasRest:
      return "gyro_bias_rest";
    case ResidualKind::kGyroBiasWalk:
      return "gyro_bias_walk";
    case ResidualKind::kStartPose:
      return "start_pose";
    case ResidualKind::kEndPose:
      return "end_pose";
    case ResidualKind::kContact:
      return "contact";
    case ResidualKind::kRangeOfMotion:
      return "range_of_motion";
    case ResidualKind::kPrior:
      return "prior";
    case ResidualKind::kSegmentLength:
      return "segment_length";
    case ResidualKind::kPlaceGauge:
      return "place_gauge";
    case ResidualKind::kHeadingGauge:
      return "heading_gauge";
    case ResidualKind::kStartHeading:
      return "start_heading";
    case ResidualKind::kMarginalPrior:
      return "marginal_prior";
  }
  return "";
}

int Unknown::Size() const {
  if (kind == UnknownKind::kAttitude) return 4;
  if (kind == UnknownKind::kAdduction || kind == UnknownKind::kClockOffset ||
      kind == UnknownKind::kContactHeight)
    return 1;
  return kind == UnknownKind::kCarryingAngle ? 2 : 3;
}

ArmProblem::ArmProblem(Observations observations, const ModelOptions& options, double knot_spacing,
                       std::optional<Segment> clock, Stretch stretch)
    : observations_(std::move(observations)),
      options_(options),
      stretch_(std::move(stretch)),
      clock_sensor_(clock ? SensorOn(*clock) : 0) {
  for (const Recording& recording : observations_.recordings) {
    preintegrators_.emplace_back(recording);
    rests_.push_back(DetectRests(recording, {}));
  }
  timeline_ = MakeTimeline(preintegrators_, knot_spacing, options.bias_node_spacing_s, stretch_);
  const int sensors = static_cast<int>(observations_.recordings.size());
  has_thorax_ = observations_.recordings[0].segment == Segment::kThorax;
  size_ = {sensors, has_thorax_ && sensors > 1 ? 2 : 1, static_cast<int>(timeline_.knots.size()),
           static_cast<int>(timeline_.nodes.size()),
           static_cast<int>(observations_.contacts.size())};
  per_knot_ = 4 * sensors + size_.roots + 1;  // and the elbow's deviation
  first_node_ = per_knot_ * size_.knots;
  first_constant_ = first_node_ + sensors * size_.nodes;
  unmodelled_.assign(U(sensors), {options.unmodelled_acceleration, options.unmodelled_quiver});

  terms_.reserve(U(size_.knots * (5 * sensors + 4)));  // what there may be at a knot
  AddConstants();
  const State prior = PriorState();
  intervals_.reserve(U(timeline_.Intervals() * sensors));
  for (int knot = 0; knot < timeline_.Intervals(); ++knot)
    for (int sensor = 0; sensor < sensors; ++sensor) {
      intervals_.push_back(SumInterval(prior, knot, sensor, stretch_.ClockOffset(U(sensor))));
      AddGyroscope(knot, sensor);
      AddAccelerometer(knot, sensor);
    }
  for (int knot = 0; knot < size_.knots; ++knot)
    for (int sensor = 0; sensor < sensors; ++sensor) AddChain(knot, sensor);
  for (int sensor = 0; sensor < sensors; ++sensor) AddSkin(sensor);
  AddElbow();
  AddShoulder();
  for (int sensor = 0; sensor < sensors; ++sensor) {
    AddRests(sensor);
    AddBiasWalk(sensor);
  }
  AddStart();
  if (observations_.start_pose) AddHeldPose(*observations_.start_pose, ResidualKind::kStartPose);
  if (observations_.end_pose) AddHeldPose(*observations_.end_pose, ResidualKind::kEndPose);
  for (int contact = 0; contact < size_.contacts; ++contact) AddContact(contact);
  if (stretch_.start) DropStart();
  SortTerms();
}

Preintegrated ArmProblem::SumInterval(const State& state, int knot, int sensor,
                                      double clock_offset) const {
  const double start = timeline_.knots[U(knot)], end = timeline_.knots[U(knot) + 1];
  const Eigen::Map<const Vector3d> bias(state.GyroBias(timeline_.NodeBefore(start), sensor));
  return Samples(sensor).Sum(start, end, bias, clock_offset);
}

void ArmProblem::SumAgain(const State& state, const std::vector<double>& clock_offsets) {
  for (int knot = 0; knot < timeline_.Intervals(); ++knot)
    for (int sensor = 0; sensor < size_.sensors; ++sensor)
      intervals_[U(knot * size_.sensors + sensor)] =
          SumInterval(state, knot, sensor, clock_offsets[U(sensor)]);
  for (Term& term : terms_) {
    if (term.kind == ResidualKind::kGyroscope)
      term.cost = MakeGyroscope(term.first_knot, term.sensor);
    if (term.kind == ResidualKind::kAccelerometer)
      term.cost = MakeAccelerometer(term.first_knot, term.sensor);
  }
  std::erase_if(terms_, [](const Term& term) {
    return term.kind == ResidualKind::kZeroVelocity || term.kind == ResidualKind::kGyroBiasRest;
  });
  for (int sensor = 0; sensor < size_.sensors; ++sensor) AddRests(sensor);
  SortTerms();
  if (stretch_.start) DropStart();
}

// In the order in which knots are eliminated.
void ArmProblem::SortTerms() {
  std::stable_sort(terms_.begin(), terms_.end(),
                   [](const Term& a, const Term& b) { return a.first_knot < b.first_knot; });
}

// A rest that covers the first knot began before it.
void ArmProblem::DropStart() {
  std::erase_if(terms_, [](const Term& term) {
    using enum ResidualKind;
    const bool of_a_start = term.kind == kPrior || term.kind == kSegmentLength ||
                            term.kind == kPlaceGauge || term.kind == kAdductionProcess ||
                            term.kind == kSkinProcess || term.kind == kShoulderProcess ||
                            term.kind == kZeroVelocity;
    return of_a_start && term.last_knot == 0;
  });
}

Unknown ArmProblem::Describe(int unknown) const {
  if (unknown >= first_constant_) return constants_[U(unknown - first_constant_)];
  if (unknown >= first_node_)
    return {UnknownKind::kGyroBias, (unknown - first_node_) / size_.sensors,
            (unknown - first_node_) % size_.sensors};
  const int knot = unknown / per_knot_, rest = unknown % per_knot_;
  if (rest == per_knot_ - 1) return {UnknownKind::kAdduction, knot, -1};
  if (rest < size_.sensors) return {UnknownKind::kAttitude, knot, rest};
  if (rest < size_.sensors + size_.roots) return {UnknownKind::kRoot, knot, rest - size_.sensors};
  const int motion = rest - size_.sensors - size_.roots;
  if (motion < size_.sensors) return {UnknownKind::kVelocity, knot, motion};
  if (motion < 2 * size_.sensors) return {UnknownKind::kPlace, knot, motion - size_.sensors};
  return {UnknownKind::kSkin, knot, motion - 2 * size_.sensors, options_.soft_tissue_deg == 0.0};
}

double* ArmProblem::Value(State& state, int unknown) const {
  const Unknown u = Describe(unknown);
  switch (u.kind) {
    case UnknownKind::kAttitude:
      return state.Attitude(u.place, u.sensor);
    case UnknownKind::kRoot:
      return state.Root(u.place, u.sensor);
    case UnknownKind::kVelocity:
      return state.Velocity(u.place, u.sensor);
    case UnknownKind::kPlace:
      return state.Place(u.place, u.sensor);
    case UnknownKind::kSkin:
      return state.Skin(u.place, u.sensor);
    case UnknownKind::kAdduction:
      return state.Adduction(u.place);
    case UnknownKind::kGyroBias:
      return state.GyroBias(u.place, u.sensor);
    default:
      return state.Constant(u.kind, u.sensor);
  }
}

int ArmProblem::Constant(UnknownKind kind, int sensor) const {
  for (std::size_t i = 0; i < constants_.size(); ++i)
    if (constants_[i].kind == kind && constants_[i].sensor == sensor)
      return first_constant_ + static_cast<int>(i);
  return -1;
}

std::vector<int> ArmProblem::Chain(int sensor) const {
  std::vector<int> chain;
  const int first = has_thorax_ && sensor == 0 ? 0 : FirstOfArm();
  for (int i = first; i <= sensor; ++i) chain.push_back(i);
  return chain;
}

Vector3d ArmProblem::PlaceOnChain(const State& state, int knot, int sensor) const {
  using Vector = Eigen::Map<const Vector3d>;
  Vector3d p_W = Vector(state.Root(knot, RootOf(sensor)));
  for (const int link : Chain(sensor)) {
    const UnknownKind lever =
        link == sensor ? UnknownKind::kSensorPosition : UnknownKind::kJointVector;
    p_W += SegmentAttitude(state, knot, link) * Vector(state.Constant(lever, link));
  }
  return p_W;
}

Eigen::Quaterniond ArmProblem::SegmentAttitude(const State& state, int knot, int sensor) const {
  using Vector = Eigen::Map<const Vector3d>;
  const Vector3d turn =
      Vector(state.Constant(UnknownKind::kMounting, sensor)) + Vector(state.Skin(knot, sensor));
  return Eigen::Map<const Eigen::Quaterniond>(state.Attitude(knot, sensor)) * Exp<double>(-turn);
}

int ArmProblem::SensorOn(Segment segment) const {
  for (std::size_t i = 0; i < observations_.recordings.size(); ++i)
    if (observations_.recordings[i].segment == segment) return static_cast<int>(i);
  return -1;
}

bool ArmProblem::HasElbow() const {
  return SensorOn(Segment::kForearm) > 0 && SensorOn(Segment::kUpperArm) >= 0 &&
         observations_.arm.elbow.adduction_constraint;
}

// Skin that turns sensors to and fro cannot be told from a mounting.
bool ArmProblem::ShowsMounting(int sensor) const {
  const Segment segment = observations_.recordings[U(sensor)].segment;
  const bool at_elbow = segment == Segment::kUpperArm || segment == Segment::kForearm;
  return options_.estimate_mountings && at_elbow && HasElbow() && options_.soft_tissue_deg == 0.0;
}

double ArmProblem::UntestedMountingSigma(int sensor) const {
  const auto& mounting = observations_.recordings[U(sensor)].mounting;
  const bool held = Describe(Constant(UnknownKind::kMounting, sensor)).held;
  return mounting && options_.estimate_mountings && held ? mounting->q_sigma : 0.0;
}

void ArmProblem::HoldMountings(State& state) {
  for (Unknown& constant : constants_) {
    if (constant.kind != UnknownKind::kMounting) continue;
    constant.held = true;
    std::fill_n(state.Constant(constant.kind, constant.sensor), 3, 0.0);
  }
}

Vector3d ArmProblem::BiasFromRests(int sensor) const {
  Vector3d bias = Vector3d::Zero();
  double weight = 0.0;
  for (const RestInterval& rest : rests_[U(sensor)]) {
    if (rest.slack > 1.0) continue;
    const double length = rest.probability * (rest.end - rest.start);
    bias += length * rest.mean_rate;
    weight += length;
  }
  if (weight > 0.0) bias /= weight;
  return bias;
}

State ArmProblem::PriorState() const {
  State state(size_);
  const auto set = [](double* x, const Vector3d& value) { Eigen::Map<Vector3d>{x} = value; };
  for (int sensor = 0; sensor < size_.sensors; ++sensor) {
    const Recording& recording = observations_.recordings[U(sensor)];
    if (size_.sensors > 1)
      set(state.Constant(UnknownKind::kSensorPosition, sensor), recording.mounting->p_BS_B);
    const auto geometry = observations_.arm.segments.find(recording.segment);
    if (geometry != observations_.arm.segments.end())
      set(state.Constant(UnknownKind::kJointVector, sensor), geometry->second.p_distal_B);
    const Vector3d bias =
        stretch_.gyro_bias.empty() ? BiasFromRests(sensor) : stretch_.gyro_bias[U(sensor)];
    for (int node = 0; node < size_.nodes; ++node) set(state.GyroBias(node, sensor), bias);
    *state.Constant(UnknownKind::kClockOffset, sensor) = stretch_.ClockOffset(U(sensor));
  }
  state.Constant(UnknownKind::kCarryingAngle, -1)[0] = observations_.arm.elbow.carrying_angle;
  return state;
}

}  // namespace brachium
