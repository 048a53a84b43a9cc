#include "bin/run_facts.h"

#include <ceres/version.h>
#include <unistd.h>

#include <Eigen/Core>
#include <climits>

namespace brachium {

std::string ProgramVersion() { return BRACHIUM_VERSION; }

std::vector<std::pair<std::string, std::string>> Versions() {
  const std::string eigen = std::to_string(EIGEN_WORLD_VERSION) + "." +
                            std::to_string(EIGEN_MAJOR_VERSION) + "." +
                            std::to_string(EIGEN_MINOR_VERSION);
  return {{"brachium", ProgramVersion()}, {"ceres", CERES_VERSION_STRING}, {"eigen", eigen}};
}

std::string HostName() {
  char name[HOST_NAME_MAX + 1] = {};
  return gethostname(name, HOST_NAME_MAX) == 0 ? name : "";
}

}  // namespace brachium
