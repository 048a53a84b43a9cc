// Each residual that the objective of an arm is made of, as its terms hold it: one evaluation of its
// values and of all its derivatives. Analytic: the derivatives as they are written, in the tangent
// space, which is what the chain asks for. Automatic: those of Ceres' dual numbers, the witness in
// the tests, four columns a rotation.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "problems/residuals/accelerometer.h"
#include "problems/residuals/as_mounted.h"
#include "problems/residuals/contact.h"
#include "problems/residuals/elbow_adduction.h"
#include "problems/residuals/gyro_bias.h"
#include "problems/residuals/gyroscope.h"
#include "problems/residuals/held_pose.h"
#include "problems/residuals/in_body_axes.h"
#include "problems/residuals/range_of_motion.h"
#include "problems/residuals/segment_chain.h"
#include "problems/residuals/segment_length.h"
#include "problems/residuals/shoulder_process.h"
#include "problems/residuals/skin.h"
#include "problems/residuals/start_heading.h"
#include "problems/residuals/thorax_shoulder.h"
#include "problems/residuals/zero_velocity.h"
#include "tests/support/residual_values.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kStep = 0.05;  // from knot to knot [s]

// Attitudes anywhere, the rest about as large as in an arm's units.
template <typename Residual>
BlockValues SomeValues() {
  std::mt19937 random(1);
  return RandomValues(typename Residual::Blocks(), random, 0.1);
}

// Repeats evaluate(values, r, J), with room for a matrix a block, as wide as its tangent space or as
// the block itself.
template <typename Residual, typename Evaluate>
void Repeat(benchmark::State& state, bool tangent, const Evaluate& evaluate) {
  const BlockValues x = SomeValues<Residual>();
  const std::vector<const double*> values = Pointers(x);
  Eigen::VectorXd r(Residual::kResiduals);
  std::vector<Eigen::VectorXd> blocks;
  blocks.reserve(x.size());
  std::vector<double*> J;
  int columns = 0;
  for (const Eigen::VectorXd& block : x) {
    const int size = static_cast<int>(block.size());
    J.push_back(blocks.emplace_back(r.size() * (tangent ? TangentSize(size) : size)).data());
    columns += TangentSize(size);
  }
  benchmark::DoNotOptimize(r.data());
  benchmark::DoNotOptimize(J.data());
  for (auto _ : state) {
    evaluate(values.data(), r.data(), J.data());
    benchmark::ClobberMemory();
  }
  state.counters["residuals"] = Residual::kResiduals;
  state.counters["columns"] = columns;
}

template <typename Residual>
void Analytic(benchmark::State& state, const Residual& residual) {
  const std::unique_ptr<TangentCost> cost(MakeCost(residual));
  Repeat<Residual>(state, true, [&](const double* const* x, double* r, double** J) {
    cost->EvaluateTangent(x, r, J);
  });
}

template <typename Residual>
void Automatic(benchmark::State& state, const Residual& residual) {
  const std::unique_ptr<ceres::CostFunction> cost(
      MakeAutomaticCost(residual, typename Residual::Blocks()));
  Repeat<Residual>(state, false,
                   [&](const double* const* x, double* r, double** J) { cost->Evaluate(x, r, J); });
}

template <typename Residual>
void Measure(const std::string& name, const Residual& residual) {
  benchmark::RegisterBenchmark((name + "/analytic").c_str(), Analytic<Residual>, residual);
  benchmark::RegisterBenchmark((name + "/automatic").c_str(), Automatic<Residual>, residual);
}

Preintegrated SomeInterval() {
  std::mt19937 random(1);
  Preintegrated interval;
  interval.duration = kStep;
  interval.dq = Near(Quaterniond::Identity(), 0.1, random);
  interval.dv = RandomVector(3, random);
  interval.dp = RandomVector(3, random);
  for (Eigen::Matrix3d* change :
       {&interval.dR_dbg, &interval.dR_dsg, &interval.dv_dbg, &interval.dp_dbg, &interval.dv_dsg,
        &interval.dp_dsg, &interval.dv_dba, &interval.dp_dba, &interval.dv_dsa, &interval.dp_dsa})
    for (auto column : change->colwise()) column = RandomVector(3, random, kStep);
  return interval;
}

void MeasureSamples() {
  static const Preintegrated interval = SomeInterval();
  const Quaterniond q_BS = Exp<double>(Vector3d(0.4, -1.0, 0.7));
  const auto white = Whitening2::FromCovariance(WhiteAccelerationCovariance(0.01, kStep));
  Measure("gyroscope", Gyroscope(interval, q_BS, 0.3, 0.01));
  Measure("accelerometer", Accelerometer(interval, q_BS, 0.3, kGravity, white));
}

void MeasureArm(const FirstOrderStep& step) {
  Measure("segment_chain of 1", AsMounted(SegmentChain<1>(0.01)));
  Measure("segment_chain of 2", AsMounted(SegmentChain<2>(0.01)));
  Measure("segment_chain of 3", AsMounted(SegmentChain<3>(0.01)));
  Measure("segment_chain of 4", AsMounted(SegmentChain<4>(0.01)));
  Measure("elbow_adduction", AsMounted(ElbowAdduction(Side::kRight, 0.1)));
  Measure("adduction_process", AdductionProcess(step));
  Measure("range_of_motion, inside", AsMounted(ElbowRangeOfMotion(-4.0, 4.0, 0.1)));
  Measure("range_of_motion, beyond", AsMounted(ElbowRangeOfMotion(-6.0, -5.0, 0.1)));
  Measure("skin", SkinProcess(step));
  Measure("shoulder_process", InBodyAxes(ShoulderProcess(step)));
  Measure("thorax_shoulder", ThoraxShoulder(Vector3d(0.0, 0.1, 0.2), step));
}

void MeasureRestsAndBiases(const FirstOrderStep& step) {
  Measure("zero_velocity", InBodyAxes(ZeroVelocity(step, 0.9)));
  Measure("gyro_bias, rest", GyroBiasRest(Vector3d::Zero(), 0.3, 1e-3, 0.9));
  Measure("gyro_bias, walk", GyroBiasWalk(1e-4, 10.0));
}

void MeasureProtocol() {
  Measure("held_pose, flexion",
          AsMounted(ElbowHeldPose(ElbowAngle::kFlexion, Side::kRight, 0.2, 0.2)));
  Measure("held_pose, elevation", AsMounted(ElevationHeldPose(0.2, 0.2)));
  Measure("held_pose, facing", AsMounted(FacingHeldPose(0.3)));
  Measure("contact, place", AsMounted(ContactPlace<2>(0.01)));
  Measure("contact, height", AsMounted(ContactHeight<2>(0.01)));
}

void MeasureStart() {
  const Quaterniond q_start = Exp<double>(Vector3d(0.1, 0.2, 0.3));
  Measure("start_heading, gauge", HeadingGauge(q_start));
  Measure("start_heading, relative", RelativeStartHeading(q_start, q_start, 2.0));
  Measure("prior", Prior<3>(Vector3d::Zero(), Vector3d::Ones()));
  Measure("prior, body axes", InBodyAxes(Prior<3>(Vector3d::Zero(), Vector3d::Ones())));
  Measure("segment_length", SegmentLength(Vector3d(0.0, -0.3, 0.0), 0.005));
}

}  // namespace
}  // namespace brachium

int main(int argc, char** argv) {
  using namespace brachium;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  const FirstOrderStep step = FirstOrderStep::Over(kStep, 0.1, 1.0);
  MeasureSamples();
  MeasureArm(step);
  MeasureRestsAndBiases(step);
  MeasureProtocol();
  MeasureStart();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
