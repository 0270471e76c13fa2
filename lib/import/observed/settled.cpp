// Compares the document with the file, for each part that scripts have changed.
#include "import/observed/settled.h"

#include <fmt/format.h>

#include <map>
#include <optional>

#include "engine/classes/class_defaults.h"
#include "import/document/classes.h"
#include "import/draft/motion.h"
#include "import/observed/roles.h"
#include "import/observed/settle.h"
#include "import/parts/collision_groups.h"

namespace obby::importer {
namespace {

struct SwitchWords {
  const char* property;
  const char* on;
  const char* off;
};
constexpr SwitchWords kSwitchWords[] = {{"CanCollide", "solid", "not solid"},
                                        {"CanTouch", "can be touched", "cannot be touched"},
                                        {"Anchored", "anchored", "not anchored"}};

// Returns words for a property's new value, or nullopt if it is unchanged.
std::optional<std::string> wordsFor(const std::string& property, const Instance& before,
                                    const Instance& after) {
  for (const SwitchWords& words : kSwitchWords)
    if (property == words.property) {
      const bool on = get<bool>(after, words.property);
      if (on == get<bool>(before, words.property)) return std::nullopt;
      return on ? words.on : words.off;
    }
  if (property == "Transparency") {
    const double value = get<double>(after, "Transparency");
    if (value == get<double>(before, "Transparency")) return std::nullopt;
    return fmt::format("transparency {:.3g}", value);
  }
  if (property == "Size" && !(get<Vec3>(after, "Size") == get<Vec3>(before, "Size")))
    return "resized";
  if (property == "CFrame" &&
      !samePose(get<CFrame>(after, "CFrame"), get<CFrame>(before, "CFrame")))
    return "placed";
  return std::nullopt;
}

// Returns the last line that changed each property before the probes.
std::map<std::pair<InstanceId, std::string>, engine::Line> settlingLines(
    const engine::Report& report) {
  std::map<std::pair<InstanceId, std::string>, engine::Line> lines;
  for (const engine::Change& change : report.undisturbed.changes)
    if (change.time <= report.probedAt) lines[{change.target, change.property}] = change.line;
  for (const auto& [id, track] : report.undisturbed.tracks)
    if (!movesByItself(report, id)) lines[{id, "CFrame"}] = moverOf(report.undisturbed, id, track);
  return lines;
}

}  // namespace

std::vector<Settled> settledIn(const Document& file, const Document& document,
                               const engine::Report& report) {
  const Tree tree(file);
  std::vector<Settled> all;
  for (const auto& [key, line] : settlingLines(report)) {
    const auto& [id, property] = key;
    if (id >= file.instances.size() || !isPartClass(file.instances[id].className)) continue;
    const Instance &before = file.instances[id], &after = document.instances[id];
    const bool isGone = before.parent != kNoInstance && after.parent == kNoInstance;
    if (isGone && property == "Parent") all.push_back({id, tree.path(id), "", line});
    if (isGone) continue;
    if (const auto what = wordsFor(property, before, after))
      all.push_back({id, tree.path(id), *what, line});
  }
  return all;
}

void noteSettled(RoleContext& context, const ObservedPlace& place) {
  for (const Settled& settled : place.settled) {
    const std::string reason = lineReason(context.tree, settled.line);
    if (settled.what.empty())
      context.level.noteIgnored("part that a script destroys at start", settled.path, reason);
    else if (PartDraft* const part = context.part(settled.id); !part)
      continue;
    else if (settled.line.script == kNoInstance && !part->solid)
      part->evidence.push_back(passedEvidence(context.tree.at(settled.id)));
    else
      part->evidence.push_back({"scripted", settled.what + "; " + reason, false});
  }
}

}  // namespace obby::importer
