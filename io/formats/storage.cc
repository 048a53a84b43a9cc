// OpenSim's .sto and .mot, and .trc.
#include <algorithm>

#include "io/formats/export_table.h"
#include "io/formats/motion_table.h"
#include "io/input_error.h"

namespace brachium {
namespace {

struct Header {
  bool in_degrees = false;
  std::string data_type;
};

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

Header ReadHeader(const std::string& file, Lines* lines) {
  Header header;
  while (!lines->AtEnd()) {
    const std::string line = Lower(lines->Next());
    if (line == "endheader") return header;
    if (line == "indegrees=yes") header.in_degrees = true;
    if (line.starts_with("datatype=")) header.data_type = line.substr(9);
  }
  throw InputError(file, 0, "has no line 'endheader'; expected an OpenSim storage file");
}

std::string_view NextFilled(Lines* lines) {
  std::string_view line = lines->Next();
  while (!lines->AtEnd() && line.find_first_not_of(" \t") == line.npos) line = lines->Next();
  return line;
}

std::vector<std::string> Endings(const std::string& data_type) {
  if (data_type == "quaternion") return {"_qw", "_qx", "_qy", "_qz"};
  if (data_type == "vec3") return {"_px", "_py", "_pz"};
  return {""};
}

// Without blank lines at its beginning; `first_line` counts them.
std::string_view SkipBlankLines(std::string_view text, std::size_t* first_line) {
  for (auto end = text.find('\n');
       end != text.npos && text.substr(0, end).find_first_not_of(" \t\r") == text.npos;
       end = text.find('\n')) {
    text.remove_prefix(end + 1);
    ++*first_line;
  }
  return text;
}

double MarkerUnit(const std::string& unit, const std::string& file) {
  if (unit == "m") return 1.0;
  if (unit == "mm") return 1e-3;
  if (unit == "cm") return 1e-2;
  throw InputError(file, 3, "has the unit '" + unit + "'; expected m, cm or mm");
}

}  // namespace

StorageTable ParseStorage(std::string_view text, const std::string& file) {
  Lines lines(PlainText(text, file));
  const Header header = ReadHeader(file, &lines);
  const std::string_view labels = NextFilled(&lines);
  const std::vector<std::string> endings = Endings(header.data_type);
  CsvLayout layout;
  layout.delimiter = '\t';
  layout.spare_delimiter = true;
  for (const std::string& label : SplitCells(labels, '\t')) {
    if (layout.names.empty()) {
      layout.names.push_back(Lower(label) == "time" ? "time_s" : label);
      continue;
    }
    for (const std::string& ending : endings)
      layout.names.push_back(label.empty() ? "" : label + ending);
  }
  while (layout.names.size() > 1 && layout.names.back().empty()) layout.names.pop_back();
  std::string rows(lines.rest());
  if (endings.size() > 1) std::ranges::replace(rows, ',', '\t');
  layout.first_line = lines.number() + 1;
  return {header.in_degrees, ParseRows(rows, file, layout)};
}

CsvTable ParseTrc(std::string_view text, const std::string& file) {
  Lines lines(PlainText(text, file));
  lines.Next();
  const std::vector<std::string> keys = SplitCells(lines.Next(), '\t');
  const std::vector<std::string> values = SplitCells(lines.Next(), '\t');
  const auto units = static_cast<std::size_t>(std::ranges::find(keys, "Units") - keys.begin());
  if (units >= values.size())
    throw InputError(file, 2, "has no Units; expected a .trc file's second and third line");
  const double unit = MarkerUnit(values[units], file);
  CsvLayout layout;
  layout.delimiter = '\t';
  layout.spare_delimiter = true;
  for (const std::string& marker : SplitCells(lines.Next(), '\t')) {
    if (layout.names.size() < 2)
      layout.names.push_back(layout.names.empty() ? "" : "time_s");
    else if (!marker.empty())
      for (const char axis : {'x', 'y', 'z'}) layout.names.push_back(marker + "_p" + axis);
  }
  lines.Next();
  layout.first_line = lines.number() + 1;
  const std::string_view rows = SkipBlankLines(lines.rest(), &layout.first_line);
  CsvTable table = ParseRows(rows, file, layout);
  for (std::size_t c = 2; c < table.columns.size(); ++c)
    for (double& value : table.columns[c]) value *= unit;
  return table;
}

CsvTable ParseMotion(std::string_view text, const std::string& file, const ColumnFilter& wanted) {
  if (file.ends_with(".sto") || file.ends_with(".mot")) return ParseStorage(text, file).table;
  if (file.ends_with(".trc")) return ParseTrc(text, file);
  if (file.ends_with(".mvnx")) return ParseMvnx(text, file);
  return ParseCsv(text, file, wanted);
}

}  // namespace brachium
