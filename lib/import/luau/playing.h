// What the reader keeps in mind of tweens that play.
#pragma once

#include <cstddef>

#include "import/luau/datum.h"
#include "import/script_reading.h"

namespace obby::importer::luau {

// A tween of a pose or of another property, since its event.
struct Going {
  const Tween* tween = nullptr;
  ScriptEvent goal;
  size_t timeline = 0;   // that it was played in
  bool clashes = false;  // another one sets the same, as another property
  bool again = false;    // an endless loop that is over for the reading plays it round by round
};

// A tween since the script has played it, until the timeline is over.
struct Played {
  Tween* tween;
  double time = 0;   // that it began, without pauses
  size_t event = 0;  // index of its first event
  size_t events = 0;
  bool stopped = false, paused = false;
  int doubt = 0;  // open branches that it was played in; most where one may have stopped it
};

}  // namespace obby::importer::luau
