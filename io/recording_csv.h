// One sensor's samples as comma-separated text.
#pragma once

#include <cstddef>
#include <string>

#include "io/csv.h"
#include "io/findings.h"
#include "problems/imu.h"

namespace brachium {

// What there is in a recording, and what was left out of it.
struct RecordingFacts {
  Segment segment = Segment::kUpperArm;
  std::string file;              // as trial.json names it
  std::size_t samples = 0;       // usable
  double rate_hz = 0.0;          // 1 / median step
  double start_s = 0.0;          // first sample
  double duration_s = 0.0;       // first to last sample
  std::size_t gaps = 0;          // steps longer than 1.8 times the median
  std::size_t lost_samples = 0;  // that would have filled them
  double longest_step_s = 0.0;
  std::size_t not_finite_rows = 0;  // left out
  std::size_t not_later_rows = 0;   // left out: time repeats itself or runs back
  bool cut_off = false;             // the last row
  bool magnetometer = false;
  bool orientation = false;
};

struct RecordingFile {
  Recording recording;  // samples only: no noise, no mounting
  RecordingFacts facts;
};

// Columns time_s, gyr_x.._z [rad/s], acc_x.._z [m/s^2], and all or none of mag_x.._z and of
// q_w, q_x, q_y, q_z. Rows that cannot be used are left out and reported under `name`; a unit in
// which nothing sensible can follow is an InputError under `file`, one that only looks wrong a
// warning.
RecordingFile ParseRecording(std::string_view text, const std::string& file,
                             const std::string& name, Segment segment, Findings* findings);

// The same of a table whose columns have these names and units already.
RecordingFile MakeRecording(const CsvTable& table, const std::string& name, Segment segment,
                            Findings* findings);

// Writes the table that ParseRecording reads. Throws OutputError.
void WriteRecording(const Recording& recording, const std::string& file);

}  // namespace brachium
