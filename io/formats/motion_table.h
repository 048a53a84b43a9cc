// Motions that others computed or measured, as a reference: their files as tables of numbers.
#pragma once

#include <string>
#include <string_view>

#include "io/csv.h"

namespace brachium {

// The table of a reference by the file's extension: .sto and .mot (OpenSim), .trc (markers), .mvnx
// (Xsens MVN), or comma-separated text. Columns are time_s, LABEL_qw.._qz and LABEL_px.._pz [m];
// what is neither keeps its label. `wanted` chooses columns of comma-separated text.
CsvTable ParseMotion(std::string_view text, const std::string& file, const ColumnFilter& wanted);

// OpenSim storage: header lines down to `endheader`, labels, rows. A cell of several numbers, as
// quaternions (w first) and points have them, becomes as many columns.
struct StorageTable {
  bool in_degrees = false;
  CsvTable table;
};
StorageTable ParseStorage(std::string_view text, const std::string& file);

// Marker positions, in m or mm; blanks and NaN are gaps.
CsvTable ParseTrc(std::string_view text, const std::string& file);

// MVNX v3 and v4, after the MVN user manual: `orientation` (segment to world, w first) and
// `position` [m] of the segments in frames of the type "normal"; `jointAngle` as LABEL_zxy_x.._z
// [deg].
CsvTable ParseMvnx(std::string_view text, const std::string& file);

}  // namespace brachium
