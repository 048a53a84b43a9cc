#include "bin/in_parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace brachium {
namespace {

class Pieces {
 public:
  Pieces(std::size_t count, const std::function<void(std::size_t)>& work)
      : count_(count), failed_(count), work_(work) {}

  // Works until nothing is left.
  void Work() {
    for (std::size_t i = next_++; i < count_; i = next_++) try {
        work_(i);
      } catch (...) {
        Note(i);
      }
  }

  void Rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void Note(std::size_t i) {
    const std::lock_guard lock(mutex_);
    next_ = count_;
    if (i >= failed_) return;
    failed_ = i;
    error_ = std::current_exception();
  }

  std::size_t count_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::size_t failed_;  // the least that threw
  std::exception_ptr error_;
  const std::function<void(std::size_t)>& work_;
};

}  // namespace

void InParallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  const auto wanted = static_cast<std::size_t>(
      threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
  Pieces pieces(count, work);
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < std::min(wanted, count); ++i)
      helpers.emplace_back([&pieces] { pieces.Work(); });
    pieces.Work();
  }
  pieces.Rethrow();
}

}  // namespace brachium
