// The plan of a sweep: manifest.jsonl, one task a line, never changed once it is written.
//
// Each line is a JSON object: task (its line, from 0), trial (name), path (its folder), duration_s,
// method, options (all of the method), varied (those that the sweep varies), versions, inputs
// (SHA-256 over the names and checksums of the trial's files), and key: SHA-256 of inputs, method,
// options and versions. Two tasks of one key have one result.
#pragma once

#include <cstddef>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/file_parts.h"
#include "io/run_info.h"

namespace brachium {

struct SweepTask {
  std::size_t index = 0;
  std::string trial{}, path{};
  double duration = 0.0;  // of the trial [s]
  std::string method{};
  nlohmann::ordered_json options{}, varied{};  // name -> value
  nlohmann::ordered_json versions{};
  std::string inputs{}, key{};
};

// SHA-256 over the names and checksums of a trial's files.
std::string InputsHash(const std::vector<InputFile>& inputs);

nlohmann::ordered_json VersionsJson(const std::vector<NameValue>& versions);

// Of all that a result follows from; index, place and name of the trial are none of it.
std::string KeyOf(const SweepTask& task);

// The task as its line of the manifest, with a newline.
std::string ManifestLine(const SweepTask& task);

// A manifest on the disk. A task is looked up when it is asked for, by bisection unless it is the
// next one: whoever runs a part of a long sweep reads that part, and none of it is held.
class SweepManifest {
 public:
  // Throws InputError when there is no such file, it is empty, or its last line is cut off.
  explicit SweepManifest(const std::string& file);

  std::size_t size() const { return size_; }

  // From any thread. Throws InputError file:line for a line that is no task, or whose key is not its
  // own.
  SweepTask At(std::size_t index) const;

  const std::string& file() const { return file_; }
  std::string folder() const;  // that it is in: results are beside it

 private:
  struct Place {
    std::size_t index, start;  // of a task, and of its line [byte]
  };

  SweepTask Parse(const std::string& line, std::size_t index) const;
  std::string LineOf(std::size_t index) const;
  std::size_t StartOf(std::size_t index) const;

  std::string file_;
  FileParts text_;
  std::size_t size_ = 0;
  mutable std::mutex mutex_;
  mutable Place next_{0, 0};  // behind the task that was asked for last
};

}  // namespace brachium
