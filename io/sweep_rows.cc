#include "io/sweep_rows.h"

#include "io/text.h"

namespace brachium {
namespace {

using Outcome = SweepResult::Outcome;

std::string Quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

std::string Joined(const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& cell : cells) text.append(",").append(cell);
  return text;
}

}  // namespace

std::string SweepRows::Head(const SweepTask& task) {
  for (const auto& [name, value] : task.varied.items()) options_.Of(name);
  std::vector<std::string> cells(options_.names().size());
  for (const auto& [name, value] : task.varied.items())
    cells[options_.Of(name)] = value.is_string() ? Quoted(value.get<std::string>()) : value.dump();
  return std::to_string(task.index) + "," + Quoted(task.trial) + "," + task.method + Joined(cells);
}

std::string SweepRows::Tail(const std::optional<SweepResult>& result) {
  if (!result) return std::string(",missing,,").append(figures().size(), ',');
  for (const auto& [name, value] : result->figures) figures_.Of(name);
  std::vector<std::string> cells(figures().size());
  for (const auto& [name, value] : result->figures) cells[figures_.Of(name)] = Shortest(value);
  const bool done = result->outcome == Outcome::kDone;
  cells.insert(cells.begin(),
               {NameOf(result->outcome), done ? std::to_string(int{result->trusted}) : "",
                Quoted(result->reason)});
  return Joined(cells);
}

void SweepRows::Append(const SweepTask& task, const std::optional<SweepResult>& result) {
  const std::string head = Head(task), tail = Tail(result);
  rows_.push_back({head.size(), tail.size(), options_.names().size(), figures().size()});
  text_.Append(head);
  text_.Append(tail);
}

void SweepRows::WriteTo(StreamedFile* csv) {
  csv->Append("task,trial,method" + Joined(options_.names()) + ",outcome,trusted,reason" +
              Joined(figures()) + "\n");
  text_.Rewind();
  for (const Row& row : rows_) {
    csv->Append(text_.Next(row.head).append(options_.names().size() - row.options, ','));
    csv->Append(text_.Next(row.tail).append(figures().size() - row.figures, ',') + "\n");
  }
}

}  // namespace brachium
