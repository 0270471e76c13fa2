#include "import/observed/own_changes.h"

#include <cmath>
#include <set>
#include <string>
#include <tuple>

namespace obby::importer {

using engine::Change;
using engine::kFrame;

namespace {

// Returns the probe's changes without those of the undisturbed run at the same time.
std::vector<const Change*> ownChanges(const engine::Report& report, const engine::Probe& probe) {
  std::multiset<std::tuple<int64_t, InstanceId, std::string>> usual;
  const auto key = [](const Change& change) {
    return std::tuple(int64_t(std::llround(change.time / kFrame)), change.target, change.property);
  };
  for (const Change& change : report.undisturbed.changes)
    if (change.time >= probe.at) usual.insert(key(change));
  std::vector<const Change*> own;
  for (const Change& change : probe.seen.changes) {
    const auto same = usual.find(key(change));
    if (same != usual.end())
      usual.erase(same);
    else
      own.push_back(&change);
  }
  return own;
}

}  // namespace

std::vector<const engine::Probe*> movesBefore(const engine::Report& report,
                                              const engine::Probe& probe) {
  std::vector<const engine::Probe*> before;
  if (!engine::isTouch(probe.approach)) return before;
  for (const engine::Probe& move : report.moves) {
    const bool walks = move.approach == engine::Approach::walk &&
                       move.seen.heeded.contains("Humanoid.MoveDirection");
    if (!move.lost && (walks || move.approach == engine::Approach::away)) before.push_back(&move);
  }
  return before;
}

std::vector<const Change*> changesByTouch(const engine::Report& report,
                                          const engine::Probe& probe) {
  std::vector<const Change*> own = ownChanges(report, probe);
  std::set<std::tuple<InstanceId, std::string, engine::Line>> moved;
  for (const engine::Probe* const move : movesBefore(report, probe))
    for (const Change* change : ownChanges(report, *move))
      moved.insert({change->target, change->property, change->line});
  std::erase_if(own, [&](const Change* change) {
    return moved.contains({change->target, change->property, change->line});
  });
  return own;
}

}  // namespace obby::importer
