#include "problems/position_errors.h"

#include <algorithm>
#include <cmath>

namespace brachium {
namespace {

using Eigen::Matrix3Xd;

constexpr double kPathStep = 0.1;  // [s]

bool HeightKnown(const Matrix3Xd& points) {
  return std::any_of(points.row(2).begin(), points.row(2).end(),
                     [](double z) { return std::isfinite(z); });
}

Statistics StatisticsOfRows(const Matrix3Xd& estimate, const Matrix3Xd& reference, int first,
                            int count) {
  const Series e = estimate.middleRows(first, count), r = reference.middleRows(first, count);
  Statistics statistics = StatisticsOf(e - r);
  statistics.correlation = Correlation(e, r);
  return statistics;
}

}  // namespace

PositionErrors PositionErrorsOf(const Matrix3Xd& estimate, const Matrix3Xd& reference) {
  PositionErrors errors;
  errors.horizontal = StatisticsOfRows(estimate, reference, 0, 2);
  for (int i = 0; i < 2; ++i)
    errors.axis[static_cast<std::size_t>(i)] = StatisticsOfRows(estimate, reference, i, 1);
  errors.distance = errors.horizontal;
  if (!HeightKnown(estimate - reference)) return errors;
  errors.distance = StatisticsOfRows(estimate, reference, 0, 3);
  errors.vertical = StatisticsOfRows(estimate, reference, 2, 1);
  return errors;
}

double PathLength(const SampleTimes& times, const Matrix3Xd& points) {
  const Series known = points.topRows(HeightKnown(points) ? 3 : 2);
  const auto n = known.cols();
  if (n < 2) return 0.0;
  const auto stride =
      static_cast<Eigen::Index>(std::max(1.0, std::round(kPathStep / times.step())));
  double length = 0.0;
  Eigen::Index picked = -1;  // none in this run
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!known.col(i).allFinite()) {
      picked = -1;
      continue;
    }
    const bool run_ends =
        i + 1 == n || times.GapAfter(static_cast<std::size_t>(i)) || !known.col(i + 1).allFinite();
    if (picked < 0) picked = i;
    if (i - picked == stride || run_ends) {
      length += (known.col(i) - known.col(picked)).norm();
      picked = i;
    }
    if (run_ends) picked = -1;
  }
  return length;
}

}  // namespace brachium
