// Series over time as charts show them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/plot/chart.h"
#include "io/report/reported.h"

namespace brachium {

// A series in the unit of a chart; a deviation that is not known is NaN, or absent for all.
struct ShownSeries {
  std::vector<double> time{}, value{}, sd{};
};

// The angles that a report shows [deg], by name, in the order of estimate.csv: joint angles, or of
// segments without any the inclination of their y axis.
std::vector<std::pair<std::string, ShownSeries>> ShownAngles(const Estimate& estimate);

// The reference's joint angle of that name at its own instants [deg]; empty when not known.
ShownSeries ReferenceAngle(const ReportedEstimate& reported, const std::string& name);

// When all segments that the estimate knows were at rest.
std::vector<Span> CommonRests(const Estimate& estimate);

// Adds a line of no more than `most` samples and, where deviations are known, the band between
// value ± factor * sd about it.
void AddWithBand(const ShownSeries& series, const std::string& name, const std::string& band_name,
                 const Stroke& stroke, double factor, std::size_t most, Chart* chart);

// A chart over time with the rests shaded.
Chart ChartOverTime(const std::string& title, const std::string& unit,
                    const std::vector<Span>& rests);

// "elbow_flexion" as "elbow flexion".
std::string Spoken(std::string name);

inline constexpr double kNineteenOfTwenty = 1.96;  // standard deviations to either side

}  // namespace brachium
