#include "bin/experiments/points.h"

#include "problems/arm_angles.h"
#include "problems/rigid_alignment.h"
#include "problems/sampling.h"

namespace brachium {
namespace {

Eigen::Matrix3Xd Columns(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    columns.col(static_cast<Eigen::Index>(i)) = points[i];
  return columns;
}

PointSeries PointsOf(const Estimate& estimate, const Reference& reference,
                     const std::string& joint) {
  return {.time = reference.time,
          .estimate = Columns(
              Interpolate(SampleTimes(estimate.time), estimate.p_W.at(joint), reference.time)),
          .reference = Columns(reference.p_V.at(joint))};
}

Eigen::Matrix3Xd SideBySide(const std::vector<PointSeries>& series,
                            Eigen::Matrix3Xd PointSeries::*points) {
  Eigen::Matrix3Xd all(3, 0);
  for (const PointSeries& one : series) {
    const Eigen::Index before = all.cols();
    all.conservativeResize(3, before + (one.*points).cols());
    all.rightCols((one.*points).cols()) = one.*points;
  }
  return all;
}

Series Row(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::RowVectorXd>(values.data(),
                                              static_cast<Eigen::Index>(values.size()));
}

}  // namespace

std::vector<PointSeries> AlignedPoints(const Estimate& estimate, const Reference& reference,
                                       const std::vector<std::string>& joints,
                                       const std::string& from) {
  std::vector<PointSeries> series;
  for (const std::string& joint : joints) {
    series.push_back(PointsOf(estimate, reference, joint));
    if (from.empty()) continue;
    const PointSeries origin = PointsOf(estimate, reference, from);
    series.back().estimate -= origin.estimate;
    series.back().reference -= origin.reference;
  }
  const RigidMotion motion = AlignRigidly(SideBySide(series, &PointSeries::estimate),
                                          SideBySide(series, &PointSeries::reference));
  for (PointSeries& one : series) one.estimate = motion.Apply(one.estimate);
  return series;
}

AngleSeries AnglesOf(const Estimate& estimate, const Reference& reference,
                     const std::string& name) {
  const auto angles = JointAngleSeries(estimate.q_WB, estimate.side);
  return {.time = reference.time,
          .estimate = Row(Interpolate(SampleTimes(estimate.time), angles.at(name), reference.time)),
          .reference = Row(JointAngleSeries(reference.q_VB, estimate.side).at(name))};
}

std::vector<Interval> CyclesOf(const Trial& trial, const std::vector<double>& time,
                               const Series& signal) {
  std::vector<Interval> cycles;
  for (const Interval& interval : trial.observations.intervals)
    if (interval.label.starts_with("cycle:")) cycles.push_back(interval);
  if (!cycles.empty()) return cycles;
  return FindCycles(time, {signal.data(), signal.data() + signal.size()});
}

}  // namespace brachium
