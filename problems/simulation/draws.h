// Random numbers that are the same on every run: the standard fixes the generator's bits but not
// those of its distributions, so these are written out.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <string_view>

namespace brachium {

// A stream of draws. Streams of different names are independent, so that switching one error on
// leaves the draws of all others alone.
class Draws {
 public:
  Draws(std::uint64_t seed, std::string_view stream);

  double Uniform(double low, double high);
  double Normal();                          // mean 0, variance 1
  double Sign();                            // -1 or +1
  Eigen::Vector3d Normal3();                // independent components
  Eigen::Vector3d OfLength(double length);  // in a random direction
  Eigen::Vector3d OfRms(double rms);        // in a random direction; rms over its components

 private:
  std::mt19937_64 generator_;
};

}  // namespace brachium
