// obby-train's command line.
#pragma once

#include "cli/context.h"
#include "cli/tool.h"
#include "train/evaluate.h"
#include "train/trainer.h"

namespace obby::tools {

cli::ToolSpec trainSpec();
train::TrainerSettings trainerSettings(const cli::Context& context);
train::EvaluationSettings evaluationSettings(const cli::Context& context);

}  // namespace obby::tools
