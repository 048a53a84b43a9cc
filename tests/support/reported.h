// A small report, for tests of its parts.
#pragma once

#include <cmath>
#include <string>

#include "io/report/reported.h"
#include "problems/joint_angles.h"

namespace brachium {

// A left arm that bends over two seconds; the middle third of the forearm is unknown, and its
// reference is a degree less flexed.
inline ReportedEstimate BendingArm(const std::string& trial = "drinking") {
  ReportedEstimate reported{.name = trial + ", smoother", .label = "smoother"};
  reported.run.trial = trial;
  Estimate& estimate = reported.estimate;
  estimate.method = "smoother";
  estimate.side = Side::kLeft;
  Reference reference;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.01 * i, flexion = 0.5 - 0.4 * std::cos(3.0 * t);
    const auto elbow = [&](double angle) {
      return ElbowRotation({.flexion = angle, .carrying = 0.1, .pronation = 0.7}, Side::kLeft);
    };
    const Eigen::Quaterniond q_WU(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
    estimate.time.push_back(t);
    estimate.q_WB[Segment::kUpperArm].push_back(q_WU);
    estimate.q_WB[Segment::kForearm].push_back(q_WU * elbow(flexion));
    if (i >= 70 && i < 130) estimate.q_WB[Segment::kForearm].back().coeffs().setConstant(NAN);
    reference.time.push_back(t);
    reference.q_VB[Segment::kUpperArm].push_back(q_WU);
    reference.q_VB[Segment::kForearm].push_back(q_WU * elbow(flexion - M_PI / 180.0));
  }
  estimate.diagnostics.rests = {{Segment::kUpperArm, 0.0, 0.4}, {Segment::kForearm, 0.2, 0.6}};
  estimate.diagnostics.residuals = {{"gyroscope/forearm", 300, 0.9}, {"prior", 2, 4.0}};
  reported.evaluation = Evaluate(estimate, reference);
  reported.reference = std::move(reference);
  return reported;
}

// With standard deviations of angles and of the wrist.
inline ReportedEstimate KnownArm() {
  ReportedEstimate reported = BendingArm();
  Estimate& estimate = reported.estimate;
  const std::size_t n = estimate.time.size();
  estimate.sd_angle["elbow_flexion"].assign(n, 0.01);
  for (const char* joint : {"shoulder", "elbow", "wrist"})
    estimate.p_W[joint].assign(n, Eigen::Vector3d(0.1, 0.2, 0.3));
  estimate.sd_W["wrist"].assign(n, Eigen::Vector3d(0.01, 0.02, 0.03));
  return reported;
}

}  // namespace brachium
