// What the methods that integrate or filter share: samples in segment axes, and where they begin.
#pragma once

#include <string>
#include <vector>

#include "problems/estimate.h"
#include "problems/observations.h"
#include "problems/preintegration.h"

namespace brachium {

// One segment: its samples, turned by the mounting into segment axes B, and what is known of it at
// the start. The gyro bias is in segment axes.
struct Track {
  Recording recording;
  Preintegrator samples;
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  double inclination_sigma = 0.0;                       // [rad]
  double heading_sigma = 0.0;                           // against the first segment's [rad]
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();  // [rad/s]
  double gyro_bias_sigma = 0.0;                         // per axis [rad/s]
};

struct Tracks {
  std::vector<Track> segments;  // in the order of the recordings
  double start = 0.0;           // the span that all recordings cover, whole cells [s]
  double end = 0.0;
  double gravity = kGravity;  // [m/s^2]
  std::vector<Rest> rests;
  std::vector<std::string> notes;  // what was taken for the start, and why
};

// Where all begin, at the first instant that every recording covers:
//   gyro bias    mean rate over the rests of the whole recording, each weighted by how well it tells
//                it, beside a prior of zero: zero where there is no rest, or without
//                `bias_from_rests`;
//   inclination  from the specific force of the first two seconds, turned back by the gyroscope;
//   heading      of the x axis of every segment: zero; with a told start pose the forearm's is
//                turned to it, at its instant, and the hand's with it.
Tracks StartTracks(const Observations& observations, bool bias_from_rests = true);

// The index of the segment's track, or -1.
int TrackOf(const Tracks& tracks, Segment segment);

// An estimate on the first recording's clock with one attitude of NaN per instant and segment, and
// with the start, the biases and the rests in its diagnostics. No positions: these methods estimate
// none.
Estimate BlankEstimate(const std::string& method, const Observations& observations,
                       const Tracks& tracks);

}  // namespace brachium
