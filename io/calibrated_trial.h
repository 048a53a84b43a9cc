// A trial.json into which a calibration was entered.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "problems/imu.h"
#include "problems/segment.h"

namespace brachium {

// The trial.json of a trial folder, key by key as it is, with rotation and sigma of these mountings, of
// the sensors and of the clusters of the reference, and with "calibration", what is to be known about
// them. The position of a sensor stays as it was told; where no mounting was told it is the one of
// `mountings`, unless that is zero. Recordings that no mounting is known of are left out. File names
// become relative to the folder of `output`, the file that is to receive the text. The folder must
// have been read without an error.
std::string WithMountings(const std::string& trial, const std::map<Segment, Mounting>& mountings,
                          const std::map<Segment, Mounting>& clusters,
                          const nlohmann::ordered_json& calibration, const std::string& output);

}  // namespace brachium
