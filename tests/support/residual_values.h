// The values of a residual's blocks, drawn or told, and what the residual says there.
#pragma once

#include <Eigen/Geometry>
#include <random>
#include <utility>
#include <vector>

#include "problems/residuals/cost.h"

namespace brachium {

// One vector a block; four numbers are a rotation [x y z w].
using BlockValues = std::vector<Eigen::VectorXd>;

inline std::vector<const double*> Pointers(const BlockValues& x) {
  std::vector<const double*> pointers;
  for (const Eigen::VectorXd& block : x) pointers.push_back(block.data());
  return pointers;
}

template <typename Residual>
Eigen::VectorXd ResidualAt(const Residual& residual, const BlockValues& x) {
  Eigen::VectorXd r(Residual::kResiduals);
  residual(Pointers(x).data(), r.data());
  return r;
}

inline Eigen::VectorXd RandomVector(int size, std::mt19937& random, double sigma = 1.0) {
  std::normal_distribution<double> normal(0.0, sigma);
  Eigen::VectorXd v(size);
  for (double& component : v) component = normal(random);
  return v;
}

inline Eigen::Quaterniond RandomRotation(std::mt19937& random) {
  return Eigen::Quaterniond(Eigen::Vector4d(RandomVector(4, random).normalized()));
}

// Turned by an angle of this size about a random axis.
inline Eigen::Quaterniond Near(const Eigen::Quaterniond& q, double angle, std::mt19937& random) {
  return q * Exp<double>(Eigen::Vector3d(angle * RandomVector(3, random).normalized()));
}

// Rotations over the whole sphere, the rest normal with this standard deviation.
template <int... kBlocks>
BlockValues RandomValues(std::integer_sequence<int, kBlocks...>, std::mt19937& random,
                         double sigma = 1.0) {
  const auto draw = [&](int size) -> Eigen::VectorXd {
    if (size == 4) return RandomRotation(random).coeffs();
    return RandomVector(size, random, sigma);
  };
  return {draw(kBlocks)...};
}

// The world turned by q_VW: attitudes with it, vectors in world axes too where `is_world` says so.
inline BlockValues TurnedWorld(const Eigen::Quaterniond& q_VW, BlockValues x,
                               const std::vector<bool>& is_world) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i].size() == 4)
      x[i] = (q_VW * Eigen::Quaterniond(Eigen::Vector4d(x[i]))).coeffs();
    else if (is_world[i])
      x[i] = q_VW * Eigen::Vector3d(x[i]);
  }
  return x;
}

}  // namespace brachium
