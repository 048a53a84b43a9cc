// A buffer of numbers too many to be put to zero first, on large pages where the system has them: of
// a trial's factor, first touch of ordinary ones takes longer than a pass.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace brachium {

class LargeBuffer {
 public:
  // Room for that many numbers at least. What stood there is lost when it grows.
  void Reserve(std::size_t numbers) {
    if (numbers <= size_) return;
    const std::size_t bytes = (numbers * sizeof(double) + kPage - 1) / kPage * kPage;
    size_ = 0;
    data_.reset();
    data_.reset(static_cast<double*>(std::aligned_alloc(kPage, bytes)));
    if (data_ == nullptr) throw std::bad_alloc();
    size_ = bytes / sizeof(double);
#if defined(__linux__)
    madvise(data_.get(), bytes, MADV_HUGEPAGE);
#endif
  }
  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }

 private:
  static constexpr std::size_t kPage = std::size_t{1} << 21;
  struct Free {
    void operator()(double* data) const { std::free(data); }
  };
  std::unique_ptr<double[], Free> data_;
  std::size_t size_ = 0;
};

}  // namespace brachium
