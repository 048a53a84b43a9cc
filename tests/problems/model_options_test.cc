#include "problems/model_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace brachium {
namespace {

TEST(ModelOptions, SayWhatIsWrong) {
  std::string why;
  EXPECT_TRUE(ModelOptions{}.IsValid(&why)) << why;
  ModelOptions options;
  options.zero_velocity_sigma_m_s = 0.0;
  EXPECT_FALSE(options.IsValid(&why));
  EXPECT_EQ(why, "zero_velocity_sigma_m_s must be greater than 0");
  options = {};
  options.accel_scale_sigma = std::nan("");
  EXPECT_FALSE(options.IsValid(&why));
}

TEST(ModelOptions, TakeZeroForWhatIsKnownExactly) {
  std::string why;
  ModelOptions options;
  options.clock_offset_sigma_s = options.gyro_scale_sigma = options.accel_scale_sigma = 0.0;
  EXPECT_TRUE(options.IsValid(&why)) << why;
  options.clock_offset_sigma_s = -1e-3;
  EXPECT_FALSE(options.IsValid(&why));
  EXPECT_EQ(why, "clock_offset_sigma_s must not be negative");
}

}  // namespace
}  // namespace brachium
