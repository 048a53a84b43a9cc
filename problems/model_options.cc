#include "problems/model_options.h"

#include <cmath>

namespace brachium {

bool ModelOptions::IsValid(std::string* why) const {
  bool valid = true;
  Visit(*this, [&](const std::string& name, double value, const char*) {
    if (valid && !(value > 0.0 && std::isfinite(value)) && name != "gyro_cross_axis") {
      *why = name + " must be greater than 0";
      valid = false;
    }
  });
  return valid;
}

}  // namespace brachium
