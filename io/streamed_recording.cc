#include "io/streamed_recording.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/file_bytes.h"
#include "io/recording_checks.h"
#include "io/recording_columns.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

Vector3d VectorAt(const Columns& columns, std::size_t first, std::size_t row) {
  return {(*columns[first])[row], (*columns[first + 1])[row], (*columns[first + 2])[row]};
}

// One sample in place of what there is.
void Keep(const Columns& recorded, std::size_t row, Recording& one) {
  one.time.assign(1, (*recorded[0])[row]);
  one.gyr_S.assign(1, VectorAt(recorded, 1, row));
  one.acc_S.assign(1, VectorAt(recorded, 4, row));
}

void Append(const Recording& one, Recording& all) {
  all.time.insert(all.time.end(), one.time.begin(), one.time.end());
  all.gyr_S.insert(all.gyr_S.end(), one.gyr_S.begin(), one.gyr_S.end());
  all.acc_S.insert(all.acc_S.end(), one.acc_S.begin(), one.acc_S.end());
  all.mag_S.insert(all.mag_S.end(), one.mag_S.begin(), one.mag_S.end());
  all.q_WS.insert(all.q_WS.end(), one.q_WS.begin(), one.q_WS.end());
}

class Survey {
 public:
  Survey(std::string file, std::string name, Segment segment, Findings* findings)
      : file_(std::move(file)), name_(std::move(name)), findings_(findings) {
    result_.head.segment = segment;
  }

  RecordingSurvey Make() {
    Sha256Sum sum;
    CsvBlocks blocks(file_, IsRecordingColumn, [&](std::string_view part) { sum.Add(part); });
    CsvTable table;
    for (auto block = blocks.Next(); block; block = blocks.Next()) {
      if (rows_ == 0) WarnOfUnknownColumns(*block, name_, findings_);
      Take(*block);
      table = std::move(*block);
    }
    if (!latest_.time.empty()) Finish();
    times_.Check(rows_, file_);
    result_.sha256 = sum.Text();
    Report(table);
    return std::move(result_);
  }

 private:
  void Take(const CsvTable& table) {
    const Columns recorded = FindColumns(table, kRecorded);
    Columns field, orientation;
    if (HasAny(table, kMagnetometer)) field = FindColumns(table, kMagnetometer);
    if (HasAny(table, kOrientation)) orientation = FindColumns(table, kOrientation);
    has_magnetometer_ = !field.empty();
    has_orientation_ = !orientation.empty();
    for (std::size_t row = 0; row < table.rows; ++row) {
      ++rows_;
      const bool has_turn = AllFinite(orientation, row);
      if (!AllFinite(field, row)) ++no_field_;
      if (!has_turn) ++no_turn_;
      if (!AllFinite(recorded, row)) {
        ++not_finite_;
        continue;
      }
      const LaterTimes::Use use = times_.Judge((*recorded[0])[row], table.Line(row));
      if (use == LaterTimes::Use::kNot) continue;
      if (use == LaterTimes::Use::kNext && !latest_.time.empty()) Finish();
      Keep(recorded, row, latest_);
      latest_.q_WS.clear();
      if (has_orientation_ && has_turn)
        latest_.q_WS.push_back(UnitRotation(orientation, row, table));
    }
  }

  // The latest sample is here to stay.
  void Finish() {
    const double time = latest_.time[0];
    if (samples_++ == 0) result_.first = time;
    result_.last = time;
    steps_.Add(time);
    if (result_.head.size() < RunningSteps::kJudged) Append(latest_, result_.head);
  }

  // Says what is mostly empty; whether it is there to be used.
  bool Holds(bool has, std::size_t empty, std::string_view column) {
    if (!has || static_cast<double>(empty) <= kMostEmpty * static_cast<double>(rows_)) return has;
    findings_->repairs.push_back(MostlyEmpty(name_, column, empty));
    return false;
  }

  void Report(const CsvTable& last) {
    const bool field = Holds(has_magnetometer_, no_field_, kMagnetometer[0]);
    const bool turns = Holds(has_orientation_, no_turn_, kOrientation[0]);
    if (result_.head.q_WS.size() < result_.head.size()) result_.head.q_WS.clear();
    const Steps steps = steps_.Measured();
    CheckStepUnit(steps, file_);
    CheckSensorUnits(result_.head, file_, name_, findings_);
    const UsableRows usable{.rows = {}, .not_finite = not_finite_, .not_later = times_.not_later()};
    ReportRows(last, usable, steps, name_, findings_);
    result_.facts = {.segment = result_.head.segment,
                     .file = name_,
                     .samples = samples_,
                     .rate_hz = 1.0 / steps.median,
                     .start_s = result_.first,
                     .duration_s = result_.last - result_.first,
                     .gaps = steps.gaps,
                     .lost_samples = steps.lost,
                     .longest_step_s = steps.longest,
                     .not_finite_rows = not_finite_,
                     .not_later_rows = times_.not_later(),
                     .cut_off = last.cut_off,
                     .magnetometer = field,
                     .orientation = turns};
  }

  const std::string file_, name_;
  Findings* const findings_;
  RecordingSurvey result_;
  LaterTimes times_;
  RunningSteps steps_;
  Recording latest_;
  std::size_t rows_ = 0, samples_ = 0, not_finite_ = 0, no_field_ = 0, no_turn_ = 0;
  bool has_magnetometer_ = false, has_orientation_ = false;
};

}  // namespace

RecordingSurvey SurveyRecording(const std::string& file, const std::string& name, Segment segment,
                                Findings* findings) {
  return Survey(file, name, segment, findings).Make();
}

StreamedRecording::StreamedRecording(const std::string& file, const RecordingSurvey& survey)
    : first_(survey.first), last_(survey.last), blocks_(file, IsRecordingColumn) {}

bool StreamedRecording::ReadOn(Recording& held) {
  const std::optional<CsvTable> table = blocks_.Next();
  if (!table) {
    Append(latest_, held);
    const bool had_one = !latest_.time.empty();
    latest_ = {};
    return had_one;
  }
  const Columns recorded = FindColumns(*table, kRecorded);
  for (std::size_t row = 0; row < table->rows; ++row) {
    if (!AllFinite(recorded, row)) continue;
    const LaterTimes::Use use = times_.Judge((*recorded[0])[row], table->Line(row));
    if (use == LaterTimes::Use::kNot) continue;
    if (use == LaterTimes::Use::kNext) Append(latest_, held);
    Keep(recorded, row, latest_);
  }
  return true;
}

}  // namespace brachium
