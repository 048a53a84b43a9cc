#include "solver/large_buffer.h"

#include <gtest/gtest.h>

namespace brachium {
namespace {

TEST(LargeBuffer, HasRoomAndStaysWhereItIsWhileThatIsEnough) {
  LargeBuffer<double> buffer;
  buffer.Reserve(1000);
  double* const numbers = buffer.data();
  for (int i = 0; i < 1000; ++i) numbers[i] = i;
  buffer.Reserve(500);
  EXPECT_EQ(buffer.data(), numbers);
  EXPECT_EQ(numbers[999], 999.0);
  buffer.Reserve(1'000'000);
  buffer.data()[999'999] = 1.0;
  EXPECT_EQ(buffer.data()[999'999], 1.0);
}

}  // namespace
}  // namespace brachium
