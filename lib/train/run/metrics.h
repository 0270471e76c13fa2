// Metrics of training and of evaluations: the same names and values in all logs. Names of training
// are those of CleanRL and Stable-Baselines3, in camel case.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "train/evaluate.h"
#include "train/trainer.h"

namespace obby::train {

struct Metric {
  std::string name;
  double value;
  const char* unit;
};

// Returns the metrics of an iteration. `seconds`: wall clock so far; `rate`: decisions per second.
std::vector<Metric> metricsOf(const Iteration& iteration, double seconds, double rate);

// Returns the metrics of all levels. If levels of several named kinds were played, the metrics of
// each kind follow, prefixed by its name: "gaps/levels". `kindNames`: by the numbers of KindOf; an
// empty name gets no metrics. `tries`: as EvaluationSettings::tries.
std::vector<Metric> evaluationMetrics(const Evaluation& evaluation, uint32_t tries,
                                      std::span<const std::string> kindNames);

}  // namespace obby::train
