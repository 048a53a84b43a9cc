#include "io/formats/export_format.h"

#include <algorithm>
#include <array>

namespace brachium {
namespace {

constexpr std::array kFormats = {
    ExportFormat{"xsens_mt", "Xsens MT Manager, ASCII (.txt), one file per sensor", ReadXsensMt},
    ExportFormat{"xsens_dot", "Xsens and Movella DOT, CSV, one file per sensor", ReadXsensDot},
    ExportFormat{"apdm", "APDM Opal, CSV, all sensors in one file", ReadApdm},
    ExportFormat{"xio", "x-io, CSV with units in the header, one file per sensor", ReadXio},
    ExportFormat{"motion_bids", "Motion-BIDS, *_motion.tsv beside its channels and json",
                 ReadMotionBids},
};

}  // namespace

std::span<const ExportFormat> ExportFormats() { return kFormats; }

const ExportFormat* FindExportFormat(std::string_view name) {
  const auto* const found = std::ranges::find(kFormats, name, &ExportFormat::name);
  return found == kFormats.end() ? nullptr : found;
}

}  // namespace brachium
