#include "solver/baselines/elbow_constraint.h"

namespace brachium {

PredictedAdduction PredictAdduction(const Eigen::Quaterniond& q_WF,
                                    const Eigen::Quaterniond& q_WU) {
  const Eigen::Vector3d z_U = q_WU * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d y_F = q_WF * Eigen::Vector3d::UnitY();
  const Eigen::Vector3d n = z_U.cross(y_F);
  PredictedAdduction predicted{.sine = z_U.dot(y_F), .H_W = {}};
  predicted.H_W << n.transpose(), -n.transpose();
  return predicted;
}

}  // namespace brachium
