#include "solver/baselines/strapdown.h"

#include <limits>

namespace brachium {

using Eigen::Quaterniond, Eigen::Vector3d;

FreeMotion IntegrateFreely(const Preintegrator& samples, const FreeStart& start, double end,
                           const std::vector<double>& times) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const Vector3d g_W(0.0, 0.0, -start.gravity);
  FreeMotion motion;
  motion.q_WB.assign(times.size(), Quaterniond(kNaN, kNaN, kNaN, kNaN));
  motion.p_W.assign(times.size(), Vector3d::Constant(kNaN));
  Quaterniond q = start.q_WB;
  Vector3d v = Vector3d::Zero(), p = Vector3d::Zero();
  double time = start.time;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < start.time || times[i] > end) continue;
    const Preintegrated sum = samples.Sum(time, times[i], start.gyro_bias);
    const double D = sum.duration;
    p += v * D + g_W * (D * D / 2) + q * sum.dp;
    v += g_W * D + q * sum.dv;
    q = (q * sum.dq).normalized();
    time = times[i];
    motion.q_WB[i] = q;
    motion.p_W[i] = p;
  }
  return motion;
}

}  // namespace brachium
