#include "solver/stretch_smoother.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "solver/clocks.h"
#include "solver/covariance.h"
#include "solver/least_squares.h"
#include "solver/stage_clock.h"
#include "solver/standard_deviations.h"
#include "solver/stretch.h"
#include "solver/stretch_report.h"
#include "solver/trajectory.h"
#include "solver/unmodelled.h"
#include "solver/window.h"

namespace brachium {
namespace {

std::size_t U(int i) { return static_cast<std::size_t>(i); }

constexpr double kStretch = 60.0;  // [s]
constexpr double kShortest =
    30.0;                          // a rest of the trial below this joins the stretch before it [s]
constexpr double kMargin = 1.0;    // of samples about a stretch [s]: for clocks, and edges of rests
constexpr double kAtOnce = 600.0;  // of samples that no stretch covers [s]
constexpr std::size_t kPiece = 20000;  // samples that leave together, at most

// Standard deviations that differ by more than this factor call for another solution.
constexpr double kOtherWeight = 1.5;

bool AreFar(const std::vector<Unmodelled>& found, const std::vector<Unmodelled>& used) {
  const auto are_far = [](double a, double b) {
    return a > kOtherWeight * b || b > kOtherWeight * a;
  };
  return !std::ranges::equal(found, used, [&](const Unmodelled& a, const Unmodelled& b) {
    return !are_far(a.acceleration, b.acceleration) && !are_far(a.quiver, b.quiver);
  });
}

class StretchSmoother {
 public:
  StretchSmoother(StreamedObservations& trial, const SmootherOptions& options,
                  const EstimateSink& sink, const Progress& progress);
  Estimate Run();

 private:
  struct Part;

  double ClockOf(std::size_t sensor) const { return clocks_.empty() ? 0.0 : clocks_[sensor]; }
  SampleSource& Source(std::size_t sensor) { return *trial_.samples[order_[sensor]]; }
  double CommonStart();
  double CommonEnd();
  Observations Cut(double start, double end);
  void SolveStretch();
  bool Solve(const Observations& cut, double end);
  Stretch Begun(double end) const;
  void SolveWindows(Part& part, UnmodelledSums& left);
  void Commit(Part& part);
  void Emit(Part& part, const std::vector<double>& times);
  void ReadTimesBefore();
  void EmitSamplesAfter(Part& part);

  StreamedObservations& trial_;
  const SmootherOptions& options_;
  const EstimateSink& sink_;
  const Progress& progress_;
  WindowOptions windows_;
  Observations told_;               // recordings without samples, from proximal to distal
  std::vector<std::size_t> order_;  // of the trial's recordings
  std::size_t clock_ = 0;           // the sensor whose clock is the true time
  std::optional<Handover> handover_;
  std::vector<double> clocks_;  // about which samples are summed, by sensor; empty: zero [s]
  ClockRates rates_;
  std::optional<UnmodelledSums> left_;        // of all stretches so far
  std::vector<Unmodelled> unmodelled_;        // by which the next one goes; empty: the first guess
  double start_ = 0.0, emitted_ = -HUGE_VAL;  // [s]
  std::vector<double> before_;                // samples that no stretch covers, not emitted yet [s]
  bool ended_ = false;
  StretchReport report_;
};

// A stretch being solved.
struct StretchSmoother::Part {
  Part(const Observations& cut, const SmootherOptions& options, Segment clock, Stretch stretch)
      : problem(cut, options.model, options.knot_spacing_s, clock, std::move(stretch)),
        state(problem.PriorState()),
        poses(problem, state) {}

