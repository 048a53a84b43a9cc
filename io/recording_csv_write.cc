#include "io/csv_columns.h"
#include "io/recording_csv.h"

namespace brachium {

void WriteRecording(const Recording& recording, const std::string& file) {
  std::vector<CsvColumn> columns = {{"time_s", recording.time.data(), 1}};
  AddVector("gyr_", recording.gyr_S, &columns);
  AddVector("acc_", recording.acc_S, &columns);
  AddVector("mag_", recording.mag_S, &columns);
  AddRotation("q_", recording.q_WS, &columns);
  WriteCsv(file, recording.size(), columns);
}

}  // namespace brachium
