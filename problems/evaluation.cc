#include "problems/evaluation.h"

#include <algorithm>
#include <utility>

#include "problems/joint_angle_errors.h"
#include "problems/sampling.h"

namespace brachium {
namespace {

using Eigen::Matrix3Xd, Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kNaN = Statistics::kUnknown;

RotationPairs PairsOf(std::vector<Quaterniond> estimate, std::vector<Quaterniond> reference) {
  const Quaterniond absent(kNaN, kNaN, kNaN, kNaN);
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    if (estimate[i].coeffs().allFinite() && reference[i].coeffs().allFinite())
      reference[i].normalize();
    else
      estimate[i] = reference[i] = absent;
  }
  return {.estimate = std::move(estimate), .reference = std::move(reference)};
}

PointPairs PairsOf(const std::vector<Vector3d>& estimate, const std::vector<Vector3d>& reference) {
  const auto n = static_cast<Eigen::Index>(estimate.size());
  PointPairs pairs{.estimate = Matrix3Xd(3, n), .reference = Matrix3Xd(3, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Vector3d known = 0.0 * (estimate[k] + reference[k]);  // 0, or NaN where either is
    pairs.estimate.col(i) = estimate[k] + known;
    pairs.reference.col(i) = reference[k] + known;
    if (!known.head<2>().allFinite()) {
      pairs.estimate.col(i).setConstant(kNaN);
      pairs.reference.col(i).setConstant(kNaN);
    }
  }
  return pairs;
}

// Both series at the reference's instants, of whatever both of them hold.
struct Compared {
  std::map<Segment, RotationPairs> rotations;
  std::map<std::string, PointPairs> points;

  std::size_t CountUsed(std::size_t instants) const {
    std::size_t used = 0;
    for (std::size_t i = 0; i < instants; ++i)
      used += std::any_of(rotations.begin(), rotations.end(),
                          [i](const auto& item) { return item.second.Known(i); }) ||
              std::any_of(points.begin(), points.end(), [i](const auto& item) {
                return item.second.estimate.col(static_cast<Eigen::Index>(i)).head(2).allFinite();
              });
    return used;
  }
};

Compared Compare(const Estimate& estimate, const Reference& reference, double clock_offset) {
  const SampleTimes times(estimate.time);
  std::vector<double> at = reference.time;
  for (double& t : at) t -= clock_offset;
  Compared compared;
  for (const auto& [segment, q_VB] : reference.q_VB)
    if (const auto found = estimate.q_WB.find(segment); found != estimate.q_WB.end())
      compared.rotations[segment] = PairsOf(Interpolate(times, found->second, at), q_VB);
  for (const auto& [name, p_V] : reference.p_V)
    if (const auto found = estimate.p_W.find(name); found != estimate.p_W.end())
      compared.points[name] = PairsOf(Interpolate(times, found->second, at), p_V);
  return compared;
}

OrientationEvaluation EvaluateRotation(const RotationPairs& pairs,
                                       const RotationAlignment& alignment,
                                       const std::vector<Vector3d>& vertical) {
  return {
      .raw = OrientationErrorsOf(pairs.estimate, pairs.reference, vertical),
      .aligned = OrientationErrorsOf(alignment.Apply(pairs.estimate), pairs.reference, vertical),
      .alignment = alignment};
}

std::vector<Vector3d> VerticalIn(const std::vector<Quaterniond>& q_VB) {
  std::vector<Vector3d> vertical;
  for (const Quaterniond& q : q_VB) vertical.push_back(q.conjugate() * Vector3d::UnitZ());
  return vertical;
}

void EvaluateOrientations(const std::map<Segment, RotationPairs>& rotations,
                          Evaluation* evaluation) {
  std::vector<RotationPairs> all;
  for (const auto& [segment, pairs] : rotations) all.push_back(pairs);
  const std::vector<RotationAlignment> alignments =
      AlignHeading(all, evaluation->frames == Reference::Frames::kCluster);
  std::size_t i = 0;
  for (const auto& [segment, pairs] : rotations) {
    evaluation->orientation[segment] =
        EvaluateRotation(pairs, alignments[i], VerticalIn(pairs.reference));
    evaluation->heading = HeadingOf(alignments[i++].proximal);
  }
}

void EvaluateRelative(const std::map<Segment, RotationPairs>& rotations, Evaluation* evaluation) {
  for (auto distal = rotations.begin(); distal != rotations.end(); ++distal) {
    if (distal == rotations.begin()) continue;
    const auto proximal = std::prev(distal);
    const RotationPairs pairs = RelativeOf(proximal->second, distal->second);
    evaluation->relative.push_back(
        {.name = std::string(Name(distal->first)) + "_in_" + std::string(Name(proximal->first)),
         .orientation =
             EvaluateRotation(pairs, AlignBothSides(pairs), VerticalIn(distal->second.reference))});
  }
}

struct HorizontalEnds {
  double last = kNaN;     // error at the last instant
  double closing = kNaN;  // error of the way from the first instant to the last
};

HorizontalEnds EndsOf(const Matrix3Xd& estimate, const Matrix3Xd& reference) {
  HorizontalEnds ends;
  std::optional<Eigen::Vector2d> first;
  for (Eigen::Index i = 0; i < estimate.cols(); ++i) {
    const Eigen::Vector2d error = (estimate.col(i) - reference.col(i)).head<2>();
    if (!error.allFinite()) continue;
    if (!first) first = error;
    ends = {.last = error.norm(), .closing = (error - *first).norm()};
  }
  return ends;
}

void EvaluatePositions(const std::map<std::string, PointPairs>& points, const SampleTimes& times,
                       Evaluation* evaluation) {
  std::vector<PointPairs> all;
  for (const auto& [name, pairs] : points) all.push_back(pairs);
  evaluation->point_alignment = AlignPoints(all);
  for (const auto& [name, pairs] : points) {
    const Matrix3Xd aligned = evaluation->point_alignment.Apply(pairs.estimate);
    const HorizontalEnds ends = EndsOf(aligned, pairs.reference);
    evaluation->positions[name] = {.raw = PositionErrorsOf(pairs.estimate, pairs.reference),
                                   .aligned = PositionErrorsOf(aligned, pairs.reference),
                                   .path_length = PathLength(times, pairs.reference),
                                   .final_horizontal = ends.last,
                                   .closing_horizontal = ends.closing};
  }
}

}  // namespace

Evaluation Evaluate(const Estimate& estimate, const Reference& reference) {
  Evaluation evaluation;
  evaluation.method = estimate.method;
  evaluation.frames = reference.frames;
  evaluation.clock_offset = ClockOffsetOf(estimate, reference);
  evaluation.reference_samples = reference.time.size();
  const Compared compared = Compare(estimate, reference, evaluation.clock_offset.seconds);
  evaluation.used = compared.CountUsed(reference.time.size());

  EvaluateOrientations(compared.rotations, &evaluation);
  EvaluateRelative(compared.rotations, &evaluation);
  if (reference.frames == Reference::Frames::kSegment)
    evaluation.joint_angles = JointAngleErrors(compared.rotations, estimate.side);
  EvaluatePositions(compared.points, SampleTimes(reference.time), &evaluation);
  return evaluation;
}

}  // namespace brachium