  ArmProblem problem;
  State state;
  PoseCovariance poses;
  int stop = 0;  // where the next stretch begins; the last knot where there is none
  bool is_last = false;
  std::optional<Handover> handover;
  WindowReport windows;
  Certainty certainty;  // by the last window
  bool singular = false;
  ResidualSums residuals;
  double unknowns = 0.0;
  ClocksFound clocks;
  int sums = 1;
};

StretchSmoother::StretchSmoother(StreamedObservations& trial, const SmootherOptions& options,
                                 const EstimateSink& sink, const Progress& progress)
    : trial_(trial),
      options_(options),
      sink_(sink),
      progress_(progress),
      windows_{.length = options.window_s,
               .advance = options.WindowAdvance(),
               .solver = SolverNamed(options.solver).value()},
      told_(trial.told),
      order_(trial.samples.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  std::ranges::stable_sort(order_, {}, [&](std::size_t i) { return told_.recordings[i].segment; });
  std::ranges::stable_sort(told_.recordings, {}, &Recording::segment);
  clock_ = static_cast<std::size_t>(std::ranges::find(order_, 0u) - order_.begin());
  if (options.shoulder_sigma_m > 0.0) told_.arm.shoulder.sigma = options.shoulder_sigma_m;
}

Estimate StretchSmoother::Run() {
  StageClock watch;
  start_ = CommonStart();
  ReadTimesBefore();
  while (!ended_) {
    SolveStretch();
    if (progress_) {
      const double begin = CommonStart(), now = ended_ ? CommonEnd() : start_;
      progress_("stretches", (now - begin) / (CommonEnd() - begin));
    }
  }
  Estimate estimate = report_.Told();
  estimate.side = told_.arm.side;
  estimate.timing.push_back({"stretches", watch.Lap()});
  return estimate;
}

double StretchSmoother::CommonStart() {
  double start = -HUGE_VAL;
  for (const auto& samples : trial_.samples) start = std::max(start, samples->First());
  return start;
}

double StretchSmoother::CommonEnd() {
  double end = HUGE_VAL;
  for (std::size_t i = 0; i < order_.size(); ++i)
    end = std::min(end, Source(i).Last() + ClockOf(i));
  return end;
}

// What is told and recorded from one instant to another, by the true time.
Observations StretchSmoother::Cut(double start, double end) {
  Observations cut = ToldBetween(told_, handover_ ? &*handover_ : nullptr, end);
  const double last = std::min(end, CommonEnd());
  for (std::size_t i = 0; i < order_.size(); ++i) {
    Recording samples =
        Source(i).Between(start - kMargin - ClockOf(i), last + kMargin - ClockOf(i));
    cut.recordings[i].time = std::move(samples.time);
    cut.recordings[i].gyr_S = std::move(samples.gyr_S);
    cut.recordings[i].acc_S = std::move(samples.acc_S);
    cut.recordings[i].period = samples.period;
  }
  return cut;
}

// Where there is no knot to hand over at, in a long gap, the stretch grows until there is one.
void StretchSmoother::SolveStretch() {
  const double overlap = windows_.length + options_.model.bias_node_spacing_s;
  for (double length = handover_ ? kStretch : std::max(kStretch, kLongestSettling);; length *= 2) {
    const double end = start_ + length + overlap;
    const bool is_last = end + kShortest > CommonEnd();
    const double to = is_last ? HUGE_VAL : end;
    if (Solve(Cut(start_, to), to)) return;
  }
}

// A stretch is solved again where it tells that samples are to be summed about other clocks, or that
// its residuals were weighted wrongly.
bool StretchSmoother::Solve(const Observations& cut, double end) {
  for (int times = 1;; ++times) {
    Part part(cut, options_, told_.recordings[clock_].segment, Begun(end));
    const Timeline& timeline = part.problem.timeline();
    part.is_last = end == HUGE_VAL;
    part.stop =
        part.is_last
            ? timeline.Intervals()
            : timeline.nodes[U(timeline.NodeBefore(timeline.knots.back() - windows_.length))];
    if (part.stop == 0) return false;
    if (!unmodelled_.empty()) part.problem.SetUnmodelled(unmodelled_);
    UnmodelledSums left = left_ ? *left_ : UnmodelledSums(part.problem);
    part.problem.HoldMountings(part.state);
    SolveWindows(part, left);
    part.sums = times;
    if (options_.weight_iterations > 0) unmodelled_ = left.Estimate();
    const bool reweighs = !unmodelled_.empty() && AreFar(unmodelled_, part.problem.unmodelled());
    if (times < kMostSums && (part.clocks.far || reweighs)) {
      clocks_ = part.clocks.offsets;
      continue;
    }
    left_ = std::move(left);
    Commit(part);
    return true;
  }
}

Stretch StretchSmoother::Begun(double end) const {
  Stretch stretch{.start = std::nullopt, .end = end, .clock_offset = clocks_, .gyro_bias = {}};
  if (!handover_) return stretch;
  stretch.start = handover_->time;
  for (int sensor = 0; sensor < std::ssize(order_); ++sensor)
    stretch.gyro_bias.push_back(
        Eigen::Map<const Eigen::Vector3d>(handover_->Of(UnknownKind::kGyroBias, sensor).data()));
  return stretch;
}

// The window that begins at the handover is solved as well: the knot then has the value that it
// will leave with, and the motion does not leap there.
void StretchSmoother::SolveWindows(Part& part, UnmodelledSums& left) {
  CarriedPrior prior;
  if (handover_)
    prior = TakeOver(*handover_, part.problem, part.state);
  else
    SetStart(part.problem, part.state, windows_, part.windows);
  ForwardWindows windows(part.problem, part.state, std::move(prior), windows_, part.windows);
  const auto solve = [&] {
    windows.Solve();
    windows.workspace().Linearise(part.problem, part.state, windows.prior(),
                                  {.start_knot = windows.start(),
                                   .end_knot = windows.end() + 1,
                                   .last_knot = windows.end(),
                                   .leave_stops = true});
    const auto singular = windows.workspace().sweep.Undetermined(windows.workspace().plan);
    part.singular = part.singular || !singular.empty();
    if (options_.covariance)
      part.certainty = AssessCertainty(part.problem, part.state, windows.workspace(), &part.poses);
  };
  for (;;) {
    solve();
    const bool ends = part.is_last && windows.end() == part.stop;
    const int next = ends ? windows.end() + 1 : windows.NextStart(part.stop);
    if (options_.weight_iterations > 0)
      left.Add(part.problem, windows.start(), next, windows.workspace());
    part.residuals.Add(part.problem, part.state, windows.start(), next);
    if (ends) break;
    windows.Advance(part.stop);
    if (windows.start() < part.stop) continue;
    part.handover = HandOver(part.problem, part.state, windows.prior(), part.stop);
    solve();
    break;
  }
  part.clocks = FindClocks(part.problem, part.state, windows.workspace());
  part.unknowns = windows.left_behind();
  if (part.is_last) part.unknowns += windows.workspace().plan.columns();
}

void StretchSmoother::Commit(Part& part) {
  const double end = part.problem.timeline().knots[U(part.stop)];
  std::vector<double> times = std::move(before_);
  before_.clear();
  const double after = times.empty() ? emitted_ : times.back();
  for (const double time : part.problem.observations().recordings[clock_].time)
    if (time > after && (time <= end || part.is_last)) times.push_back(time);
  Emit(part, times);
  if (part.is_last) EmitSamplesAfter(part);
  report_.Add({.problem = part.problem,
               .state = part.state,
               .stop = part.stop,
               .is_last = part.is_last,
               .windows = part.windows,
               .certainty = part.certainty,
               .singular = part.singular,
               .residuals = part.residuals,
               .unknowns = part.unknowns,
               .sums = part.sums});
  ended_ = part.is_last;
  if (ended_) return;
  rates_.Add(end, part.clocks.offsets);
  const std::vector<double> steps = rates_.Steps(end - start_);
  LetClocksDrift(*part.handover, steps, kClockDrift * (end - start_));
  handover_ = std::move(part.handover);
  start_ = handover_->time;
  clocks_ = part.clocks.offsets;
  for (std::size_t i = 0; i < clocks_.size(); ++i) clocks_[i] += steps[i];
}

void StretchSmoother::Emit(Part& part, const std::vector<double>& times) {
  for (std::size_t first = 0; first < times.size(); first += kPiece) {
    const std::size_t last = std::min(first + kPiece, times.size());
    Estimate piece;
    piece.method = "smoother";
    piece.side = told_.arm.side;
    piece.time.assign(times.begin() + static_cast<std::ptrdiff_t>(first),
                      times.begin() + static_cast<std::ptrdiff_t>(last));
    FillTrajectory(part.problem, part.state, piece);
    if (options_.covariance) FillStandardDeviations(part.problem, part.poses, piece);
    report_.Add(piece);
    sink_(piece);
    emitted_ = times[last - 1];
  }
}

// Samples of the first recording that come before all others have begun.
void StretchSmoother::ReadTimesBefore() {
  SampleSource& source = Source(clock_);
  const double end = start_ - kMargin;
  for (double from = source.First(); from < end; from += kAtOnce)
    for (const double time : source.Between(from, std::min(from + kAtOnce, end)).time)
      if (time < end && (before_.empty() || time > before_.back())) before_.push_back(time);
}

// And those that come after another has ended.
void StretchSmoother::EmitSamplesAfter(Part& part) {
  SampleSource& source = Source(clock_);
  while (emitted_ < source.Last()) {
    std::vector<double> times = source.Between(emitted_, emitted_ + kAtOnce).time;
    std::erase_if(times, [&](double time) { return time <= emitted_; });
    Emit(part, times);
  }
}

}  // namespace

Estimate SmoothInStretches(StreamedObservations& trial, const SmootherOptions& options,
                           const EstimateSink& sink, const Progress& progress) {
  return StretchSmoother(trial, options, sink, progress).Run();
}

}  // namespace brachium
