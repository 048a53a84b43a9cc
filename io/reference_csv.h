// The independent truth of a trial as comma-separated text.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "io/findings.h"
#include "io/json_input.h"
#include "problems/trial.h"

namespace brachium {

// What trial.json says of the reference.
struct ReferenceEntry {
  std::string file;
  Reference::Frames frames = Reference::Frames::kSegment;
  std::map<std::string, std::string> columns;  // segment or point -> its name in the file
  std::map<Segment, Eigen::Quaterniond> q_BC;  // cluster to segment, where that is known
  bool up_is_y = false;
  std::optional<double> clock_offset;  // [s]
};

ReferenceEntry ParseReferenceEntry(const JsonNode& reference, Findings* findings);

struct ReferenceFacts {
  std::string file;         // as trial.json names it
  std::size_t samples = 0;  // rows with a usable time
  double rate_hz = 0.0;     // 1 / median step
  double start_s = 0.0;     // on the reference's clock
  double duration_s = 0.0;
  std::size_t gaps = 0;  // steps longer than 1.8 times the median
};

struct ReferenceFile {
  Reference reference;
  ReferenceFacts facts;
};

// Columns time_s, per segment NAME_qw.._qz, per point (a joint, or a recorded segment) NAME_px, _py
// and, unless the reference has no height, _pz [m]. An empty cell is a gap (NaN). A reference whose
// vertical is y is turned so that z points up: (x, y, z) -> (x, -z, y). Clusters whose turn on the
// segment is known, of every segment in the file, make it a reference of segments.
ReferenceFile ParseReference(std::string_view text, const std::string& file,
                             const ReferenceEntry& entry, const std::set<Segment>& recorded,
                             Findings* findings);

}  // namespace brachium
