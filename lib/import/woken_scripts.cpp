// A script is enabled by its property Disabled, or by Enabled, which is the same the other way
// round.
#include "import/woken_scripts.h"

#include "import/script_side.h"

namespace obby::importer {
namespace {

// True also where the text does not tell the value.
bool enables(const ScriptEvent& event) {
  if (event.kind != EventKind::set || event.target == kNoInstance) return false;
  if (event.property == "Disabled") return !event.flag.value_or(false);
  return event.property == "Enabled" && event.flag.value_or(true);
}

}  // namespace

std::vector<Enabling> enablingsOf(const Tree& tree, const ScriptReading& reading, bool byItself) {
  const bool onClient = runsOnClient(tree.at(reading.script));
  std::vector<Enabling> enablings;
  for (const Timeline& timeline : reading.timelines) {
    if (byItself && !timeline.byItself()) continue;
    for (const ScriptEvent& event : timeline.events) {
      if (!enables(event)) continue;
      // What a client sets the server finds nothing of.
      if (onClient && !runsOnClient(tree.at(event.target))) continue;
      enablings.push_back({event.target, event.line});
    }
  }
  return enablings;
}

void doubtAll(ScriptReading& reading, bool byItself) {
  for (Timeline& timeline : reading.timelines) {
    timeline.maybe = true;
    if (!byItself && timeline.byItself()) {
      timeline.trigger = Trigger::other;
      timeline.line = 0;  // of no handler, be it that of each frame
    }
    for (ScriptEvent& event : timeline.events) event.unsure = true;
  }
}

}  // namespace obby::importer
