#include "io/headings_figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace brachium {
namespace {

using testing::AllOf, testing::HasSubstr, testing::Not;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(HeadingsFigure, DrawsEachJointWithAllRelationsThatTellOfIt) {
  const HeadingSupport elbow{.segment = Segment::kForearm,
                             .against = Segment::kUpperArm,
                             .time = {2.5, 7.5, 12.5},
                             .sd = {0.1, 0.2, 0.1},
                             .sd_by = {{"accelerometer", {kInfinity, 0.1, 0.2}}}};
  HeadingSupport wrist = elbow;
  wrist.segment = Segment::kHand;
  wrist.against = Segment::kForearm;
  wrist.sd.clear();
  const std::string svg = HeadingsFigure({elbow, wrist});
  EXPECT_THAT(svg, AllOf(HasSubstr("</svg>"), HasSubstr("forearm against the upper_arm"),
                         HasSubstr("hand against the forearm"), HasSubstr("accelerometer alone"),
                         HasSubstr("all together")));
  EXPECT_THAT(svg, AllOf(Not(HasSubstr("inf")), Not(HasSubstr("nan"))));
}

}  // namespace
}  // namespace brachium
