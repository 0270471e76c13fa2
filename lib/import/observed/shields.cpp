#include "import/observed/shields.h"

#include "engine/classes/class_defaults.h"
#include "import/observed/place.h"

namespace obby::importer {
namespace {

const engine::Change* fieldIn(const engine::Observation& seen) {
  for (const engine::Change& change : seen.changes)
    if (change.property == "note force field") return &change;
  return nullptr;
}

}  // namespace

std::string shieldIn(RoleContext& context, const engine::Report& report) {
  const Tree& tree = context.tree;
  const engine::Change* field = fieldIn(report.undisturbed);
  for (const engine::Probe& probe : report.probes) field = field ? field : fieldIn(probe.seen);
  for (const engine::Revisit& revisit : report.revisits)
    field = field ? field : fieldIn(revisit.probe.seen);
  if (field) return lineReason(tree, field->line);
  for (InstanceId id = 0; id < tree.size(); ++id) {
    const Instance& spawn = tree.at(id);
    if (spawn.className == "SpawnLocation" && context.part(id) && get<bool>(spawn, "Enabled") &&
        get<int64_t>(spawn, "Duration") > 0)
      return spawn.name + " gives one for " + std::to_string(get<int64_t>(spawn, "Duration")) +
             " s";
  }
  return {};
}

}  // namespace obby::importer
