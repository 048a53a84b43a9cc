// A buffer of numbers too many to be put to zero first, aligned for loops over lanes of them, and on
// large pages where it fills a number of them and the system has them: of a trial's factor, first touch
// of ordinary ones takes longer than a pass.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace brachium {

template <typename Number>
class LargeBuffer {
 public:
  // Room for that many numbers at least. What stood there is lost when it grows.
  void Reserve(std::size_t numbers) {
    if (numbers <= size_) return;
    const std::size_t needed = numbers * sizeof(Number);
    const std::size_t page = needed < kFewest * kLargePage ? kCacheLine : kLargePage;
    const std::size_t bytes = (needed + page - 1) / page * page;
    size_ = 0;
    data_.reset();
    data_.reset(static_cast<Number*>(std::aligned_alloc(page, bytes)));
    if (data_ == nullptr) throw std::bad_alloc();
    size_ = bytes / sizeof(Number);
#if defined(__linux__)
    if (page == kLargePage) madvise(data_.get(), bytes, MADV_HUGEPAGE);
#endif
  }
  Number* data() { return data_.get(); }
  const Number* data() const { return data_.get(); }

 private:
  static constexpr std::size_t kCacheLine = 64, kLargePage = std::size_t{1} << 21, kFewest = 8;
  struct Free {
    void operator()(Number* data) const { std::free(data); }
  };
  std::unique_ptr<Number[], Free> data_;
  std::size_t size_ = 0;
};

}  // namespace brachium
