#include "problems/model_options.h"

#include <cmath>
#include <type_traits>

namespace brachium {

bool ModelOptions::IsValid(std::string* why) const {
  bool valid = true;
  const auto held_at_zero = [](const std::string& name) {
    return name == "gyro_cross_axis" || name == "clock_offset_sigma_s" ||
           name == "gyro_scale_sigma" || name == "soft_tissue_deg" || name == "accel_scale_sigma";
  };
  Visit(*this, [&](const std::string& name, auto value, const char*) {
    if constexpr (std::is_same_v<decltype(value), double>) {
      const bool positive = value > 0.0 || (value == 0.0 && held_at_zero(name));
      if (!valid || (positive && std::isfinite(value))) return;
      *why = name + (held_at_zero(name) ? " must not be negative" : " must be greater than 0");
      valid = false;
    }
  });
  return valid;
}

}  // namespace brachium
