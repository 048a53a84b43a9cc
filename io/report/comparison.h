// Several estimates beside one another.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/comparison_figures.h"
#include "io/comparison_folder.h"
#include "io/report/reported.h"

namespace brachium {

struct SideBySide {
  // Trials with several estimates.
  std::vector<std::pair<std::string, std::vector<const ReportedEstimate*>>> by_trial;
  // All estimates that a reference judges, by their labels; without methods when there are fewer
  // than two.
  Comparison comparison;
};

SideBySide SideBySideOf(const std::vector<ReportedEstimate>& estimates);

// What a picture of a comparison or of a sweep shows, by its file's name.
std::string ComparisonCaption(const std::string& file);
std::string SweepCaption(const std::string& file);

// With what file systems dislike replaced by _.
std::string SafeFileName(const std::string& name);

}  // namespace brachium
