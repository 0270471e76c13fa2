// Starts training from a policy (policy.obp) instead of a fresh network.
#pragma once

#include "policy/policy_file.h"
#include "train/state.h"

namespace obby::train {

// Before the first step, training plays exactly as the policy does. Policy files keep no optimiser
// state, so Adam starts afresh. So does the value scale if the file lacks it.
struct Start {
  LearnerState learner;
  Sums seen{policy::kInputs};
};

// Resumes the normaliser with as many observations as the policy has learned from. A fresh one
// would change the network's inputs abruptly, and a fixed one would not adapt to other levels.
// Error: a normaliser that training cannot produce. The message does not name the file.
Result<Start> startFrom(const policy::PolicyFile& file);

// Returns the decisions that the network has learned from, including those of its initial policy.
uint64_t allDecisions(const TrainerState& state);

}  // namespace obby::train
