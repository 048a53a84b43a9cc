#include "solver/observability.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

std::size_t U(int i) { return static_cast<std::size_t>(i); }

constexpr double kSpan = 5.0;              // [s]
constexpr double kTurn = 1e-4;             // [rad]
constexpr double kNotHeld = 10 * kDegree;  // of a standard deviation
constexpr double kUnfelt = 1e-6;           // information that is rounding [1/rad²]

Segment SegmentOf(const ArmProblem& problem, int sensor) {
  return problem.observations().recordings[U(sensor)].segment;
}

Eigen::Map<const Vector3d> Vector(const double* x) { return Eigen::Map<const Vector3d>(x); }

// The proximal joint of a sensor's segment, at every knot, in W [m].
std::vector<Vector3d> JointPlaces(const ArmProblem& problem, const State& state, int sensor) {
  std::vector<Vector3d> places;
  for (int knot = 0; knot < problem.size().knots; ++knot) {
    places.push_back(problem.PlaceOnChain(state, knot, sensor) -
                     problem.SegmentAttitude(state, knot, sensor) *
                         Vector(state.Constant(UnknownKind::kSensorPosition, sensor)));
  }
  return places;
}

// A place that is nowhere told goes along as far as it can with the points that touch it.
void MoveContactPlaces(const ArmProblem& problem, const State& from, State& to) {
  for (int contact = 0; contact < problem.size().contacts; ++contact) {
    const std::vector<int> touches = problem.Touches(contact);
    Vector3d shift = Vector3d::Zero();
    for (const int knot : touches)
      shift +=
          problem.TouchingPoint(to, contact, knot) - problem.TouchingPoint(from, contact, knot);
    shift /= static_cast<double>(touches.size());
    const int place = problem.PlaceOf(contact), numbers = problem.Describe(place).Size();
    Eigen::Map<Eigen::VectorXd>{problem.Value(to, place), numbers} += shift.tail(numbers);
  }
}

// The state with everything from a sensor on turned about the vertical through its proximal joint.
State Turned(const ArmProblem& problem, const State& state, int first, double turn) {
  State turned = state;
  const Quaterniond q(Eigen::AngleAxisd(turn, Vector3d::UnitZ()));
  const std::vector<Vector3d> joint = JointPlaces(problem, state, first);
  const auto& time = problem.timeline().knots;
  const int last = problem.size().knots - 1;
  for (int knot = 0; knot <= last; ++knot) {
    const int before = std::max(knot - 1, 0), after = std::min(knot + 1, last);
    const double span = time[U(after)] - time[U(before)];
    const Vector3d velocity =
        span > 0.0 ? Vector3d((joint[U(after)] - joint[U(before)]) / span) : Vector3d::Zero();
    for (int sensor = first; sensor < problem.size().sensors; ++sensor) {
      Eigen::Map<Quaterniond> q_WB(problem.Value(turned, problem.Attitude(knot, sensor)));
      q_WB = (q * q_WB).normalized();
      Eigen::Map<Vector3d> place(problem.Value(turned, problem.Place(knot, sensor)));
      place = joint[U(knot)] + q * (place - joint[U(knot)]);
      Eigen::Map<Vector3d> v(problem.Value(turned, problem.Velocity(knot, sensor)));
      v = velocity + q * (v - velocity);
    }
  }
  MoveContactPlaces(problem, state, turned);
  return turned;
}

std::vector<double> Residuals(const ArmProblem& problem, State& state, const Term& term) {
  std::vector<const double*> values;
  for (const int unknown : term.unknowns) values.push_back(problem.Value(state, unknown));
  std::vector<double> r(U(term.cost->num_residuals()));
  term.cost->Evaluate(values.data(), r.data(), nullptr);
  return r;
}

class Spans {
 public:
  explicit Spans(const ArmProblem& problem) : time_(problem.timeline().knots) {
    const double duration = time_.back() - time_.front();
    count_ = std::max(1, static_cast<int>(std::lround(duration / kSpan)));
    length_ = duration / count_;
  }
  std::size_t size() const { return U(count_); }
  std::size_t Of(int knot) const {
    const auto at = static_cast<int>((time_[U(knot)] - time_.front()) / length_);
    return U(std::clamp(at, 0, count_ - 1));
  }
  std::vector<double> Middles() const {
    std::vector<double> middles;
    for (int i = 0; i < count_; ++i) middles.push_back(time_.front() + (i + 0.5) * length_);
    return middles;
  }

