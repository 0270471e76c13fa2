// obby-train's command line.
#pragma once

#include <string>
#include <vector>

#include "cli/context.h"
#include "cli/tool.h"
#include "sim/backend.h"
#include "train/evaluate.h"
#include "train/run/training_run.h"

namespace obby::tools {

cli::ToolSpec trainSpec();
// Returns an error for typed options that have no effect with the others.
Status optionsFit(const cli::Arguments& arguments);
// Returns an error for output files that are also read, or named by another option.
Status filesFit(const cli::Arguments& arguments);
// Returns the options that must be the same on all ranks, for train::sameOptions().
std::vector<std::string> rankOptions(const cli::Arguments& arguments);
train::TrainerSettings trainerSettings(const cli::Arguments& arguments);
train::RunFiles runFiles(const cli::Arguments& arguments);
train::RunIdentity runIdentity(const cli::Context& context);
train::RunPlan runPlan(const cli::Context& context);
// Returns the backend for training. `which` selects one of several GPUs.
Result<sim::Backend> trainBackend(const cli::Context& context, uint32_t which);
// Returns the seconds of --time-limit, or a time that never passes.
double timeLimit(const cli::Arguments& arguments);
train::EvaluationSettings evaluationSettings(const cli::Arguments& arguments);

}  // namespace obby::tools
