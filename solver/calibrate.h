// How sensors sit on their segments, from movements that a person was asked for: Luinge, Veltink &
// Baten (2007), Eqs (1)-(5), for either side of the body, and the static pose of Bai et al. (2015).
//
// s = +1 right, -1 left; w the direction of a turn, f the direction of specific force (up) at a rest;
// all in sensor axes, unit vectors, the mean over all repetitions:
//   forearm     Y = s w_pronation = -s w_supination                                   (2)
//               X = -f, palm down: after a pronation, before a supination             (3)
//   upper arm   Y = s w_endorotation = -s w_exorotation
//               X = -s (f_end × f_start) of an abduction, elbow at 90 deg             (5)
//   both        Z = X × Y,  then X = Y × Z: Y is kept, X made square to it;  R_SB = [X Y Z]   (1), (4)
//   others, and where nothing of this is labelled: q_BS = R_expected(ψ)ᵀ q_gs in a
//               calibration:static_pose, for recordings that carry the maker's orientation
//               (static_alignment.h)
// in ISB axes (Luinge's y, -z, x are Y, X, Z here).
//
// Erratum: (5) is printed g_start × g_end, and turns the frame round on a right arm. All signs were
//   checked against the turning itself; for X of the upper arm that check is part of the result.
// Refused, with the reason: a movement that is missing, too small or about no single axis; repetitions
//   that disagree; an arm that does not hang when the abduction starts (labels exchanged, the wrong
//   side, the sensor upside down all show there); a forearm whose Y points to the hand (the same of
//   the forearm, where the trial shows the hanging arm or the abduction); Y and X far from square.
// Blind to   exchanged labels of a forearm alone without a hanging pose: palm down and palm up differ
//   for gravity only by how the sensor sits, which is what is sought;
//   what repeats itself: a palm that is never quite down, soft tissue that follows the bone
//   late. The told sigma has a floor for that; the position on the segment is not found at all.
#pragma once

#include <string>
#include <vector>

#include "problems/estimate.h"
#include "problems/observations.h"

namespace brachium {

struct CalibrationOptions {
  double least_turn_deg = 30.0;
  double largest_misfit_deg = 25.0;
  double floor_sigma_deg = 2.0;
  double facing_deg = 0.0;

  bool IsValid(std::string* why) const;

  template <typename Options, typename Visitor>
  static void Visit(Options& options, Visitor&& visit) {
    visit("least_turn_deg", options.least_turn_deg,
          "Movements that turn a sensor by less are not used [deg].");
    visit("largest_misfit_deg", options.largest_misfit_deg,
          "Directions that should agree, or be at right angles, may miss that by so much [deg].");
    visit("floor_sigma_deg", options.floor_sigma_deg,
          "Standard deviation of a calibrated rotation, per axis, that no repetition tells: soft "
          "tissue and postures that are off the same way each time [deg].");
    visit("facing_deg", options.facing_deg,
          "Where the person faces in a static pose, from the x axis of the maker's world [deg].");
  }
};

struct SegmentCalibration {
  Segment segment = Segment::kUpperArm;
  Mounting mounting;            // the position is the told one, or unknown (zero)
  std::vector<Figure> figures;  // "y_spread_deg", "y_repetitions", "x_off_square_deg", ...
};

struct Calibration {
  std::vector<SegmentCalibration> segments;
  std::vector<std::string> faults;  // why a segment could not be calibrated; one sentence each
  std::vector<std::string> notes;   // movements that were left out, mountings that were kept
};

// Calibrates every segment that has labelled movements; another one keeps the mounting that it has.
// One that has neither is a fault. Angles in radians but where a name says deg.
Calibration Calibrate(const Observations& observations, const CalibrationOptions& options);

// Whether any interval is labelled as a movement of that segment.
bool HasLabelledMovements(const Observations& observations, Segment segment);

}  // namespace brachium
