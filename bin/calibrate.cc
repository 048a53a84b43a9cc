// brachium calibrate: how the sensors of a trial sit on their segments, from movements.
#include <iostream>
#include <map>
#include <string>

#include "bin/commands.h"
#include "bin/estimate_text.h"
#include "bin/help.h"
#include "bin/options_json.h"
#include "bin/table.h"
#include "bin/termination.h"
#include "io/calibrated_trial.h"
#include "io/input_error.h"
#include "io/output_folder.h"
#include "io/text.h"
#include "io/trial_folder.h"
#include "solver/calibrate_clusters.h"
#include "solver/self_calibrate.h"

namespace brachium {
namespace {

struct CalibrateFlags {
  std::string trial;
  std::string output;
  std::string from = "movements";
  bool overwrite = false;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("trial", flags.trial, "The trial folder, with calibration: intervals in trial.json.");
    visit("output", flags.output,
          "The file to be written: the trial's trial.json with the mountings found. Called "
          "trial.json and put into a folder, it makes that a trial folder.");
    visit("from", flags.from,
          "movements: those that are labelled; motion: any movement of the elbow, 10 s or more, "
          "nothing being labelled.");
    visit("overwrite", flags.overwrite, "Replace an older file.");
  }
};

const CommandHelp kHelp = {
    "--trial=DIR --output=FILE [--from=motion] [flags]",
    "Finds how each sensor is turned on its segment from movements that the trial has labelled in "
    "its intervals: calibration:forearm_pronation and calibration:forearm_supination (elbow bent, "
    "palm down before a supination and after a pronation), calibration:upper_arm_endorotation and "
    "calibration:upper_arm_exorotation, calibration:upper_arm_abduction (hanging arm, elbow bent), "
    "each interval one movement from a rest to a rest, five of each; or calibration:static_pose in "
    "recordings that carry the maker's orientation. The clusters of a reference whose frames are "
    "clusters are calibrated by the same movements. Refuses, with the reason, what cannot be "
    "calibrated. Where on the segment a sensor sits is not found: measure it. With --from=motion "
    "the sensors of upper arm and forearm are calibrated from whatever the elbow does: its axes, "
    "and where the sensors sit, from the movement; the zeros of flexion and of pronation, which no "
    "movement shows, from the line to the shoulder and from the start pose."};

nlohmann::ordered_json ReportOf(const Calibration& calibration) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const SegmentCalibration& segment : calibration.segments)
    for (const Figure& figure : segment.figures)
      json[std::string(Name(segment.segment))][figure.name] = figure.value;
  json["notes"] = calibration.notes;
  return json;
}

nlohmann::ordered_json ReportOf(const Calibration& sensors, const Calibration& clusters,
                                const CalibrationOptions& options) {
  nlohmann::ordered_json json = ReportOf(sensors);
  json["options"] = ToJson(options);
  if (!clusters.segments.empty() || !clusters.notes.empty()) json["clusters"] = ReportOf(clusters);
  return json;
}

std::string CalibrationText(const Calibration& calibration, const std::string& rotated) {
  if (calibration.segments.empty() && calibration.notes.empty()) return "";
  Table table({"segment", rotated, "sigma [deg]"});
  Table figures({"segment", "figure", "value"});
  for (const SegmentCalibration& segment : calibration.segments) {
    const std::string name(Name(segment.segment));
    const Eigen::Quaterniond& q = segment.mounting.q_BS;
    std::string rotation = Fixed(q.w(), 4);
    for (const double value : {q.x(), q.y(), q.z()}) rotation.append(" ").append(Fixed(value, 4));
    table.Add({name, rotation, Fixed(segment.mounting.q_sigma / kDegree, 2)});
    for (const Figure& figure : segment.figures)
      figures.Add({name, figure.name, Fixed(figure.value, 2)});
  }
  std::string text = table.Text() + "\n" + figures.Text();
  if (!calibration.notes.empty()) text.append("\n").append(Listing("Notes:", calibration.notes));
  return text;
}

void RequireFaultless(const Calibration& calibration, const std::string& trial) {
  if (calibration.faults.empty()) return;
  std::string text = "cannot be calibrated";
  for (const std::string& fault : calibration.faults) text += "\n  " + fault;
  for (const std::string& note : calibration.notes) text += "\n  note: " + note;
  throw InputError(trial + "/trial.json", 0, text);
}

// Where a reference's clusters cannot be calibrated they stay what they were, clusters.
Calibration ClustersOf(const Trial& trial, const CalibrationOptions& options) {
  if (!trial.reference || trial.reference->frames != Reference::Frames::kCluster) return {};
  Calibration clusters = CalibrateClusters(*trial.reference, trial.observations, options);
  for (const std::string& fault : clusters.faults)
    clusters.notes.push_back(fault + "; evaluation goes on turning it freely");
  return clusters;
}

std::map<Segment, Mounting> MountingsOf(const Calibration& calibration) {
  std::map<Segment, Mounting> mountings;
  for (const SegmentCalibration& segment : calibration.segments)
    mountings[segment.segment] = segment.mounting;
  return mountings;
}

}  // namespace

int RunCalibrate(CommandLine& line) {
  CalibrateFlags flags;
  CalibrationOptions options;
  line.Add("Flags", flags);
  line.Add("Flags of the calibration", options);
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  RequireGiven(flags.trial, "trial");
  RequireGiven(flags.output, "output");
  RequireValid(options);
  const bool from_motion = flags.from == "motion";
  if (!from_motion && flags.from != "movements")
    throw UsageError("--from=" + flags.from + " is not known; expected movements or motion");

  const TrialFolder folder = ReadTrial(flags.trial);
  const Calibration calibration = from_motion ? SelfCalibrate(folder.trial.observations, options)
                                              : Calibrate(folder.trial.observations, options);
  RequireFaultless(calibration, flags.trial);
  const Calibration clusters = from_motion ? Calibration{} : ClustersOf(folder.trial, options);
  const std::string text =
      WithMountings(flags.trial, MountingsOf(calibration), MountingsOf(clusters),
                    ReportOf(calibration, clusters, options), flags.output);
  {
    const WithoutInterruption writing;
    WriteOneFile(flags.output, text, flags.overwrite);
  }
  std::cout << "Trial " << folder.trial.name << "\n"
            << CalibrationText(calibration, "q_BS_wxyz") << "\n"
            << CalibrationText(clusters, "q_BC_wxyz of the reference's cluster") << "Mountings in "
            << flags.output << "\n";
  return kGood;
}

}  // namespace brachium
