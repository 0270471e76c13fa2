// What learning begins with where it begins with a policy (policy.obp) instead of a fresh network.
#pragma once

#include "policy/policy_file.h"
#include "train/state.h"

namespace obby::train {

// Until something is learned it plays as the policy does, bit for bit. Files have no means of
// gradients: Adam begins anew. So does what the value means where the file does not say it.
struct Start {
  LearnerState learner;
  Sums seen{policy::kInputs};
};

// The normalisers go on, by as many observations as the policy learned from: begun anew the
// network would see other numbers all at once, and held still they would never come to fit levels
// that look otherwise. Error: normalisers that no learning comes to; it does not name the file.
Result<Start> startFrom(const policy::PolicyFile& file);

// Decisions that the network of a state learned from, with those of the policy that it began with.
uint64_t allDecisions(const TrainerState& state);

}  // namespace obby::train
