// obby-train's command line.
#pragma once

#include "cli/context.h"
#include "cli/tool.h"
#include "sim/backend.h"
#include "train/evaluate.h"
#include "train/trainer.h"

namespace obby::tools {

cli::ToolSpec trainSpec();
// Error: options that would do nothing beside the others, typed: those of streams without one, of
// learning with --eval, of --eval without it, of logs without one.
Status optionsFit(const cli::Arguments& arguments);
train::TrainerSettings trainerSettings(const cli::Context& context);
// `which`: of several GPUs.
Result<sim::Backend> trainBackend(const cli::Context& context, uint32_t which);
// Seconds of --time-limit; without it so many that they never pass.
double timeLimit(const cli::Arguments& arguments);
train::EvaluationSettings evaluationSettings(const cli::Context& context);

}  // namespace obby::tools
