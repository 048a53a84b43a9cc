// A recording's table that is too long to be held.
#pragma once

#include <memory>
#include <string>

#include "io/clock.h"
#include "io/csv_blocks.h"
#include "io/recording_csv.h"
#include "problems/sample_source.h"

namespace brachium {

// What a first reading finds in a file from end to end.
struct RecordingSurvey {
  RecordingFacts facts;
  std::string sha256;
  double first = 0.0, last = 0.0;  // samples [s]
  Recording head;                  // the first 100 000 samples at most
};

// Reads all of it once, and says and refuses what ParseRecording does, but for mistakes that only
// the numbers give away: these are looked for in the head. A row without magnetic field or
// orientation is used, because who streams needs neither.
RecordingSurvey SurveyRecording(const std::string& file, const std::string& name, Segment segment,
                                Findings* findings);

// The samples of a file that was surveyed and has not changed since.
class StreamedRecording final : public SampleSource {
 public:
  StreamedRecording(const std::string& file, const RecordingSurvey& survey);
  double First() const override { return first_; }
  double Last() const override { return last_; }

 private:
  bool ReadOn(Recording& held) override;

  double first_, last_;
  CsvBlocks blocks_;
  LaterTimes times_;
  Recording latest_;  // one sample, which a later row may replace
};

}  // namespace brachium
