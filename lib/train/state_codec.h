// The parts of a checkpoint to and from its schema (schema/checkpoint.capnp). Private to lib/train.
#pragma once

#include <string>

#include "base/result.h"
#include "schema/checkpoint.capnp.h"
#include "train/state.h"

namespace obby::train {

// Digest of how sim::World and sim::LooseBody are laid out: their bytes mean the same where it is
// equal.
uint64_t stateLayout();

void writeSums(const Sums& sums, schema::SavedSums::Builder to);
void writeLearner(const LearnerState& state, schema::SavedLearner::Builder to);
void writeEnvGroup(const EnvGroupState& state, schema::SavedEnvGroup::Builder to);

// Env groups as bytes, between processes of the same program; unpackEnvGroups() appends.
std::string packEnvGroups(const std::vector<EnvGroupState>& envGroups);
void unpackEnvGroups(const std::string& bytes, std::vector<EnvGroupState>& envGroups);

// From 0 to 1; not so of what is no number.
bool isShare(double value);

// Has it only numbers that can be read back?
bool isFinite(const Sums& sums);
bool isFinite(const LearnerState& state);

// The error says which list has another length than it must. `out` says how wide sums are.
Status readSums(schema::SavedSums::Reader from, Sums& out);
Status readLearner(schema::SavedLearner::Reader from, LearnerState& out);
Status readEnvGroup(schema::SavedEnvGroup::Reader from, EnvGroupState& out);

}  // namespace obby::train
