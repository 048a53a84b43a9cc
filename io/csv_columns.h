// Vectors and rotations as columns of a table to be written.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "io/csv.h"

namespace brachium {

// `name`x, `name`y, `name`z; nothing for no vectors.
void AddVector(const std::string& name, const std::vector<Eigen::Vector3d>& vectors,
               std::vector<CsvColumn>* columns);

// `name`w, `name`x, `name`y, `name`z; nothing for no rotations.
void AddRotation(const std::string& name, const std::vector<Eigen::Quaterniond>& rotations,
                 std::vector<CsvColumn>* columns);

}  // namespace brachium
