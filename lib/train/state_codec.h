// Converts the parts of a checkpoint to and from schema/checkpoint.capnp. Private to lib/train.
#pragma once

#include <string>

#include "base/result.h"
#include "schema/checkpoint.capnp.h"
#include "train/state.h"

namespace obby::train {

// Returns a digest of the layouts of sim::World and sim::RigidBody. If it is equal, their bytes
// have the same meaning.
uint64_t stateLayout();

void writeSums(const Sums& sums, schema::SavedSums::Builder to);
void writeLearner(const LearnerState& state, schema::SavedLearner::Builder to);
void writeEnvGroup(const EnvGroupState& state, schema::SavedEnvGroup::Builder to);

// Serialises env groups for processes of the same program. unpackEnvGroups() appends.
std::string packEnvGroups(const std::vector<EnvGroupState>& envGroups);
void unpackEnvGroups(const std::string& bytes, std::vector<EnvGroupState>& envGroups);

// Returns true for 0 to 1, false for NaN.
bool isShare(double value);

// Returns true if all numbers are finite.
bool isFinite(const Sums& sums);
bool isFinite(const LearnerState& state);

// Errors name the list that has a wrong length. `out` determines the width of sums.
Status readSums(schema::SavedSums::Reader from, Sums& out);
Status readLearner(schema::SavedLearner::Reader from, LearnerState& out);
Status readEnvGroup(schema::SavedEnvGroup::Reader from, EnvGroupState& out);

}  // namespace obby::train
