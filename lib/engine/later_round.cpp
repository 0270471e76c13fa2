#include "engine/later_round.h"

#include <algorithm>

#include "engine/effect_names.h"
#include "engine/probe_choice.h"
#include "engine/probe_round.h"

namespace obby::engine {
namespace {

// Max parts of the first round that are probed again: per set of listeners, without listeners, and
// in all. If one of them differs, up to kMaxRest others with the same listeners follow.
constexpr uint32_t kSameAgain = 3, kByPlaceAgain = 20;
constexpr size_t kMaxAgain = 100, kMaxRest = 300;

}  // namespace

LaterRound::LaterRound(Stage& stage, const Plan& plan, Children& children, Report& report)
    : stage_(stage), plan_(plan), children_(children), report_(report) {}

void LaterRound::look() {
  stage_.revive();
  report_.lookedAgainAt = stage_.frames() / 60.0;
  const Observation& seen = stage_.observation();
  usualFirst_ = namesIn(seen, report_.probedAt, report_.probedAt + plan_.probeSeconds);
  if (!stage_.isIdle())
    usualNow_ = namesIn(seen, report_.lookedAgainAt - plan_.probeSeconds, report_.lookedAgainAt);
  addMade();
  split();
  probeAgain();
  probeNew();
}

void LaterRound::addMade() {
  std::set<InstanceId> known;
  for (const MadePart& made : report_.made) known.insert(made.id);
  for (MadePart& made : stage_.made()) {
    if (known.contains(made.id)) continue;
    made.later = true;
    report_.made.push_back(std::move(made));
  }
}

void LaterRound::dropGone() {
  std::set<InstanceId> there;
  for (const MadePart& made : stage_.made()) there.insert(made.id);
  std::erase_if(report_.made,
                [&](const MadePart& made) { return made.later && !there.contains(made.id); });
}

// Chooses the targets to probe again. Targets with changed listeners are always among them.
void LaterRound::split() {
  std::set<InstanceId> untried;
  for (const SameListeners& same : report_.sameListeners) untried.insert(same.target);
  for (size_t i = 0; i < report_.probes.size(); ++i) first_[report_.probes[i].target] = i;
  std::map<uint64_t, uint32_t> counts;  // number of second probes, by listenerHash
  for (Probe& probe : stage_.probes()) {
    const auto first = first_.find(probe.target);
    if (first == first_.end()) {
      if (!untried.contains(probe.target)) fresh_.push_back(std::move(probe));
      continue;
    }
    const bool isNew = report_.probes[first->second].listenerHash != probe.listenerHash;
    const uint32_t max = probe.listenerHash == 0 ? kByPlaceAgain : kSameAgain;
    const bool isOneOfFew = again_.size() < kMaxAgain && counts[probe.listenerHash]++ < max;
    (isNew || isOneOfFew ? again_ : rest_).push_back(std::move(probe));
  }
}

void LaterRound::probeNew() {
  Choice chosen = choose(std::move(fresh_), plan_.maxProbes);
  if (!chosen.isAll) report_.failure = kTooManyParts;
  const auto before = uint32_t(report_.probes.size());
  for (const SameListeners& same : chosen.same)
    report_.sameListeners.push_back({same.target, before + same.probe});
  for (Probe& probe : ProbeRound(stage_, plan_, children_).run(chosen.probes))
    report_.probes.push_back(std::move(probe));
}

void LaterRound::probeAgain() {
  std::set<uint64_t> differing;  // hashes of listeners
  const auto run = [&](const std::vector<Probe>& wanted) {
    for (const Probe& probe : ProbeRound(stage_, plan_, children_).run(wanted))
      if (compare(probe) && probe.listenerHash != 0) differing.insert(probe.listenerHash);
  };
  run(again_);
  std::erase_if(rest_, [&](const Probe& probe) { return !differing.contains(probe.listenerHash); });
  if (rest_.size() > kMaxRest) report_.failure = kTooManyParts;
  if (rest_.size() > kMaxRest) rest_.resize(kMaxRest);
  run(rest_);
}

// Returns true if the probe differs from the first one. Adds it to the revisits unless one of them
// shows the same.
bool LaterRound::compare(const Probe& again) {
  const Probe& first = report_.probes[first_.at(again.target)];
  if (again.lost || first.lost) return false;
  const Names effects = effectsIn(again, usualNow_);
  if (!differ(effectsIn(first, usualFirst_), effects)) return false;
  const bool isKnown =
      std::any_of(report_.revisits.begin(), report_.revisits.end(), [&](const Revisit& revisit) {
        return revisit.probe.target == again.target &&
               !differ(effectsIn(revisit.probe, usualNow_), effects);
      });
  if (!isKnown) report_.revisits.push_back({again, Cause::time, kNoInstance});
  return true;
}

}  // namespace obby::engine
