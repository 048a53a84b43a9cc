// The tables of a report, as HTML.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "io/report/reported.h"

namespace brachium {

// How the estimate came about, and whether it may be trusted.
std::string FactsHtml(const ReportedEstimate& reported);

// What its maker and its reader should know: notes, warnings, repairs, defaults.
std::string RemarksHtml(const ReportedEstimate& reported);

// Errors of joint angles, between segments, and of points; nothing without a reference.
std::string ErrorTables(const ReportedEstimate& reported);

std::string ResidualTable(const ReportedEstimate& reported);

// Constants with their standard deviations, and what only priors hold.
std::string ConstantTable(const ReportedEstimate& reported);

// Movements one by one, and how far each joint went; beside the reference's where there is one.
std::string MovementTables(const ReportedEstimate& reported);

// The rmse of each method on each trial, of a comparison.json.
std::string ComparisonTables(const nlohmann::ordered_json& comparison);

// The points chosen, of a sweep.json.
std::string SweepTables(const nlohmann::ordered_json& sweep);

}  // namespace brachium
