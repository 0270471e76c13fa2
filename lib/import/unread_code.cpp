// What is lost of modules, and of the scripts that are read.
#include "import/unread_code.h"

#include <set>
#include <string>

#include "import/luau/changes.h"

namespace obby::importer {

void noteModules(RoleContext& context) {
  const InstanceId player = context.tree.service("StarterPlayer");
  for (InstanceId id = 0; id < context.tree.size(); ++id) {
    const Instance& module = context.tree.at(id);
    const auto* source = property<std::string>(module, "Source");
    if (module.className != "ModuleScript" || !source) continue;
    if (player != kNoInstance && context.tree.isUnder(id, player)) continue;
    for (const char* sign : {".Touched", "TweenService", ".CanCollide", "TakeDamage", ".Health"})
      if (source->find(sign) != std::string::npos) {
        context.level.noteUnmodelled(
            "module script", context.tree.path(id),
            "its effect on parts is not followed; tags, names and other scripts decide");
        break;
      }
  }
}

void noteUnread(RoleContext& context, const ScriptReading& reading) {
  const std::string path = context.tree.path(reading.script);
  auto& level = context.level;
  if (reading.broken)
    level.noteUnmodelled("script with unknown syntax", path, "read as far as it was understood");
  if (reading.requiresAsset)
    level.noteUnmodelled("require of an asset", path, "its code is not in the file");
  if (reading.dynamicCode)
    level.noteUnmodelled("code loaded at run time", path, "it uses loadstring, getfenv or setfenv");
  if (reading.exhausted || reading.cutAgain)
    level.noteUnmodelled(
        "very long script", path,
        "read only until the budget of steps, rounds, nested calls, changes or handlers ran out");
  if (reading.cutChanges)
    level.noteUnmodelled("script that sets too much", path,
                         "traps of other scripts may wait for it unseen, as only the first " +
                             std::to_string(luau::kMaxKeys) +
                             " properties that scripts set are kept; a tag KillBrick says what "
                             "kills");
  for (const int line : std::set<int>(reading.waysOut.begin(), reading.waysOut.end()))
    level.noteUnmodelled("loop that may end", path,
                         "taken as endless, so the code after it is not read; " +
                             scriptReason(context.tree, reading, line));
}

}  // namespace obby::importer
