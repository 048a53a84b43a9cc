#include "bin/flags.h"

#include <gflags/gflags.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

#include "io/text.h"

namespace brachium {
namespace {

constexpr int kDeepestFlagfile = 8;

std::string Trim(const std::string& text) {
  const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// "--name=value", "--name" or "-name" in its two parts; `value` is absent without "=".
struct SplitFlag {
  std::string name;
  std::optional<std::string> value;
};

SplitFlag Split(const std::string& text) {
  const std::size_t start = text.starts_with("--") ? 2 : 1;
  const std::size_t equals = text.find('=', start);
  if (equals == std::string::npos) return {text.substr(start), std::nullopt};
  return {text.substr(start, equals - start), text.substr(equals + 1)};
}

bool IsFlag(const std::string& text) { return text.size() > 1 && text[0] == '-'; }

std::string ExpectedValue(const Flag& flag) {
  constexpr const char* kExpected[] = {"true or false", "a whole number", "a number", "text"};
  return kExpected[flag.field.index()];
}

bool IsTruth(const Flag& flag) { return std::holds_alternative<bool*>(flag.field); }

}  // namespace

std::string Text(const FlagValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* whole = std::get_if<int>(&value)) return std::to_string(*whole);
  return Shortest(std::get<double>(value));
}

FlagValue Flag::Value() const {
  return std::visit([](const auto* value) { return FlagValue(*value); }, field);
}

CommandLine::CommandLine(std::string command, const std::vector<std::string>& words)
    : command_(std::move(command)), typed_(words) {
  Expand(words, 0);
}

void CommandLine::Expand(const std::vector<std::string>& words, int depth) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const SplitFlag flag = Split(words[i]);
    if (!IsFlag(words[i]) || flag.name != "flagfile") {
      words_.push_back({words[i], ""});
    } else if (flag.value) {
      ExpandFile(*flag.value, depth);
    } else {
      if (++i == words.size()) throw UsageError("--flagfile needs a file");
      ExpandFile(words[i], depth);
    }
  }
}

void CommandLine::ExpandFile(const std::string& path, int depth) {
  if (depth == kDeepestFlagfile)
    throw UsageError(path + ": flag files name each other in a circle");
  std::ifstream file(path);
  if (!file) throw UsageError(path + ": the flag file cannot be read");
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    const std::string text = Trim(line);
    if (text.empty() || text[0] == '#') continue;
    const std::string origin = path + ":" + std::to_string(number) + ": ";
    if (!IsFlag(text)) throw UsageError(origin + "'" + text + "', but --name=value was expected");
    const SplitFlag flag = Split(text);
    if (flag.name == "flagfile")
      ExpandFile(flag.value.value_or(""), depth + 1);
    else
      words_.push_back({text, origin});
  }
}

void CommandLine::Register(const std::string& group, const char* name, FlagField field,
                           const char* help) {
  Flag& flag = flags_.emplace_back(Flag{name, help, group, field, {}});
  flag.default_value = flag.Value();
}

void CommandLine::RegisterWithGflags(Flag& flag) const {
  std::visit(
      [&](auto* current) {
        auto* default_value =
            &std::get<std::remove_pointer_t<decltype(current)>>(flag.default_value);
        gflags::FlagRegisterer(flag.name.c_str(), flag.help.c_str(), command_.c_str(), current,
                               default_value);
      },
      flag.field);
}

std::string CommandLine::Peek(const std::string& name, const std::string& default_value) const {
  std::string found = default_value;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if (!IsFlag(words_[i].text)) continue;
    const SplitFlag flag = Split(words_[i].text);
    if (flag.name != name) continue;
    if (flag.value)
      found = *flag.value;
    else if (i + 1 < words_.size())
      found = words_[i + 1].text;
  }
  return found;
}

bool CommandLine::AsksForHelp() const {
  return AsksForManual() || std::any_of(words_.begin(), words_.end(), [](const Word& word) {
           return word.text == "--help" || word.text == "-help" || word.text == "-h";
         });
}

bool CommandLine::AsksForManual() const {
  return std::any_of(words_.begin(), words_.end(),
                     [](const Word& word) { return word.text == kAskManual; });
}

std::string CommandLine::text() const {
  std::string text = "brachium " + command_;
  for (const std::string& word : typed_) text += " " + word;
  return text;
}

const Flag* CommandLine::Find(const std::string& name) const {
  const auto found = std::find_if(flags_.begin(), flags_.end(),
                                  [&](const Flag& flag) { return flag.name == name; });
  return found == flags_.end() ? nullptr : &*found;
}

// The flag that --noNAME sets to false, if NAME is one of true or false.
const Flag* CommandLine::FindNegated(const std::string& name) const {
  const Flag* flag = name.starts_with("no") ? Find(name.substr(2)) : nullptr;
  return flag != nullptr && IsTruth(*flag) ? flag : nullptr;
}

void CommandLine::Read() {
  for (Flag& flag : flags_) RegisterWithGflags(flag);
  for (std::size_t word = 0; word < words_.size();) word = ReadFlag(word);
}

// Sets the flag at `word` and returns the place of the next one.
std::size_t CommandLine::ReadFlag(std::size_t word) {
  const auto& [text, origin] = words_[word];
  if (!IsFlag(text))
    throw UsageError(origin + "'" + text + "' is no flag; write --name=value, see brachium " +
                     command_ + " --help");
  const SplitFlag split = Split(text);
  if (const Flag* flag = FindNegated(split.name); flag != nullptr && !split.value) {
    Set(*flag, "false", origin);
    return word + 1;
  }
  const Flag* flag = Find(split.name);
  if (flag == nullptr) RefuseUnknown(words_[word], split.name);
  if (split.value || IsTruth(*flag)) {
    Set(*flag, split.value.value_or("true"), origin);
    return word + 1;
  }
  if (!origin.empty() || word + 1 == words_.size() || !words_[word + 1].origin.empty())
    throw UsageError(origin + "--" + flag->name + " needs " + ExpectedValue(*flag));
  Set(*flag, words_[word + 1].text, origin);
  return word + 2;
}

void CommandLine::Set(const Flag& flag, const std::string& value, const std::string& origin) const {
  const bool parsed = !gflags::SetCommandLineOption(flag.name.c_str(), value.c_str()).empty();
  auto* const* number = std::get_if<double*>(&flag.field);
  if (!parsed || (number != nullptr && !std::isfinite(**number)))
    throw UsageError(origin + "--" + flag.name + "=" + value + ": " + ExpectedValue(flag) +
                     " was expected");
}

void CommandLine::RefuseUnknown(const Word& word, const std::string& name) const {
  std::vector<std::string_view> names;
  for (const Flag& flag : flags_) names.push_back(flag.name);
  std::string command = command_;
  for (const std::string chosen : {"method", "methods"})
    if (const std::string methods = Peek(chosen, ""); !methods.empty())
      command += " --" + chosen + "=" + methods;
  throw UsageError(word.origin + "unknown flag --" + name + DidYouMean(name, names) +
                   " (see brachium " + command + " --help)");
}

std::vector<std::pair<std::string, std::string>> CommandLine::RunFlags(
    const std::vector<std::string>& without) const {
  std::vector<std::pair<std::string, std::string>> flags;
  for (const Flag& flag : flags_)
    if (std::find(without.begin(), without.end(), flag.name) == without.end())
      flags.emplace_back(flag.name, Text(flag.Value()));
  return flags;
}

void RequireGiven(const std::string& value, const std::string& name) {
  if (value.empty()) throw UsageError("--" + name + " is missing");
}

}  // namespace brachium