 private:
  const std::vector<double>& time_;
  int count_;
  double length_;
};

void AddInformation(const ArmProblem& problem, const State& state, int sensor, const Spans& spans,
                    HeadingSupport& support) {
  State plus = Turned(problem, state, sensor, kTurn),
        minus = Turned(problem, state, sensor, -kTurn);
  std::map<std::string, std::vector<double>> information;
  for (const Term& term : problem.terms()) {
    if (term.kind == ResidualKind::kRangeOfMotion) continue;  // a stop holds from one side only
    const std::vector<double> ahead = Residuals(problem, plus, term),
                              behind = Residuals(problem, minus, term);
    double sum = 0.0;
    for (std::size_t i = 0; i < ahead.size(); ++i) {
      const double slope = (ahead[i] - behind[i]) / (2 * kTurn);
      sum += slope * slope;
    }
    if (sum < kUnfelt) continue;
    auto& by_span = information[std::string(Name(term.kind))];
    by_span.resize(spans.size(), 0.0);
    by_span[spans.Of(term.first_knot)] += sum;
  }
  for (auto& [kind, by_span] : information) {
    for (double& value : by_span)
      value = value > kUnfelt ? 1 / std::sqrt(value) : std::numeric_limits<double>::infinity();
    support.sd_by[kind] = std::move(by_span);
  }
}

void AddDeviations(const ArmProblem& problem, const PoseCovariance& covariance, int sensor,
                   const Spans& spans, HeadingSupport& support) {
  support.sd.assign(spans.size(), 0.0);
  for (int knot = 0; knot < problem.size().knots; ++knot) {
    const Eigen::MatrixXd P = covariance.Attitudes(knot, 0.0);
    const int here = 3 * sensor + 2, before = here - 3;
    const double variance = P(here, here) + P(before, before) - 2 * P(here, before);
    double& sd = support.sd[spans.Of(knot)];
    sd = std::max(sd, std::sqrt(std::max(0.0, variance)));
  }
}

std::string Whole(double value) { return std::to_string(static_cast<int>(std::lround(value))); }

// From one span to another, both included.
std::string When(const std::vector<double>& middles, std::size_t first, std::size_t last) {
  if (middles.size() == 1) return "throughout";
  const double half = 0.5 * (middles[1] - middles[0]);
  return "from " + Whole(middles[first] - half) + " to " + Whole(middles[last] + half) + " s";
}

}  // namespace

std::vector<HeadingSupport> DescribeHeadings(const ArmProblem& problem, const State& state,
                                             const PoseCovariance& covariance) {
  std::vector<HeadingSupport> headings;
  const Spans spans(problem);
  for (int sensor = 1; sensor < problem.size().sensors; ++sensor) {
    HeadingSupport support{.segment = SegmentOf(problem, sensor),
                           .against = SegmentOf(problem, sensor - 1),
                           .time = spans.Middles(),
                           .sd = {},
                           .sd_by = {}};
    AddInformation(problem, state, sensor, spans, support);
    AddDeviations(problem, covariance, sensor, spans, support);
    headings.push_back(std::move(support));
  }
  return headings;
}

std::vector<std::string> HeadingsNotHeld(const std::vector<HeadingSupport>& headings) {
  std::vector<std::string> sentences;
  for (const HeadingSupport& support : headings) {
    for (std::size_t i = 0; i < support.sd.size(); ++i) {
      const std::size_t first = i;
      double most = 0.0;
      for (; i < support.sd.size() && support.sd[i] > kNotHeld; ++i)
        most = std::max(most, support.sd[i]);
      if (i == first) continue;
      sentences.push_back("The heading of the " + std::string(Name(support.segment)) +
                          " against the " + std::string(Name(support.against)) +
                          " is little held " + When(support.time, first, i - 1) +
                          ": its standard deviation is up to " + Whole(most / kDegree) + " deg");
    }
  }
  return sentences;
}

}  // namespace brachium
