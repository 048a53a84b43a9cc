// One line on standard error that says how far the work is; silent where nobody watches.
#pragma once

#include "solver/estimator.h"

namespace brachium {

class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();  // clears the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Empty when standard error is no terminal. Must not outlive this.
  Progress callback();

 private:
  bool watched_;
};

}  // namespace brachium
