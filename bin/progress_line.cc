#include "bin/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace brachium {
namespace {

constexpr const char* kClearLine = "\r\x1b[K";

}  // namespace

ProgressLine::ProgressLine() : watched_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (watched_) std::fputs(kClearLine, stderr);
}

Progress ProgressLine::callback() {
  if (!watched_) return {};
  return [](const std::string& stage, double done) {
    std::fprintf(stderr, "%s%3.0f %%  %s", kClearLine, 100 * done, stage.c_str());
    std::fflush(stderr);
  };
}

}  // namespace brachium
