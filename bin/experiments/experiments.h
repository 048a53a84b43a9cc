// The experiments, one file each: what the paper did, what is ours, and what is compared stand there.
#pragma once

#include "bin/experiments/experiment.h"

namespace brachium {

ExperimentPlan PlanLuinge2007(bool quick);
ExperimentReport ReportLuinge2007(const ExperimentResults& results, bool quick);

ExperimentPlan PlanZhou2008(bool quick);
ExperimentReport ReportZhou2008(const ExperimentResults& results, bool quick);

ExperimentPlan PlanBai2015(bool quick);
ExperimentReport ReportBai2015(const ExperimentResults& results, bool quick);

}  // namespace brachium
