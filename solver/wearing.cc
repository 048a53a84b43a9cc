#include "solver/wearing.h"

#include <set>

namespace brachium {

bool IsWholeChain(const Observations& observations, std::string* why) {
  std::set<Segment> segments;
  for (const Recording& recording : observations.recordings) {
    segments.insert(recording.segment);
    if (observations.recordings.size() == 1 || recording.mounting) continue;
    *why = "the mounting of the sensor on the " + std::string(Name(recording.segment)) +
           " is missing: give its q_BS_wxyz and p_BS_m in trial.json, from a calibration";
    return false;
  }
  const bool has_thorax = segments.erase(Segment::kThorax) > 0;
  if (segments.empty()) return true;
  if (has_thorax && *segments.begin() > Segment::kUpperArm) {
    *why =
        "there is no recording of the upper arm, which joins the thorax to the others: add it, or "
        "leave out the thorax";
    return false;
  }
  for (const Segment segment : kSegments) {
    if (segment < *segments.begin() || segment > *segments.rbegin()) continue;
    if (segments.contains(segment)) continue;
    *why = "there is no recording of the " + std::string(Name(segment)) +
           ", which joins the segments that have one: add it, or leave out those beyond it";
    return false;
  }
  return true;
}

}  // namespace brachium
