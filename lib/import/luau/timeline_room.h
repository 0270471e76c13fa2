// The room that the reader has for the events and timelines of a script.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "import/script_reading.h"

namespace obby::importer::luau {

// Units of a timeline with its events.
inline size_t roomOf(const Timeline& timeline) { return 1 + timeline.events.size(); }

// Counts in units of one event or one timeline, be it empty: both take the same at most (see
// kScriptRoom). The timeline of the script itself takes none. Once it is full it stays so, whatever
// is given back: something has been left out.
class TimelineRoom {
 public:
  // `room`: units that there are for the script, from 0: what those before it have left.
  explicit TimelineRoom(size_t room) : left_(room) {}

  // A unit for one more; false where there is none.
  [[nodiscard]] bool take();
  // Takes a unit for a new event at the end of these. Without room it gives one that no timeline
  // has. Good until the next one.
  ScriptEvent& addTo(std::vector<ScriptEvent>& events);
  // Units of what was taken and is not kept.
  void giveBack(size_t units) { left_ += units; }

  size_t left() const { return left_; }
  // Whether anything was left out, as there was no room for it.
  bool isFull() const { return full_; }

 private:
  size_t left_;
  std::optional<ScriptEvent> lost_;  // the last one without room
  bool full_ = false;
};

}  // namespace obby::importer::luau
