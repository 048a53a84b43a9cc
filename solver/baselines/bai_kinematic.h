// The method `bai_kinematic`: joint positions from the attitudes of two to four sensors and the
// lengths between joints, the trunk standing still; after Bai et al. (2015), section II.C.1.
//
//   p_sh = R_sh P_sh(0),  p_e = p_sh + R_e P_e(0),  p_w = p_e + R_w P_w(0),  p_h = p_w + R_h P_h(0)   (3)
// indices by the distal joint, so that R_e is the upper arm's; P(0) are distal joints in segment axes.
// Attitudes: given_attitudes.h; mountings as told, or from a static pose: static_alignment.h.
// The girdle reaches from the lowest neck vertebra (C7) to the shoulder: its distal joint is the
// trial's `distal_joint_m`, or (0, -L4 sin α, s L4 cos α) from its length L4 and its angle α below the
// horizontal.
//
// p_W are in world axes, from C7 with a girdle's sensor, else from the proximal joint of the first
// segment, which then stands still. Bai's trunk axes of a person who faces X_T are X = z_W up, Y = -X_T
// backward, Z to the right: a constant turn.
// Departs   in that a hand, a forearm or a girdle may be missing at either end.
// Errata of the printed equations:
//   (1)  abduction = pitch + 90 deg is the elevation, the same for flexion and abduction;
//   P_sh(0)  is printed (-cos α L4, sin α L4, 0), without a lateral part: with X up, Y backward and Z
//        to the right it is (-L4 sin α, 0, L4 cos α);
//   (3)  the matrix is garbled: the chain is cumulative, as above;
//   (9)  static_alignment.h.
// Blind to  the trunk's own motion.
// Source    Bai, Pepper, Yan, Spurgeon, Sakel & Phillips, IEEE T-NSRE 23 (2015) 232-243.
#pragma once

#include <string>

#include "solver/baselines/luinge.h"
#include "solver/baselines/movement_epochs.h"

namespace brachium {

struct BaiKinematicOptions {
  LuingeUnconstrainedOptions filter;
  EpochOptions epochs;
  double bai_girdle_length_m = 0.0;
  double bai_girdle_angle_deg = 0.0;
  double bai_facing_deg = 0.0;

  bool IsValid(std::string* why) const;

  template <typename Options, typename Visitor>
  static void Visit(Options& options, Visitor&& visit) {
    LuingeUnconstrainedOptions::Visit(options.filter, visit);
    EpochOptions::Visit(options.epochs, visit);
    visit("bai_girdle_length_m", options.bai_girdle_length_m,
          "L4, from the lowest neck vertebra to the shoulder [m]; 0: the girdle's distal joint in "
          "trial.json.");
    visit("bai_girdle_angle_deg", options.bai_girdle_angle_deg,
          "Angle of that line below the horizontal in the static pose [deg].");
    visit("bai_facing_deg", options.bai_facing_deg,
          "Where the person faces in the static pose, from the x axis of the maker's world [deg]. "
          "A wrong one turns segments about their long axes and leaves positions alone.");
  }
};

class BaiKinematic final : public Estimator {
 public:
  explicit BaiKinematic(const BaiKinematicOptions& options) : options_(options) {}
  bool Accepts(const Observations& observations, std::string* why) const override;
  Estimate Run(const Observations& observations, const Progress& progress = {}) const override;

 private:
  BaiKinematicOptions options_;
};

}  // namespace brachium
