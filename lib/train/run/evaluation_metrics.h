// Metrics of an evaluation: the shares of levels that the policy solves, in total and of each kind.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "train/evaluate.h"
#include "train/run/metrics.h"

namespace obby::train {

// Returns the metrics of all levels. If levels of several named kinds were played, the metrics of
// each kind follow, prefixed by its name: "gaps/levels". `kindNames`: by the numbers of KindOf; an
// empty name gets no metrics. `tries`: as EvaluationSettings::tries.
std::vector<Metric> evaluationMetrics(const Evaluation& evaluation, uint32_t tries,
                                      std::span<const std::string> kindNames);

}  // namespace obby::train
