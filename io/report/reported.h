// What a report shows.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/run_info.h"
#include "problems/evaluation.h"

namespace brachium {

struct ReportedEstimate {
  std::string name{};   // unlike any other's in the report
  std::string label{};  // by which it differs from others of the same trial: its method
  Estimate estimate{};
  RunInfo run{};
  std::optional<Reference> reference{};    // of its trial
  std::optional<Evaluation> evaluation{};  // beside it
  std::string reference_note{};            // which reference that is, or why there is none
};

// A comparison or a sweep: what brachium compare and brachium sweep merge left in their folder.
struct ReportedFolder {
  enum class Kind { kComparison, kSweep };
  Kind kind = Kind::kComparison;
  std::string name{};
  nlohmann::ordered_json json{};                  // comparison.json or sweep.json
  std::map<std::string, std::string> pictures{};  // file name -> SVG
};

struct Report {
  std::string version{};  // of the program
  std::vector<ReportedEstimate> estimates{};
  std::vector<ReportedFolder> folders{};
};

}  // namespace brachium
