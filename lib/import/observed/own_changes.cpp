#include "import/observed/own_changes.h"

#include <cmath>
#include <set>
#include <string>
#include <tuple>

namespace obby::importer {

using engine::Change;
using engine::kFrame;

namespace {

// The probe's changes without those that came in the undisturbed run at the same time.
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

const engine::Probe* walkBefore(const engine::Report& report, const engine::Probe& probe) {
  if (!engine::isTouch(probe.approach)) return nullptr;
  for (const engine::Probe& move : report.moves)
    if (move.approach == engine::Approach::walk && !move.lost &&
        move.seen.heeded.contains("Humanoid.MoveDirection"))
      return &move;
  return nullptr;
}

std::vector<const Change*> changesByTouch(const engine::Report& report,
                                          const engine::Probe& probe) {
  std::vector<const Change*> own = ownChanges(report, probe);
  const engine::Probe* const walk = walkBefore(report, probe);
  if (!walk) return own;
  std::set<std::tuple<InstanceId, std::string, engine::Line>> walked;
  for (const Change* change : ownChanges(report, *walk))
    walked.insert({change->target, change->property, change->line});
  std::erase_if(own, [&](const Change* change) {
    return walked.contains({change->target, change->property, change->line});
  });
  return own;
}

}  // namespace obby::importer
