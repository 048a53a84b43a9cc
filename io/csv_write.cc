#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "io/csv.h"
#include "io/output_folder.h"

namespace brachium {
namespace {

constexpr std::size_t kLongestNumber = 25;  // "-1.2345678901234567e-308" and a comma
constexpr std::size_t kBufferSize = std::size_t{1} << 18;

std::string Header(const std::vector<CsvColumn>& columns) {
  std::string line;
  for (const CsvColumn& column : columns) line += column.name + ",";
  if (!line.empty()) line.back() = '\n';
  return line;
}

// A number of at most six decimals, as most of a recording's are, from its millionths: three times as
// fast as what serves every number, to the same text. Null if it is not such a number, or one that is
// shorter in exponential notation.
char* PrintDecimal(double value, char* at) {
  const double magnitude = std::abs(value);
  if (!(magnitude >= 1e-3 && magnitude < 1e5)) return nullptr;
  const auto millionths = static_cast<std::int64_t>(magnitude * 1e6 + 0.5);
  if (static_cast<double>(millionths) / 1e6 != magnitude) return nullptr;
  if (value < 0) *at++ = '-';
  at = std::to_chars(at, at + kLongestNumber, millionths / 1'000'000).ptr;
  auto fraction = static_cast<std::uint32_t>(millionths % 1'000'000);
  if (fraction == 0) return at;
  *at++ = '.';
  for (std::uint32_t unit = 100'000; fraction > 0; unit /= 10) {
    *at++ = static_cast<char>('0' + fraction / unit);
    fraction %= unit;
  }
  return at;
}

char* Print(double value, char* at) {
  if (std::isnan(value)) return at;
  if (char* const end = PrintDecimal(value, at)) return end;
  return std::to_chars(at, at + kLongestNumber, value).ptr;
}

}  // namespace

CsvWriter::CsvWriter(const std::string& file) : output_(std::make_unique<OutputFile>(file)) {}

CsvWriter::~CsvWriter() = default;

void CsvWriter::Append(std::size_t rows, const std::vector<CsvColumn>& columns) {
  if (!has_header_) output_->Append(Header(columns));
  has_header_ = true;
  std::vector<char> buffer(kBufferSize + kLongestNumber * (columns.size() + 1));
  char* at = buffer.data();
  for (std::size_t row = 0; row < rows && !columns.empty(); ++row) {
    for (const CsvColumn& column : columns) {
      at = Print(column.first[row * column.stride], at);
      *at++ = ',';
    }
    at[-1] = '\n';
    if (at < buffer.data() + kBufferSize) continue;
    output_->Append({buffer.data(), at});
    at = buffer.data();
  }
  output_->Append({buffer.data(), at});
}

void CsvWriter::Close() { output_->Close(); }

void WriteCsv(const std::string& file, std::size_t rows, const std::vector<CsvColumn>& columns) {
  CsvWriter writer(file);
  writer.Append(rows, columns);
  writer.Close();
}

}  // namespace brachium
