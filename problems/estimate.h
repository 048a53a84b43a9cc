// What a method found: the motion, the constants, and how the finding went.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problems/segment.h"

namespace brachium {

struct ResidualStatistics {
  std::string kind;       // "gyroscope/forearm", "elbow_adduction", ...
  std::size_t count = 0;  // scalar residuals
  double rms = 0.0;       // of the whitened residual: 1 when its model holds
};

struct Constant {
  std::string name;           // "elbow.carrying_angle_deg", "forearm.accelerometer_bias", ...
  std::vector<double> value;  // one number or three, in the unit that the name says (SI without)
  std::vector<double> sd;     // the same shape, or empty
};

struct Rest {
  Segment segment = Segment::kUpperArm;
  double start = 0.0;      // [s]
  double end = 0.0;        // [s]
  double certainty = 1.0;  // probability that it is one
};

// A movement between two rests of one sensor.
struct Epoch {
  Segment segment = Segment::kUpperArm;
  double start = 0.0;  // [s]
  double end = 0.0;    // [s]
};

// What held the heading of a segment against that of the one before it in the arm, by equal spans of
// the trial.
struct HeadingSupport {
  Segment segment = Segment::kForearm, against = Segment::kUpperArm;
  std::vector<double> time;  // middles of the spans [s]
  std::vector<double> sd;    // greatest in the span [rad]
  // By kind of residual, where it brings any: what it alone would hold the heading to by what
  // happens in the span; infinite where nothing does [rad].
  std::map<std::string, std::vector<double>> sd_by;
};

// A number that describes the run, named: "knots", "windows", "start_heading_deg", ...
struct Figure {
  std::string name;
  double value = 0.0;
};

struct Diagnostics {
  bool converged = true;
  bool singular = false;    // the information matrix, priors included
  std::string termination;  // one sentence
  int iterations = 0;
  double initial_cost = 0.0;
  double final_cost = 0.0;
  double gradient_norm = 0.0;
  std::vector<ResidualStatistics> residuals;
  std::vector<Constant> constants;
  std::vector<Rest> rests;
  std::vector<Epoch> epochs;
  std::vector<HeadingSupport> headings;
  std::vector<Figure> figures;
  std::vector<std::string>
      held_by_prior;               // unknowns that the data did not inform, one sentence each
  std::vector<std::string> notes;  // what the reader should know
};

struct StageTime {
  std::string stage;
  double seconds = 0.0;
};

// The trajectory at the first recording's sample times. What a method does not estimate is absent;
// an instant that the sensors do not cover holds NaN.
struct Estimate {
  std::string method;
  Side side = Side::kRight;
  std::vector<double> time;  // [s]
  std::map<Segment, std::vector<Eigen::Quaterniond>> q_WB;
  std::map<Segment, std::vector<Eigen::Vector3d>> sd_B;     // of q_WB's error, segment axes [rad]
  std::map<std::string, std::vector<Eigen::Vector3d>> p_W;  // by name as in Reference [m]
  // Standard deviations: of p_W, by the same names, in world axes [m]; of joint angles by name
  // ("elbow_flexion"), and of "relative_heading", forearm against upper arm [rad].
  std::map<std::string, std::vector<Eigen::Vector3d>> sd_W;
  std::map<std::string, std::vector<double>> sd_angle;
  Diagnostics diagnostics;
  std::vector<StageTime> timing;
  std::size_t streamed = 0;  // instants that were handed on already and are not in `time`

  std::size_t Instants() const { return streamed + time.size(); }
};

// Appends the motion of a later piece, which holds the same columns.
void AppendMotion(const Estimate& piece, Estimate& whole);

}  // namespace brachium
