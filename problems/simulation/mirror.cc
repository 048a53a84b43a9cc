#include "problems/simulation/mirror.h"

#include "problems/joint_angles.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

Vector3d MirroredInWorld(const Vector3d& v_W) { return {v_W.x(), -v_W.y(), v_W.z()}; }

Quaterniond MirroredToWorld(const Quaterniond& q_WB) {
  return {q_WB.x(), q_WB.w(), -q_WB.z(), -q_WB.y()};
}

MovingPoint MirroredInWorld(const MovingPoint& point) {
  return {MirroredInWorld(point.p), MirroredInWorld(point.v), MirroredInWorld(point.a)};
}

BodyMotion Mirrored(const BodyMotion& body) {
  return {.turning = {.q_AB = MirroredToWorld(body.turning.q_AB),
                      .omega_AB_B = MirroredAxial(body.turning.omega_AB_B),
                      .alpha_AB_B = MirroredAxial(body.turning.alpha_AB_B)},
          .joint_W = MirroredInWorld(body.joint_W)};
}

void MirrorInPlace(Recording& recording) {
  for (Vector3d& gyr : recording.gyr_S) gyr = MirroredAxial(gyr);
  for (Vector3d& acc : recording.acc_S) acc = MirroredPolar(acc);
  recording.mag_S.clear();
  recording.q_WS.clear();
  if (recording.mounting) recording.mounting = Mirrored(*recording.mounting);
}

void MirrorInPlace(Reference& reference) {
  for (auto& [segment, attitudes] : reference.q_VB)
    for (Quaterniond& q_VB : attitudes) q_VB = MirroredToWorld(q_VB);
  for (auto& [joint, positions] : reference.p_V)
    for (Vector3d& p_V : positions) p_V = MirroredInWorld(p_V);
}

}  // namespace

ArmMotion Mirrored(const ArmMotion& arm) {
  return {.upper_arm = Mirrored(arm.upper_arm),
          .forearm = Mirrored(arm.forearm),
          .girdle = Mirrored(arm.girdle),
          .hand = Mirrored(arm.hand),
          .wrist_W = MirroredInWorld(arm.wrist_W),
          .fingertip_W = MirroredInWorld(arm.fingertip_W)};
}

Mounting Mirrored(const Mounting& mounting) {
  Mounting mirrored = mounting;
  mirrored.q_BS = Mirrored(mounting.q_BS);
  mirrored.p_BS_B = MirroredPolar(mounting.p_BS_B);
  return mirrored;
}

Trial Mirrored(const Trial& trial) {
  Trial mirrored = trial;
  ArmModel& arm = mirrored.observations.arm;
  arm.side = arm.side == Side::kRight ? Side::kLeft : Side::kRight;
  for (auto& [segment, geometry] : arm.segments)
    geometry.p_distal_B = MirroredPolar(geometry.p_distal_B);
  for (Recording& recording : mirrored.observations.recordings) MirrorInPlace(recording);
  if (mirrored.reference) MirrorInPlace(*mirrored.reference);
  return mirrored;
}

}  // namespace brachium
