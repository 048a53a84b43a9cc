// The motion of an estimate as a table: estimate.csv.
#pragma once

#include <string>

#include "io/csv.h"
#include "problems/estimate.h"

namespace brachium {

// Columns: time_s; per segment, proximal first, NAME_qw.._qz and, where known, the standard
// deviations NAME_rx_sd_deg.._rz_sd_deg about its own axes; per point NAME_px.._pz [m]; joint angles
// [deg] of the joints whose both segments are estimated, of the shoulder against a thorax, and the
// shoulder's elevation in any case. What is not finite is an empty cell.
void WriteEstimateCsv(const Estimate& estimate, const std::string& file);

// The same table, piece after piece of the motion. Throws OutputError.
class EstimateCsvWriter {
 public:
  explicit EstimateCsvWriter(const std::string& file) : writer_(file) {}
  void Append(const Estimate& piece);
  void Close() { writer_.Close(); }

 private:
  CsvWriter writer_;
};

// Time, rotations with their deviations, positions; the angles follow from them. Throws InputError.
Estimate ReadEstimateCsv(const std::string& file);

}  // namespace brachium
