#include "io/contact_check.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "io/text.h"

namespace brachium {
namespace {

constexpr double kAbout = 0.05;            // of an instant [s]
constexpr double kTurning = 60 * kDegree;  // a point 0.2 m away goes 1 cm in that time [rad/s]

// Rms rate about an instant; no sample there: 0.
double RateAt(const Recording& recording, double time) {
  double squares = 0.0;
  int count = 0;
  for (auto at = std::ranges::lower_bound(recording.time, time - kAbout);
       at != recording.time.end() && *at <= time + kAbout; ++at, ++count)
    squares += recording.gyr_S[static_cast<std::size_t>(at - recording.time.begin())].squaredNorm();
  return count > 0 ? std::sqrt(squares / count) : 0.0;
}

void CheckStill(const Contact& contact, const Recording& recording, Findings* findings) {
  for (const double time : contact.times) {
    const double rate = RateAt(recording, time);
    if (rate < kTurning) continue;
    findings->warnings.push_back(
        "contact '" + contact.place + "': " + std::string(Name(recording.segment)) + " turns by " +
        Fixed(rate / kDegree, 0) + " deg/s at " + Fixed(time, 2) +
        " s; name instants at which it is still, or more sigma_m [moving_contact]");
    return;
  }
}

}  // namespace

void CheckContacts(const Observations& observations, Findings* findings) {
  for (const Contact& contact : observations.contacts) {
    if (contact.times.size() == 1)
      findings->warnings.push_back("contact '" + contact.place +
                                   "' names one instant, which tells where the place is and "
                                   "nothing of the arm; name two or more [single_contact]");
    for (const Recording& recording : observations.recordings)
      if (recording.segment == contact.segment) CheckStill(contact, recording, findings);
  }
}

}  // namespace brachium
