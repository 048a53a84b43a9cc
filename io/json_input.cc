#include "io/json_input.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "io/input_error.h"
#include "io/text.h"

namespace brachium {
namespace {

using nlohmann::json;

constexpr std::size_t kDeepest = 32;

// Walks over the text and counts its lines.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  std::size_t* line;

  reference operator*() const { return *at; }
  CountingIterator& operator++() {
    if (*at == '\n') ++*line;
    ++at;
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at == other.at; }
};

std::string Joined(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

std::string Indexed(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

// The library's message without its number and position.
std::string Essence(std::string message) {
  const std::size_t number = message.find("] ");
  if (number != message.npos) message.erase(0, number + 2);
  const std::size_t position = message.find(": ");
  if (message.starts_with("parse error at ") && position != message.npos)
    message.erase(0, position + 2);
  return message;
}

// Notes on which line each key, and each element that is an object, begins.
class LineRecorder : public nlohmann::json_sax<json> {
 public:
  LineRecorder(std::string_view text, JsonFile* file, const std::size_t* line)
      : text_(text), file_(*file), line_(*line) {}

  bool null() override { return Value(); }
  bool boolean(bool) override { return Value(); }
  bool number_integer(number_integer_t) override { return Value(); }
  bool number_unsigned(number_unsigned_t) override { return Value(); }
  bool number_float(number_float_t, const string_t&) override { return Value(); }
  bool string(string_t&) override { return Value(); }
  bool binary(binary_t&) override { return Value(); }
  bool start_object(std::size_t) override { return Open(false); }
  bool start_array(std::size_t) override { return Open(true); }
  bool end_object() override { return Close(); }
  bool end_array() override { return Close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.value_path = Joined(level.path, name);
    if (!file_.lines.emplace(level.value_path, line_).second)
      throw InputError(file_.name, line_, level.value_path + " is given twice; expected once");
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    const auto read = text_.substr(0, std::max<std::size_t>(position, 1) - 1);
    const auto line = 1 + static_cast<std::size_t>(std::ranges::count(read, '\n'));
    throw InputError(file_.name, line, "is not valid JSON: " + Essence(error.what()));
  }

 private:
  struct Level {
    std::string path;  // of the object or array
    bool is_array;
    std::size_t count = 0;   // elements so far
    std::string value_path;  // of the member that comes next
  };

  std::string NextPath() {
    if (levels_.empty()) return "";
    Level& level = levels_.back();
    return level.is_array ? Indexed(level.path, level.count++) : level.value_path;
  }

  bool Value() {
    NextPath();
    return true;
  }

  bool Open(bool is_array) {
    if (levels_.size() == kDeepest)
      throw InputError(file_.name, line_, "is nested more than 32 levels deep");
    std::string path = NextPath();
    file_.lines.emplace(path, line_);
    levels_.push_back({.path = std::move(path), .is_array = is_array, .value_path = {}});
    return true;
  }

  bool Close() {
    levels_.pop_back();
    return true;
  }

  const std::string_view text_;
  JsonFile& file_;
  const std::size_t& line_;
  std::vector<Level> levels_;
};

void RecordLines(std::string_view text, JsonFile* file) {
  std::size_t line = 1;
  LineRecorder recorder(text, file, &line);
  const char* const end = text.data() + text.size();
  json::sax_parse(CountingIterator{text.data(), &line}, CountingIterator{end, &line}, &recorder);
}

}  // namespace

JsonNode JsonNode::Parse(std::string_view text, const std::string& name) {
  const auto file = std::make_shared<JsonFile>();
  file->name = name;
  if (text.empty()) throw InputError(name, 0, "is empty; expected JSON");
  RecordLines(text, file.get());
  file->value = json::parse(text);
  return JsonNode(file, &file->value, "");
}

JsonNode JsonNode::Child(const json& value, const std::string& key) const {
  return JsonNode(file_, &value, Joined(path_, key));
}

std::size_t JsonNode::Line() const {
  const auto own = file_->lines.find(path_);
  if (own != file_->lines.end()) return own->second;
  const auto around = file_->lines.find(path_.substr(0, path_.rfind('[')));
  return around != file_->lines.end() ? around->second : 1;
}

void JsonNode::Fail(const std::string& what) const {
  throw InputError(file_->name, Line(), (path_.empty() ? "the file" : path_) + " " + what);
}

void JsonNode::ExpectObject() const {
  if (!value_->is_object()) Fail("is not an object; expected {...}");
}

std::optional<JsonNode> JsonNode::Find(const std::string& key) const {
  ExpectObject();
  const auto found = value_->find(key);
  if (found == value_->end() || found->is_null()) return std::nullopt;
  return Child(*found, key);
}

JsonNode JsonNode::At(const std::string& key) const {
  const auto found = Find(key);
  if (!found)
    throw InputError(file_->name, Line(), Joined(path_, key) + " is missing; it is required");
  return *found;
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::Members() const {
  ExpectObject();
  std::vector<std::pair<std::string, JsonNode>> members;
  for (const auto& [key, value] : value_->items()) members.emplace_back(key, Child(value, key));
  return members;
}

std::vector<JsonNode> JsonNode::Elements() const {
  if (!value_->is_array()) Fail("is not a list; expected [...]");
  std::vector<JsonNode> elements;
  for (std::size_t i = 0; i < value_->size(); ++i)
    elements.push_back(JsonNode(file_, &(*value_)[i], Indexed(path_, i)));
  return elements;
}

std::string JsonNode::Text() const {
  if (!value_->is_string())
    Fail("is " + value_->dump().substr(0, 40) + "; expected text in quotes");
  return value_->get<std::string>();
}

bool JsonNode::Truth() const {
  if (!value_->is_boolean())
    Fail("is " + value_->dump().substr(0, 40) + "; expected true or false");
  return value_->get<bool>();
}

double JsonNode::Number() const {
  if (!value_->is_number()) Fail("is " + value_->dump().substr(0, 40) + "; expected a number");
  return value_->get<double>();
}

double JsonNode::NumberFromZero() const {
  const double number = Number();
  if (!(number >= 0.0)) Fail("is " + Shortest(number) + "; expected zero or a greater number");
  return number;
}

double JsonNode::PositiveNumber() const {
  const double number = Number();
  if (!(number > 0.0)) Fail("is " + Shortest(number) + "; expected a number greater than zero");
  return number;
}

std::vector<double> JsonNode::Numbers(std::size_t count) const {
  const std::vector<JsonNode> elements = Elements();
  if (elements.size() != count)
    Fail("has " + std::to_string(elements.size()) + " numbers; expected " + std::to_string(count));
  std::vector<double> numbers;
  for (const JsonNode& element : elements) numbers.push_back(element.Number());
  return numbers;
}

void JsonNode::WarnOfUnknownKeys(std::span<const std::string_view> known,
                                 std::vector<std::string>* warnings) const {
  const std::string file = std::filesystem::path(file_->name).filename().string();
  for (const auto& [key, node] : Members())
    if (std::ranges::find(known, std::string_view(key)) == known.end())
      warnings->push_back(file + ":" + std::to_string(node.Line()) + ": " + node.path() +
                          " is not a known key and was ignored" + DidYouMean(key, known));
}

}  // namespace brachium
