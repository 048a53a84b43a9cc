// brachium import: a trial folder from the exports of makers' programs.
#include <iostream>
#include <string>

#include "bin/commands.h"
#include "bin/estimate_text.h"
#include "bin/help.h"
#include "bin/lists.h"
#include "bin/termination.h"
#include "io/formats/read_export.h"
#include "io/text.h"

namespace brachium {
namespace {

struct ImportFlags {
  std::string format;
  std::string files;
  std::string map;
  std::string side;
  double rate = 0.0;
  std::string output;
  bool overwrite = false;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("format", flags.format, "xsens_mt, xsens_dot, apdm, xio or motion_bids.");
    visit("files", flags.files, "The files of one trial, or folders of them, parted by commas.");
    visit("map", flags.map,
          "Which sensor was worn where: SENSORID:segment,... A sensor goes by its name in the file "
          "or by the beginning of the file's name, in whole words; sensors that are not named are "
          "left out.");
    visit("side", flags.side, "The arm that was recorded, right or left.");
    visit("rate", flags.rate,
          "Samples a second, for files that do not say it [Hz]. 0: as the files say.");
    visit("output", flags.output, "The trial folder to be written.");
    visit("overwrite", flags.overwrite, "Replace an older trial folder.");
  }
};

const CommandHelp kHelp = {
    "--format=NAME --files=A,B --map=SENSORID:segment,... --side=right --output=DIR [flags]",
    "Makes a trial folder from the exports of makers' programs: units become SI, counters that "
    "wrap "
    "go on, lost packets stay gaps, time tags move to the centre of the interval that a sample "
    "averages, and all of it is said. What an export does not tell (lengths, mountings, start "
    "pose) is then to be filled in in trial.json."};

HelpSection FormatList() {
  HelpSection list{"Formats", {}};
  for (const ExportFormat& format : ExportFormats())
    list.items.push_back({std::string(format.name), std::string(format.summary) + "."});
  return list;
}

const ExportFormat& FormatFrom(const std::string& name) {
  if (const ExportFormat* const format = FindExportFormat(name)) return *format;
  std::vector<std::string_view> names;
  for (const ExportFormat& format : ExportFormats()) names.push_back(format.name);
  throw UsageError("--format is '" + name + "'; expected one of " + Listed(names));
}

Side SideFrom(const std::string& name) {
  for (const Side side : {Side::kRight, Side::kLeft})
    if (Name(side) == name) return side;
  throw UsageError("--side is '" + name + "'; expected right or left");
}

std::map<std::string, Segment> MapFrom(const std::string& text) {
  std::map<std::string, Segment> map;
  for (const std::string& pair : SplitList(text)) {
    const auto colon = pair.rfind(':');
    const auto segment =
        colon == pair.npos ? std::nullopt : SegmentFromName(pair.substr(colon + 1));
    if (!segment || colon == 0)
      throw UsageError("--map has '" + pair +
                       "'; expected SENSORID:segment, the segment thorax, girdle, upper_arm, "
                       "forearm or hand");
    for (const auto& [sensor, other] : map)
      if (other == *segment || sensor == pair.substr(0, colon))
        throw UsageError("--map has '" + pair + "' beside '" + sensor +
                         "'; expected each sensor and segment once");
    map[pair.substr(0, colon)] = *segment;
  }
  if (map.empty()) throw UsageError("--map is empty; expected SENSORID:segment,...");
  return map;
}

Import ImportFrom(const ImportFlags& flags) {
  if (flags.rate < 0.0) throw UsageError("--rate is negative; expected samples a second");
  Import import{.format = &FormatFrom(flags.format),
                .files = SplitList(flags.files),
                .segment_of = MapFrom(flags.map),
                .side = SideFrom(flags.side),
                .rate_hz = std::nullopt};
  if (flags.rate > 0.0) import.rate_hz = flags.rate;
  return import;
}

void Print(const ImportedTrial& trial, const std::string& folder) {
  std::cout << "Imported into " << folder << "\n";
  for (std::size_t i = 0; i < trial.recordings.size(); ++i) {
    const RecordingFacts& facts = trial.recordings[i].facts;
    std::cout << "  " << Name(facts.segment) << ": sensor " << trial.sensors[i] << " ("
              << facts.file << "), " << facts.samples << " samples at " << Fixed(facts.rate_hz, 2)
              << " Hz, " << facts.lost_samples << " lost\n";
  }
  std::cout << FindingsText(trial);
}

}  // namespace

int RunImport(CommandLine& line) {
  ImportFlags flags;
  line.Add("Flags", flags);
  if (ShowHelp(line, kHelp, {FormatList()})) return kGood;
  line.Read();
  RequireGiven(flags.format, "format");
  RequireGiven(flags.files, "files");
  RequireGiven(flags.side, "side");
  RequireGiven(flags.output, "output");

  const Import import = ImportFrom(flags);
  const ImportedTrial trial = ReadImport(import);
  {
    const WithoutInterruption writing;
    WriteImport(flags.output, import, trial, flags.overwrite);
  }
  Print(trial, flags.output);
  return kGood;
}

}  // namespace brachium
