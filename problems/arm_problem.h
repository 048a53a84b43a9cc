// The objective: which residuals stand between which unknowns of a trial.
//
// Terms are in order of the first knot that they touch, so that a method can take them in time
// order: everything before a knot, a window, or all of it.
#pragma once

#include <ceres/loss_function.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/model_options.h"
#include "problems/observations.h"
#include "problems/preintegration.h"
#include "problems/residuals/cost.h"
#include "problems/state.h"
#include "problems/stillness.h"
#include "problems/timeline.h"

namespace brachium {

enum class ResidualKind {
  kGyroscope,
  kAccelerometer,
  kSegmentChain,
  kElbowAdduction,
  kAdductionProcess,
  kSkinProcess,
  kShoulderProcess,
  kZeroVelocity,
  kGyroBiasRest,
  kGyroBiasWalk,
  kStartPose,
  kEndPose,
  kContact,
  kRangeOfMotion,
  kPrior,
  kSegmentLength,
  kPlaceGauge,
  kHeadingGauge,
  kStartHeading,
  kMarginalPrior,
};
std::string_view Name(ResidualKind kind);

struct Unknown {
  UnknownKind kind = UnknownKind::kAttitude;
  int place = -1;     // knot or node; -1 for a constant of the trial
  int sensor = -1;    // or root, or contact
  bool held = false;  // a number, that nothing is asked about
  int Size() const;
  int Tangent() const { return held ? 0 : TangentSize(Size()); }
};

struct Term {
  std::unique_ptr<TangentCost> cost;
  std::vector<int> unknowns;  // indices, in the order of the cost's blocks
  ResidualKind kind = ResidualKind::kPrior;
  int sensor = -1;     // whose samples, or -1
  int first_knot = 0;  // at whose elimination the term is used up
  int last_knot = 0;   // at which the term enters
  // Bounds what outliers say: ½ ρ(|r|²) stands for ½ |r|². None: all is believed. Terms may share it.
  std::shared_ptr<ceres::LossFunction> loss = nullptr;
};

// What the model leaves out of one sensor's motion: both last for unmodelled_correlation_s.
struct Unmodelled {
  double acceleration = 0.0;  // rms of an axis [m/s²]
  double quiver = 0.0;        // rms of an axis of its place against the chain of segments [m]
};

class ArmProblem {
 public:
  // Requires observations that the smoother accepts; recordings in proximal-to-distal order.
  // `clock`: the segment whose sensor's clock is the true time; else the first one's. A `stretch`
  // that continues another has no terms about its first knot and the constants alone: a marginal
  // prior speaks of them.
  ArmProblem(Observations observations, const ModelOptions& options, double knot_spacing,
             std::optional<Segment> clock = std::nullopt, Stretch stretch = {});

  const Timeline& timeline() const { return timeline_; }
  const StateSize& size() const { return size_; }
  const std::vector<Term>& terms() const { return terms_; }
  int unknowns() const { return first_constant_ + static_cast<int>(constants_.size()); }
  Unknown Describe(int unknown) const;
  double* Value(State& state, int unknown) const;

  // Indices of unknowns.
  int Attitude(int knot, int sensor) const { return knot * per_knot_ + sensor; }
  int Root(int knot, int root) const { return knot * per_knot_ + size_.sensors + root; }
  int Velocity(int knot, int sensor) const {
    return knot * per_knot_ + size_.sensors + size_.roots + sensor;
  }
  int Place(int knot, int sensor) const { return Velocity(knot, size_.sensors) + sensor; }
  int Skin(int knot, int sensor) const { return Place(knot, size_.sensors) + sensor; }
  int Adduction(int knot) const { return knot * per_knot_ + per_knot_ - 1; }
  int GyroBias(int node, int sensor) const { return first_node_ + node * size_.sensors + sensor; }
  int Constant(UnknownKind kind, int sensor) const;  // -1 where the problem has none
  int FirstConstant() const { return first_constant_; }

  // The sensors whose segments lie between the root and this one, this one last.
  std::vector<int> Chain(int sensor) const;
  int RootOf(int sensor) const { return has_thorax_ && sensor > 0 ? 1 : 0; }
  int FirstOfArm() const { return has_thorax_ && size_.sensors > 1 ? 1 : 0; }
  int SensorOn(Segment segment) const;  // -1: none

  // Upper arm, forearm and between them an elbow with two axes.
  bool HasElbow() const;

  // Sd of how a sensor is turned on its segment, where its turn is no unknown but not known exactly
  // either: nothing in the trial tells more of it than what was told; else 0 [rad].
  double UntestedMountingSigma(int sensor) const;

  // Takes all mountings as told from here on, their sds remaining. Turns in `state` become zero.
  void HoldMountings(State& state);

