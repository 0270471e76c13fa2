// Scripts that the file has disabled and that others enable in play: traps that sleep at first.
#pragma once

#include <vector>

#include "import/script_reading.h"

namespace obby::importer {

struct Enabling {
  InstanceId script = kNoInstance;  // that is enabled, or may be
  int line = 0;                     // of the one that does it
};

// What a script enables on its side of the game, in the order of its reading; the server enables on
// both. Those that the file has enabled are among them, and one may come more than once.
// `byItself`: only what it does whatever players do.
std::vector<Enabling> enablingsOf(const Tree& tree, const ScriptReading& reading, bool byItself);

// Makes all that a woken script does a thing that may be. `byItself`: it is enabled whatever
// players do; else what it does by itself comes as after a click. Call it once it is read.
void doubtAll(ScriptReading& reading, bool byItself);

}  // namespace obby::importer
