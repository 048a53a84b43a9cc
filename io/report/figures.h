// The figures of a report: as charts, which a page can make live, and as SVG of the same charts.
#pragma once

#include <string>
#include <vector>

#include "io/plot/chart.h"
#include "io/report/reported.h"

namespace brachium {

struct ReportFigure {
  std::string name{};           // for a file: "joint_angles"
  std::string caption{};        // what it shows and how to read it
  std::vector<Chart> charts{};  // over time; none: a picture only
  std::string svg{};            // of all of it
  ChartSize size{};             // of each chart in it
};

// Angles in deg over time with 95 % bands, rests of all sensors shaded and the reference's angles
// over them: joint angles, or of segments without any the inclination. No more than `most` samples
// of a series, those that stand out among them.
ReportFigure AnglesFigure(const ReportedEstimate& reported, std::size_t most);

// The most distal point, coordinate by coordinate, with 95 % bands. Without a point no charts.
ReportFigure PointFigure(const ReportedEstimate& reported, std::size_t most);

// Errors against the reference over time: joint angles with their bounds of 3 standard deviations,
// orientations between segments, points. Without a reference no charts.
ReportFigure ErrorsFigure(const ReportedEstimate& reported, std::size_t most);

// Differences of joint angles over their means. Without such angles in the reference empty.
ReportFigure AgreementFigure(const ReportedEstimate& reported);

// The rms of each kind of whitened residual, with the bounds of 3 standard deviations that its count
// allows about 1: ± 3/sqrt(2n).
ReportFigure ResidualsFigure(const ReportedEstimate& reported);

// What held the headings (headings_figure.h).
ReportFigure ObservabilityFigure(const ReportedEstimate& reported);

// The joint angles of several estimates of one trial over one another.
ReportFigure OverlaidAnglesFigure(const std::vector<const ReportedEstimate*>& estimates,
                                  std::size_t most);

}  // namespace brachium
