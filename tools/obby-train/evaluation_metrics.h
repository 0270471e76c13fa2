// What --eval says: how many levels the policy solves, in all and of each style.
#pragma once

#include <cstdint>
#include <vector>

#include "train/evaluate.h"
#include "train/metrics.h"

namespace obby::tools {

// For train::evaluate: of the style that the level's name says; 0: it says none.
uint16_t styleNumberOf(const train::TrainingLevel& level);

// Of all levels, and where they are of several styles of each with its name before that of the
// metric: "gaps/levels". What nobody played for is left out. `tries`: as EvaluationSettings::tries.
std::vector<train::Metric> evaluationMetrics(const train::Evaluation& e, uint32_t tries);

}  // namespace obby::tools