  // What samples that are missing in an interval add to its turn, per axis, up to a turn's [rad²].
  static double GapVariance(const Preintegrated& interval);

  const Preintegrated& Interval(int knot, int sensor) const {
    return intervals_[static_cast<std::size_t>(knot * size_.sensors + sensor)];
  }
  const Preintegrator& Samples(int sensor) const {
    return preintegrators_[static_cast<std::size_t>(sensor)];
  }
  // By the sensor's own clock.
  const std::vector<RestInterval>& Rests(int sensor) const {
    return rests_[static_cast<std::size_t>(sensor)];
  }
  const Observations& observations() const { return observations_; }
  const ModelOptions& options() const { return options_; }

  // Takes the clocks, by sensor, to be off by `clock_offsets` [s]: moves rests by them, and sums all
  // samples again about them and the biases in `state`. Terms and what was planned of them become
  // invalid.
  void SumAgain(const State& state, const std::vector<double>& clock_offsets);

  // A state with every constant at its prior mean, biases from the rests, knots not yet set; biases
  // and clocks of a stretch as it has them.
  State PriorState() const;

  // Of the segment itself, whose sensor may sit otherwise than told.
  Eigen::Quaterniond SegmentAttitude(const State& state, int knot, int sensor) const;

  // Where the chain of segments puts a sensor, in W [m].
  Eigen::Vector3d PlaceOnChain(const State& state, int knot, int sensor) const;

  // Of observations().contacts[contact]: its place, the knots at which the arm is there, each once and
  // in order, and where the touching point then is, in W [m].
  int PlaceOf(int contact) const;
  std::vector<int> Touches(int contact) const;
  Eigen::Vector3d TouchingPoint(const State& state, int contact, int knot) const;

  // What the model leaves out of each sensor's motion; setting it renews the weights that use it.
  const std::vector<Unmodelled>& unmodelled() const { return unmodelled_; }
  void SetUnmodelled(const std::vector<Unmodelled>& unmodelled);

  // Ties the headings at the first knot to those in `state`: the first segment's firmly, which fixes
  // the gauge, the others' against the one before by kStartHeadingSigma.
  static constexpr double kStartHeadingSigma = 2.0;  // [rad]
  void FixHeadings(const State& state);

  // The time that a knot stands for: half of the intervals beside it [s].
  double KnotSpan(int knot) const;

  // Two-sided density of what an accelerometer's interval leaves out, white noise apart [m²/s³].
  double UnmodelledDensity(int knot, int sensor, double sigma) const;

 private:
  void SortTerms();
  void DropStart();
  Eigen::Vector3d BiasFromRests(int sensor) const;
  void AddConstants();
  void AddSensorConstants(int sensor);
  bool ShowsMounting(int sensor) const;
  template <int kSize>
  void AddConstant(UnknownKind kind, int sensor, const Eigen::Matrix<double, kSize, 1>& mean,
                   const Eigen::Matrix<double, kSize, 1>& sigma);
  Preintegrated SumInterval(const State& state, int knot, int sensor, double clock_offset) const;
  void AddGyroscope(int knot, int sensor);
  void AddAccelerometer(int knot, int sensor);
  void AddChain(int knot, int sensor);
  // What a residual about the segments of these sensors, as mounted, speaks of beside `others`.
  std::vector<int> OfSegments(int knot, const std::vector<int>& sensors,
                              const std::vector<int>& others) const;
  void AddSkin(int sensor);
  void AddElbow();
  void AddShoulder();
  void AddRests(int sensor);
  void AddBiasWalk(int sensor);
  void AddStart();
  void AddHeldPose(const HeldPose& pose, ResidualKind kind);
  bool IsTouching(Segment segment) const;
  void AddContact(int contact);
  template <typename Residual>
  void Add(Residual residual, ResidualKind kind, std::vector<int> unknowns, int sensor, int first,
           int last);
  std::unique_ptr<TangentCost> MakeGyroscope(int knot, int sensor) const;
  std::unique_ptr<TangentCost> MakeAccelerometer(int knot, int sensor) const;
  std::unique_ptr<TangentCost> MakeChain(int knot, int sensor) const;

  Observations observations_;
  ModelOptions options_;
  Stretch stretch_;
  Timeline timeline_;
  StateSize size_;
  int clock_sensor_ = 0;
  bool has_thorax_ = false;
  int per_knot_ = 0, first_node_ = 0, first_constant_ = 0;
  std::vector<Unknown> constants_;
  std::vector<Preintegrator> preintegrators_;
  std::vector<std::vector<RestInterval>> rests_;
  std::vector<Preintegrated> intervals_;
  std::vector<Unmodelled> unmodelled_;
  std::vector<Term> terms_;
};

}  // namespace brachium
