// The terms of what the person was asked to do: poses that were held, places that were touched.
#include <algorithm>

#include "problems/arm_problem.h"
#include "problems/residuals/as_mounted.h"
#include "problems/residuals/contact.h"
#include "problems/residuals/held_pose.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kHanging =
    30 * kDegree;  // a told elevation up to here leaves the elbow facing forward,
constexpr double kFacingSigma = 20 * kDegree;  // as people's do

template <template <int> class OnChain>
TangentCost* MakeOnChain(std::size_t links, double sigma) {
  switch (links) {
    case 1:
      return MakeCost(AsMounted(OnChain<1>(sigma)));
    case 2:
      return MakeCost(AsMounted(OnChain<2>(sigma)));
    case 3:
      return MakeCost(AsMounted(OnChain<3>(sigma)));
    default:
      return MakeCost(AsMounted(OnChain<4>(sigma)));
  }
}

}  // namespace

void ArmProblem::AddHeldPose(const HeldPose& pose, ResidualKind kind) {
  const int upper = SensorOn(Segment::kUpperArm), fore = SensorOn(Segment::kForearm);
  const int knot = timeline_.KnotBefore(pose.time);
  const Side side = observations_.arm.side;
  const auto add = [&](auto residual, const std::vector<int>& sensors) {
    terms_.push_back({std::unique_ptr<TangentCost>(MakeCost(AsMounted(std::move(residual)))),
                      OfSegments(knot, sensors, {}), kind, -1, knot, knot});
  };
  if (upper < 0) return;
  if (pose.shoulder_elevation)
    add(ElevationHeldPose(*pose.shoulder_elevation, pose.sigma), {upper});
  if (pose.shoulder_elevation && *pose.shoulder_elevation < kHanging && upper > 0)
    add(FacingHeldPose(kFacingSigma), {upper - 1, upper});
  if (fore < 0) return;
  if (pose.elbow_flexion)
    add(ElbowHeldPose(ElbowAngle::kFlexion, side, *pose.elbow_flexion, pose.sigma), {upper, fore});
  if (pose.forearm_pronation)
    add(ElbowHeldPose(ElbowAngle::kPronation, side, *pose.forearm_pronation, pose.sigma),
        {upper, fore});
}

bool ArmProblem::IsTouching(Segment segment) const {
  return std::ranges::any_of(observations_.contacts,
                             [&](const Contact& contact) { return contact.segment == segment; });
}

int ArmProblem::PlaceOf(int contact) const {
  const bool is_height = observations_.contacts[static_cast<std::size_t>(contact)].height_only;
  return Constant(is_height ? UnknownKind::kContactHeight : UnknownKind::kContactPlace, contact);
}

std::vector<int> ArmProblem::Touches(int contact) const {
  std::vector<int> knots;
  for (const double time : observations_.contacts[static_cast<std::size_t>(contact)].times)
    knots.push_back(timeline_.KnotNearest(time));
  std::ranges::sort(knots);
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

Vector3d ArmProblem::TouchingPoint(const State& state, int contact, int knot) const {
  using Vector = Eigen::Map<const Vector3d>;
  const int sensor = SensorOn(observations_.contacts[static_cast<std::size_t>(contact)].segment);
  return PlaceOnChain(state, knot, sensor) +
         SegmentAttitude(state, knot, sensor) *
             (Vector(state.Constant(UnknownKind::kJointVector, sensor)) -
              Vector(state.Constant(UnknownKind::kSensorPosition, sensor)));
}

void ArmProblem::AddContact(int contact) {
  const auto& [place, segment, times, sigma, height_only] =
      observations_.contacts[static_cast<std::size_t>(contact)];
  const int sensor = SensorOn(segment);
  const std::vector<int> chain = Chain(sensor);
  for (const int knot : Touches(contact)) {
    std::vector<int> others{Root(knot, RootOf(sensor)), PlaceOf(contact)};
    if (!height_only) others.push_back(Constant(UnknownKind::kJointVector, sensor));
    for (const int link : chain)
      if (height_only || link != sensor)
        others.push_back(Constant(UnknownKind::kJointVector, link));
    terms_.push_back(
        {std::unique_ptr<TangentCost>(height_only ? MakeOnChain<ContactHeight>(chain.size(), sigma)
                                                  : MakeOnChain<ContactPlace>(chain.size(), sigma)),
         OfSegments(knot, chain, others), ResidualKind::kContact, -1, knot, knot});
  }
}

}  // namespace brachium
