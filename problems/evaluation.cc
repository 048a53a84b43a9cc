#include "problems/evaluation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/rotation.h"
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

Compared Compare(const Estimate& estimate, const Reference& reference,
                 const std::vector<double>& at) {
  const SampleTimes times(estimate.time);
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

std::vector<double> AnglesBetween(const std::vector<Quaterniond>& estimate,
                                  const std::vector<Quaterniond>& reference) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < estimate.size(); ++i)
    angles.push_back(Log(reference[i].conjugate() * estimate[i]).norm());
  return angles;
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
    const RotationAlignment alignment = AlignBothSides(pairs);
    const bool raw = evaluation->frames == Reference::Frames::kSegment;
    evaluation->relative.push_back(
        {.name = std::string(Name(distal->first)) + "_in_" + std::string(Name(proximal->first)),
         .orientation = EvaluateRotation(pairs, alignment, VerticalIn(distal->second.reference)),
         .angle = AnglesBetween(raw ? pairs.estimate : alignment.Apply(pairs.estimate),
                                pairs.reference)});
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

std::vector<double> DistancesBetween(const Matrix3Xd& estimate, const Matrix3Xd& reference) {
  Matrix3Xd error = estimate - reference;
  if (!error.row(2).array().isFinite().any()) error.row(2).setZero();
  const Eigen::RowVectorXd distances = error.colwise().norm();
  return {distances.begin(), distances.end()};
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
                                   .closing_horizontal = ends.closing,
                                   .distance = DistancesBetween(aligned, pairs.reference)};
  }
}

// Those of a map that another one has too.
template <typename Map>
Map Common(const Map& map, const Map& other) {
  Map common;
  for (const auto& [key, value] : map)
    if (other.contains(key)) common.emplace(key, value);
  return common;
}

// Without heights where the reference knows none, so that both are looked at in the plane.
void LeaveOutUnknownHeights(std::map<std::string, std::vector<Vector3d>>* reference,
                            std::map<std::string, std::vector<Vector3d>>* estimate) {
  for (auto& [name, points] : *reference) {
    if (std::any_of(points.begin(), points.end(),
                    [](const Vector3d& p) { return std::isfinite(p.z()); }))
      continue;
    for (Vector3d& p : points) p.z() = 0.0;
    for (Vector3d& p : estimate->at(name)) p.z() = 0.0;
  }
}

void EvaluateOutcomes(const Estimate& estimate, const Reference& reference,
                      Evaluation* evaluation) {
  std::map<Segment, std::vector<Quaterniond>> q_WB, q_VB;
  if (reference.frames == Reference::Frames::kSegment) {
    q_WB = Common(estimate.q_WB, reference.q_VB);
    q_VB = Common(reference.q_VB, estimate.q_WB);
  }
  auto p_W = Common(estimate.p_W, reference.p_V), p_V = Common(reference.p_V, estimate.p_W);
  LeaveOutUnknownHeights(&p_V, &p_W);
  evaluation->outcomes = OutcomesOf(estimate.side, estimate.time, q_WB, p_W);
  evaluation->reference_outcomes = OutcomesOf(estimate.side, evaluation->time, q_VB, p_V);
}

}  // namespace

Evaluation Evaluate(const Estimate& estimate, const Reference& reference) {
  Evaluation evaluation;
  evaluation.method = estimate.method;
  evaluation.frames = reference.frames;
  evaluation.clock_offset = ClockOffsetOf(estimate, reference);
  evaluation.reference_samples = reference.time.size();
  evaluation.time = reference.time;
  for (double& t : evaluation.time) t -= evaluation.clock_offset.seconds;
  const Compared compared = Compare(estimate, reference, evaluation.time);
  evaluation.used = compared.CountUsed(reference.time.size());

  EvaluateOrientations(compared.rotations, &evaluation);
  EvaluateRelative(compared.rotations, &evaluation);
  if (reference.frames == Reference::Frames::kSegment)
    evaluation.joint_angles = JointAngleErrors(compared.rotations, estimate.side);
  EvaluatePositions(compared.points, SampleTimes(reference.time), &evaluation);
  EvaluateOutcomes(estimate, reference, &evaluation);
  return evaluation;
}

}  // namespace brachium
