// The methods by name, and the options of each.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/baselines/bai_dead_reckoning.h"
#include "solver/baselines/bai_kinematic.h"
#include "solver/baselines/gyroscope.h"
#include "solver/baselines/heading_corrected.h"
#include "solver/baselines/luinge.h"
#include "solver/baselines/zhou.h"
#include "solver/batch_smoother.h"
#include "solver/estimator.h"

namespace brachium {

// One alternative per method; later methods join the list.
using MethodOptions =
    std::variant<SmootherOptions, GyroscopeOptions, LuingeUnconstrainedOptions, LuingeOptions,
                 LuingeRtsOptions, HeadingCorrectedOptions, ZhouOptions, BaiKinematicOptions,
                 BaiDeadReckoningOptions, BaiDeadReckoningZuptOptions>;

// Default options of the method of that name, or none.
std::optional<MethodOptions> DefaultOptions(const std::string& method);

std::vector<std::string> MethodNames();

std::unique_ptr<Estimator> MakeEstimator(const MethodOptions& options);

}  // namespace brachium
