// Numeric tables as comma-separated text: the only tokenizer of the program.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace brachium {

class OutputFile;

// A table of numbers.
struct CsvTable {
  std::string file;
  std::vector<std::string> names;            // every column of the header, in its order
  std::vector<std::vector<double>> columns;  // beside `names`; empty where not wanted
  std::size_t rows = 0;
  bool cut_off = false;        // the last line had no end and not all cells: it is left out
  std::size_t first_line = 2;  // of its file, on which row 0 stands

  std::size_t Line(std::size_t row) const { return row + first_line; }

  bool Has(std::string_view name) const;

  // The column of that name. Throws InputError when the header lacks it.
  const std::vector<double>& Column(std::string_view name) const;
};

// Chooses the columns to be read; the others may hold anything. Empty: all.
using ColumnFilter = std::function<bool(std::string_view name)>;

// Reads a table: one header line, then one line per row, cells parted by commas, numbers with a
// decimal point in any locale. An empty cell is NaN. A byte-order mark, CRLF, a missing end of the
// last line and blank lines at the end are fine. Throws InputError, with line and column, for text
// in a number, rows shorter or longer than the header, a column named twice, an empty or binary
// file. `file` is the name that errors carry.
CsvTable ParseCsv(std::string_view text, const std::string& file, const ColumnFilter& wanted = {});
CsvTable ReadCsv(const std::string& file, const ColumnFilter& wanted = {});

// How the rows of a vendor's file are written, below whatever headers it has.
struct CsvLayout {
  std::vector<std::string> names;  // of the columns, as CsvTable has them
  char delimiter = ',';
  std::size_t first_line = 1;     // of the file, on which the first row stands
  std::string_view missing = {};  // a cell that means NaN, besides the empty one
  bool spare_delimiter = false;   // a row may end with one delimiter too many
};

// The same for rows whose header was read before.
CsvTable ParseRows(std::string_view text, const std::string& file, CsvLayout layout,
                   const ColumnFilter& wanted = {});

// The text without a byte-order mark. Throws InputError when it is empty or binary.
std::string_view PlainText(std::string_view text, const std::string& file);

// The cells of a line, blanks and double quotes around them taken off.
std::vector<std::string> SplitCells(std::string_view line, char delimiter);

// A column to be written: `first` is its first number, the next lies `stride` doubles further.
struct CsvColumn {
  std::string name;
  const double* first = nullptr;
  std::size_t stride = 1;
};

// A table in the making, rows after rows. Throws OutputError.
class CsvWriter {
 public:
  explicit CsvWriter(const std::string& file);
  ~CsvWriter();

  // The header comes from the first call; later ones must bring the same columns.
  void Append(std::size_t rows, const std::vector<CsvColumn>& columns);
  void Close();

 private:
  std::unique_ptr<OutputFile> output_;
  bool has_header_ = false;
};

// Writes a table that ReadCsv reads back to the same bits; NaN becomes an empty cell.
// Throws OutputError.
void WriteCsv(const std::string& file, std::size_t rows, const std::vector<CsvColumn>& columns);

}  // namespace brachium
