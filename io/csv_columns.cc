#include "io/csv_columns.h"

namespace brachium {

void AddVector(const std::string& name, const std::vector<Eigen::Vector3d>& vectors,
               std::vector<CsvColumn>* columns) {
  for (int axis = 0; axis < 3 && !vectors.empty(); ++axis)
    columns->push_back({name + "xyz"[axis], vectors[0].data() + axis, 3});
}

void AddRotation(const std::string& name, const std::vector<Eigen::Quaterniond>& rotations,
                 std::vector<CsvColumn>* columns) {
  if (rotations.empty()) return;
  const double* const xyzw = rotations[0].coeffs().data();
  columns->push_back({name + "w", xyzw + 3, 4});
  for (int axis = 0; axis < 3; ++axis) columns->push_back({name + "xyz"[axis], xyzw + axis, 4});
}

}  // namespace brachium
