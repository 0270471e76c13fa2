// Reads which bodies a place gives to its players, and how large they are.
#pragma once

#include "import/draft.h"
#include "import/tree.h"
#include "schema/obby.capnp.h"

namespace obby::importer {

// Fills level.avatar from StarterPlayer. What is simulated otherwise is noted in level.ignored.
void readAvatar(const Tree& tree, LevelDraft& level);

// The numbers that the avatar decides.
void setAvatar(schema::PhysicsParams::Builder to, const Avatar& avatar);

}  // namespace obby::importer
