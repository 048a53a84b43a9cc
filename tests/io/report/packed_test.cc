#include "io/report/packed.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/unpacked.h"

namespace brachium {
namespace {

TEST(Packed, GivesNumbersBackToHalfItsUnit) {
  const auto packed = Packed({0.0, -12.344, 179.999, 0.01}, 0.01);
  EXPECT_EQ(packed["unit"], 0.01);
  const std::vector<double> read = Unpacked(packed);
  ASSERT_EQ(read.size(), 4u);
  EXPECT_NEAR(read[1], -12.344, 0.005);
  EXPECT_NEAR(read[2], 179.999, 0.005);
}

TEST(Packed, KeepsWhatIsUnknownUnknown) {
  const std::vector<double> read = Unpacked(Packed({std::nan(""), 1.0, INFINITY}, 0.01));
  EXPECT_TRUE(std::isnan(read[0]));
  EXPECT_EQ(read[1], 1.0);
  EXPECT_TRUE(std::isnan(read[2]));
  EXPECT_TRUE(std::isnan(Unpacked(Packed({std::nan("")}, 0.01))[0]));
}

TEST(Packed, IsFineFarFromZero) {
  const std::vector<double> read = Unpacked(Packed({50000.0, 50001.0, 50000.5}, 1e-4));
  EXPECT_NEAR(read[2], 50000.5, 1e-4);
}

TEST(Packed, GivesTimesBackWhateverTheirClock) {
  const double epoch = 1.7e9;
  const std::vector<double> read =
      UnpackedTimes(PackedTimes({epoch, epoch + 0.01, epoch + 86400.0}));
  EXPECT_NEAR(read[1], epoch + 0.01, 1e-4);
  EXPECT_NEAR(read[2], epoch + 86400.0, 1e-4);
  EXPECT_TRUE(UnpackedTimes(PackedTimes({})).empty());
}

}  // namespace
}  // namespace brachium
