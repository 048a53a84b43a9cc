// JSON files that know where each of their values stands, so that errors can say so.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace brachium {

struct JsonFile {
  std::string name;  // as errors call it
  nlohmann::json value;
  std::map<std::string, std::size_t> lines;  // of each key path
};

// A value in a JSON file, with its path: "arm.segments.forearm.length_m", "recordings[1].file".
// Every mistake it meets is an InputError `file:line: path ...`.
class JsonNode {
 public:
  // Throws InputError for a syntax error, a key given twice, and a depth that no file here has.
  static JsonNode Parse(std::string_view text, const std::string& file);

  const std::string& path() const { return path_; }
  bool IsText() const { return value_->is_string(); }
  bool IsList() const { return value_->is_array(); }
  bool IsNull() const { return value_->is_null(); }
  bool Has(const std::string& key) const { return Find(key).has_value(); }

  // A member of this object; Find() takes null for absent.
  JsonNode At(const std::string& key) const;
  std::optional<JsonNode> Find(const std::string& key) const;
  std::vector<std::pair<std::string, JsonNode>> Members() const;
  std::vector<JsonNode> Elements() const;

  std::string Text() const;
  bool Truth() const;
  double Number() const;          // finite
  double NumberFromZero() const;  // >= 0
  double PositiveNumber() const;  // > 0
  std::vector<double> Numbers(std::size_t count) const;

  // A sentence for each key that is not known, with the nearest that is.
  void WarnOfUnknownKeys(std::span<const std::string_view> known,
                         std::vector<std::string>* warnings) const;

  [[noreturn]] void Fail(const std::string& what) const;

 private:
  JsonNode(std::shared_ptr<const JsonFile> file, const nlohmann::json* value, std::string path)
      : file_(std::move(file)), value_(value), path_(std::move(path)) {}

  JsonNode Child(const nlohmann::json& value, const std::string& key) const;
  void ExpectObject() const;
  std::size_t Line() const;

  std::shared_ptr<const JsonFile> file_;
  const nlohmann::json* value_;
  std::string path_;
};

}  // namespace brachium
