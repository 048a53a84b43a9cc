// brachium inspect: what is in a trial folder and what is wrong with it.
#include <Eigen/Core>
#include <iostream>
#include <string>
#include <vector>

#include "bin/commands.h"
#include "bin/estimate_text.h"
#include "bin/help.h"
#include "bin/quietest_second.h"
#include "io/text.h"
#include "io/trial_folder.h"
#include "solver/estimators.h"

namespace brachium {
namespace {

struct InspectFlags {
  std::string trial;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("trial", flags.trial, "The trial folder.");
  }
};

const CommandHelp kHelp = {
    "--trial=DIR",
    "Says what a trial folder holds, what was taken by default, what was repaired, what looks "
    "wrong, and whether it can be reconstructed. Exits with 0 when everything is readable, "
    "complete or not, and with 2 otherwise."};

std::string Plural(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string Triple(const Eigen::Vector3d& v, int digits) {
  std::string text = "(";
  text += Fixed(v.x(), digits) + ", " + Fixed(v.y(), digits) + ", " + Fixed(v.z(), digits);
  return text + ")";
}

std::string Gaps(const RecordingFacts& facts) {
  if (facts.gaps == 0) return "none";
  return Plural(facts.gaps, "gap") + ", " + Plural(facts.lost_samples, "sample") +
         " lost, longest step " + Fixed(facts.longest_step_s, 3) + " s";
}

std::string LeftOut(const RecordingFacts& facts) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (facts.not_finite_rows > 0) add(Plural(facts.not_finite_rows, "row") + " not finite");
  if (facts.not_later_rows > 0) add(Plural(facts.not_later_rows, "row") + " not later than before");
  if (facts.cut_off) add("the cut-off last row");
  return text.empty() ? "nothing" : text;
}

std::string MountingText(const Recording& recording) {
  if (!recording.mounting) return "not known";
  return "known to " + Shortest(recording.mounting->q_sigma / kDegree) + " deg and " +
         Shortest(recording.mounting->p_sigma) + " m per axis, " +
         Triple(recording.mounting->p_BS_B, 3) + " m from the proximal joint";
}

void PrintRecording(const Recording& recording, const RecordingFacts& facts) {
  const QuietestSecond quiet = FindQuietestSecond(recording);
  std::cout << "\n"
            << Name(facts.segment) << " (" << facts.file << ")\n"
            << "  samples         " << facts.samples << " at " << Fixed(facts.rate_hz, 2) << " Hz, "
            << Fixed(facts.duration_s, 2) << " s from " << Fixed(facts.start_s, 3) << " s\n"
            << "  gaps            " << Gaps(facts) << "\n"
            << "  left out        " << LeftOut(facts) << "\n"
            << "  mounting        " << MountingText(recording) << "\n"
            << "  also holds      " << (facts.magnetometer ? "magnetic field" : "no magnetic field")
            << ", " << (facts.orientation ? "the maker's orientation" : "no orientation") << "\n"
            << "  quietest second " << Fixed(quiet.start, 2) << " s to "
            << Fixed(quiet.start + 1.0, 2) << " s\n"
            << "    gyroscope     mean " << Triple(quiet.mean_rate / kDegree, 3) << " deg/s, noise "
            << Fixed(quiet.rate_noise / kDegree, 3) << " deg/s rms\n"
            << "    accelerometer mean size " << Fixed(quiet.mean_force.norm(), 3)
            << " m/s^2, noise " << Fixed(quiet.force_noise, 4) << " m/s^2 rms\n";
}

std::string ContactsText(const std::vector<Contact>& contacts) {
  std::string text;
  for (const Contact& contact : contacts)
    text += (text.empty() ? "" : ", ") + std::string(DistalJointName(contact.segment)) + " at " +
            contact.place + (contact.height_only ? "'s height " : " ") +
            Plural(contact.times.size(), "time");
  return text.empty() ? "none" : text;
}

void PrintTrial(const TrialFolder& folder) {
  const Observations& observations = folder.trial.observations;
  std::cout << "Trial " << folder.trial.name << ": " << Name(observations.arm.side) << " arm, "
            << Plural(observations.recordings.size(), "recording")
            << (folder.simulated ? ", simulated" : "") << "\n";
  for (std::size_t i = 0; i < folder.recordings.size(); ++i)
    PrintRecording(observations.recordings[i], folder.recordings[i]);
  std::cout << "\nintervals         " << observations.intervals.size() << "\nstart pose        "
            << (observations.start_pose ? "stated" : "not stated") << "\nend pose          "
            << (observations.end_pose ? "stated" : "not stated") << "\ncontacts          "
            << ContactsText(observations.contacts) << "\nreference         ";
  if (folder.reference)
    std::cout << folder.reference->file << ", " << folder.reference->samples << " samples at "
              << Fixed(folder.reference->rate_hz, 2) << " Hz, "
              << Plural(folder.reference->gaps, "gap") << "\n\n";
  else
    std::cout << "none, so an estimate cannot be evaluated\n\n";
}

std::string Readiness(const Observations& observations) {
  const auto smoother = MakeEstimator(*DefaultOptions("smoother"));
  if (std::string why; !smoother->Accepts(observations, &why)) return Wrap("Not ready: " + why, 0);
  return "Ready for brachium reconstruct.\n";
}

}  // namespace

int RunInspect(CommandLine& line) {
  InspectFlags flags;
  line.Add("Flags", flags);
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  RequireGiven(flags.trial, "trial");

  const TrialFolder folder = ReadTrial(flags.trial);
  PrintTrial(folder);
  std::cout << FindingsText(folder) << Readiness(folder.trial.observations);
  return kGood;
}

}  // namespace brachium
