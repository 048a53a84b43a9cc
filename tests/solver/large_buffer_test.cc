#include "solver/large_buffer.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace brachium {
namespace {

template <typename Number>
class LargeBufferTest : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(LargeBufferTest, Numbers);

TYPED_TEST(LargeBufferTest, HasRoomAndStaysWhereItIsWhileThatIsEnough) {
  LargeBuffer<TypeParam> buffer;
  buffer.Reserve(1000);
  TypeParam* const numbers = buffer.data();
  for (int i = 0; i < 1000; ++i) numbers[i] = static_cast<TypeParam>(i);
  buffer.Reserve(500);
  EXPECT_EQ(buffer.data(), numbers);
  EXPECT_EQ(numbers[999], 999);
}

TYPED_TEST(LargeBufferTest, HasRoomOnAlignedMemoryWhateverItsSize) {
  for (const std::size_t size : {1, 17, 1'000'000, 3'000'001, 9'000'001}) {
    LargeBuffer<TypeParam> buffer;
    buffer.Reserve(size);
    buffer.data()[size - 1] = 1;
    EXPECT_EQ(buffer.data()[size - 1], 1);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.data()) % 64, 0u) << size;
  }
}

}  // namespace
}  // namespace brachium
