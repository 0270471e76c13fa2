#include "engine/fall_looks.h"

#include <algorithm>
#include <map>

#include "engine/effect_names.h"
#include "engine/probe_run.h"
#include "engine/report_bytes.h"

namespace obby::engine {
namespace {

// Events and values that a fall changes.
constexpr const char* kOfFalls[] = {"Limb.Velocity", "Humanoid.FloorMaterial", "Humanoid.GetState"};
constexpr uint32_t kMaxFalls = 20;  // max falls per set of listeners

bool heedsFalls(const Observation& seen) {
  return std::any_of(std::begin(kOfFalls), std::end(kOfFalls),
                     [&](const char* name) { return seen.heeded.contains(name); });
}

void compare(Probe& slow, const Probe& fast) {
  const Names none;
  slow.byFall = differ(effectsIn(slow, none), effectsIn(fast, none));
  slow.seen.happened.insert(fast.seen.happened.begin(), fast.seen.happened.end());
}

}  // namespace

void lookAtFalls(Stage& stage, const Plan& plan, Children& children,
                 const std::vector<Probe>& wanted, std::vector<Probe>& probes) {
  std::map<uint64_t, uint32_t> looks;  // number of probes, by listenerHash
  for (size_t i = 0; i < wanted.size(); ++i) {
    const Probe& first = probes[i];
    if (!isTouch(first.approach) || first.lost || !heedsFalls(first.seen) ||
        looks[wanted[i].listenerHash]++ >= kMaxFalls)
      continue;
    children.start(
        plan.timeLimit * kCopyShare,
        [&, i] { return toBytes(runProbe(stage, plan, wanted[i], {.falls = true})); },
        [&probes, i](const std::string& bytes) {
          Probe fast;
          if (fromBytes(bytes, fast)) compare(probes[i], fast);
        });
  }
  children.finish();
}

}  // namespace obby::engine
