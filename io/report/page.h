// The page of a report: one HTML file that needs nothing besides, and its figures as SVG.
#pragma once

#include <map>
#include <string>

#include "io/report/page_files.h"
#include "io/report/reported.h"

namespace brachium {

struct ReportPage {
  std::string html{};
  std::map<std::string, std::string> figures{};  // file name -> SVG
};

// The same bytes for the same report. Its content policy lets nothing in from elsewhere and runs no
// script but its own; text from files is never taken for markup. Long series are shown by the samples
// that stand out, and fewer of each the more estimates there are, so that the file stays small.
ReportPage PageOf(const Report& report, const PageFiles& files);

}  // namespace brachium
