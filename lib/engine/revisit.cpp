#include "engine/revisit.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "engine/child.h"
#include "engine/effect_names.h"
#include "engine/probe_run.h"
#include "engine/report_bytes.h"
#include "engine/tour.h"

namespace obby::engine {
namespace {

constexpr uint32_t kTouch = 12, kBetween = 4;  // frames of a touch, and after it
constexpr uint32_t kShortTouch = 4, kLongTour = 100;
constexpr double kMinSettle = 1, kMaxSettle = 20;  // seconds after the tour
constexpr size_t kMaxPatient = 32;                 // parts that had no effect at first
constexpr size_t kMaxProbed = 100;                 // parts that kill come last
constexpr uint64_t kOfOneTour = 20'000'000, kOfAll = 100'000'000;  // instructions

class Tour {
 public:
  Tour(Stage& stage, const Plan& plan, const std::vector<Probe>& first)
      : stage_(stage), plan_(plan), first_(first) {
    for (size_t i = 0; i < first.size(); ++i)
      if (!kills(first[i])) choose(i);
    for (size_t i = 0; i < first.size() && probed_.size() < kMaxProbed; ++i)
      if (kills(first[i])) probed_.push_back(i);
  }

  std::vector<Revisit> revisits() {
    if (probed_.empty()) return {};
    repeatPasses();
    const TourSeen seen = tour(touched_, probed_);
    usual_ = usualUntil(seen.end + plan_.probeSeconds);
    std::vector<Revisit> found;
    for (size_t k = 1; k < seen.touches.size(); ++k) {
      const Names effects = effectsIn(seen.touches[k], usual_);
      if (!adds(effectsIn(first_[touched_[k]], usual_), effects)) continue;
      const std::vector<size_t> before(touched_.begin(), touched_.begin() + std::ptrdiff_t(k));
      for (const TourMode mode : {TourMode{}, TourMode{.settles = false}}) {
        if (isKnown(touched_[k], found)) break;
        const TourSeen again = tour(before, {touched_[k]}, mode);
        if (!again.probes.empty())
          take(touched_[k], again.probes[0], namesIn(again.after), before, found, mode);
      }
    }
    for (size_t i = 0; i < seen.probes.size(); ++i)
      take(probed_[i], seen.probes[i], {}, touched_, found);
    return found;
  }

 private:
  // Adds a part to the tour if it may have an effect and does not kill the player.
  void choose(size_t i) {
    const Probe& probe = first_[i];
    const bool silent = probe.seen.changes.empty() && probe.seen.harms.empty();
    if (probe.lost || (silent && probe.byPlace)) return;
    touched_.push_back(i);
    if (probed_.size() < kMaxProbed) probed_.push_back(i);
    if (silent && isTouch(probe.approach) && patient_.size() < kMaxPatient) patient_.insert(i);
  }

  // Repeats the tour: some parts act only in an order, or after several touches. The number of
  // passes is odd, so that a switch that toggles ends on.
  void repeatPasses() {
    constexpr size_t kMaxTouches = 60, kMaxPasses = 5;
    const std::vector<size_t> once = touched_;
    size_t passes = kMaxPasses;
    while (passes > 1 && passes * once.size() > kMaxTouches) passes -= 2;
    for (size_t pass = 1; pass < passes; ++pass)
      touched_.insert(touched_.end(), once.begin(), once.end());
  }

  bool isKnown(size_t i, const std::vector<Revisit>& found) const {
    return std::any_of(found.begin(), found.end(), [&](const Revisit& other) {
      return other.probe.target == first_[i].target;
    });
  }

  // Adds a probe of part `i` to `found` if its effects are new; `after`: effects without the probe.
  void take(size_t i, Probe probe, const Names& after, const std::vector<size_t>& touched,
            std::vector<Revisit>& found, TourMode mode = {}) {
    drop(probe.seen, after);
    const Names before = effectsIn(first_[i], usual_), effects = effectsIn(probe, usual_);
    // Without time to settle, a missing effect may still follow.
    const bool isOther = mode.settles ? differ(before, effects) : adds(before, effects);
    if (isKnown(i, found) || probe.lost || !isOther) return;
    Revisit revisit;
    revisit.probe = std::move(probe);
    explain(i, effects, touched, mode, revisit);
    found.push_back(std::move(revisit));
  }

  // Runs `body` in a copy of the place and returns its result.
  std::string inCopy(const std::function<std::string()>& body) {
    std::string bytes;
    Children children(1);
    children.start(plan_.timeLimit / 4, body, [&](const std::string& all) { bytes = all; });
    children.finish();
    return bytes;
  }

  // Touches `touched` in order, then probes each of `probed`. Returns the effects of each.
  TourSeen tour(const std::vector<size_t>& touched, const std::vector<size_t>& probed,
                TourMode mode = {}) {
    TourSeen seen;
    const bool isShort = touched.size() > kLongTour;
    if (used_ >= kOfAll) return seen;
    fromBytes(inCopy([&] {
                stage_.limit(kOfOneTour);
                const uint64_t left = stage_.left();
                stage_.restart();
                for (const size_t i : touched) {
                  if (!seen.touches.empty()) seen.touches.back().seen = stage_.observation();
                  seen.touches.push_back(first_[i]);
                  if (mode.touches)
                    touch(i, isShort);
                  else
                    stage_.run(kTouch + kBetween);
                }
                if (mode.settles) settle();
                if (!seen.touches.empty()) seen.touches.back().seen = stage_.observation();
                seen.used = left - stage_.left();
                seen.probes = probeAll(affordable(probed, seen.used), mode.patiently);
                seen.end = stage_.frames() / 60.0;
                if (!mode.settles) runOn(seen);
                return toBytes(std::move(seen));
              }),
              seen);
    used_ += seen.used;
    return seen;
  }

  // Returns the first of `probed`, as many as fit the budget at the tour's mean cost of a frame.
  // `used`: instructions of the tour.
  std::vector<size_t> affordable(std::vector<size_t> probed, uint64_t used) const {
    constexpr uint64_t kFrames = 150;  // length of a probe
    if (stage_.isExhausted()) return {};
    const uint64_t frames = stage_.frames() - framesOf(plan_.probeAt) + 1;
    const uint64_t max = kOfAll / (kFrames * (used / frames + 1));
    if (max < probed.size()) probed.resize(max);
    return probed;
  }

  void touch(size_t i, bool isShort) {
    const Probe& probe = first_[i];
    stage_.forget();  // drops earlier observations
    if (!isTouch(probe.approach)) {
      const bool lasts = stage_.use(probe.target);
      stage_.run(kBetween);
      if (lasts) stage_.release(probe.target);
      return;
    }
    for (uint32_t frame = 0; frame < (isShort ? kShortTouch : kTouch); ++frame) {
      stage_.standAt(probe.target, probe.approach == Approach::inside, 0);
      stage_.run(1);
    }
    stage_.leave();
    stage_.run(isShort ? 1 : kBetween);
    stage_.revive();
  }

  void runOn(TourSeen& seen) {
    stage_.restart();
    stage_.run(framesOf(plan_.probeSeconds));
    seen.after = stage_.observation();
    if (stage_.isExhausted()) seen.probes.clear();
  }

  void settle() {
    const uint32_t begun = stage_.frames();
    const auto passed = [&] { return stage_.frames() - begun; };
    while (!stage_.isExhausted() && (passed() < framesOf(kMinSettle) ||
                                     (stage_.isBusy() && passed() < framesOf(kMaxSettle))))
      stage_.run(10);
    stage_.revive();
  }

  std::vector<Probe> probeAll(const std::vector<size_t>& probed, bool patiently) {
    std::vector<Probe> probes(probed.size());
    Children children(plan_.processes);
    for (size_t i = 0; i < probed.size(); ++i)
      children.start(
          plan_.timeLimit / 8, [&, i] { return toBytes(probeAgain(probed[i], patiently)); },
          [&, i](const std::string& bytes) { probes[i].lost = !fromBytes(bytes, probes[i]); });
    children.finish();
    for (size_t i = 0; i < probed.size(); ++i)
      if (const auto stay = secondLookAt(probes[i]))
        children.start(
            plan_.timeLimit / 8,
            [&, i, stay] { return toBytes(lookAgain(stage_, plan_, prepared(probed[i]), *stay)); },
            [&, i, stay](const std::string& bytes) {
              SecondLook& look = secondLookOf(probes[i], *stay);
              if (!fromBytes(bytes, look)) look = {};
            });
    children.finish();
    return probes;
  }

  // Returns a probe for part `i`. A part that kills is touched first, to probe the next body.
  Probe prepared(size_t i) {
    Probe probe = first_[i];
    if (kills(probe)) {
      touch(i, false);
      stage_.run(framesOf(1));
    }
    probe.seen = {};
    probe.brief = probe.still = {};
    probe.at = stage_.frames() / 60.0;
    return probe;
  }

  Probe probeAgain(size_t i, bool patiently) {
    Probe probe = prepared(i);
    probe =
        runProbe(stage_, plan_, std::move(probe), {.patient = patiently && patient_.contains(i)});
    probe.lost = stage_.isExhausted();
    return probe;
  }

  Names usualUntil(double seconds) {
    Observation seen;
    fromBytes(inCopy([&] {
                stage_.limit(kOfOneTour);
                stage_.restart();
                const uint32_t end = framesOf(seconds), now = stage_.frames();
                stage_.run(end > now ? end - now : 0);
                return toBytes(stage_.observation());
              }),
              seen);
    return namesIn(seen);
  }

  // Returns true if the part has the same effects after touches of `touched`.
  bool sameAfter(size_t i, const Names& effects, const std::vector<size_t>& touched,
                 TourMode mode = {}) {
    TourSeen seen = tour(touched, {i}, mode);
    if (seen.probes.empty()) return false;
    drop(seen.probes[0].seen, namesIn(seen.after));
    const Names now = effectsIn(seen.probes[0], usual_);
    return !differ(effects, now) && !differ(now, effects);
  }

  void explain(size_t i, const Names& effects, const std::vector<size_t>& touched, TourMode mode,
               Revisit& revisit) {
    // A patient probe itself touches the part repeatedly, so the test for `again` excludes it.
    TourMode once = mode, idle = mode;
    once.patiently = idle.patiently = idle.touches = false;
    if (kills(first_[i]) ? sameAfter(i, effects, {}, mode)
                         : sameAfter(i, effects, {i}, once) && !sameAfter(i, effects, {i}, idle))
      revisit.cause = Cause::again;
    else if (sameAfter(i, effects, {}, mode))
      revisit.cause = Cause::time;
    else
      revisit.lever = leverOf(i, effects, touched, mode);
    if (revisit.lever != kNoInstance) revisit.cause = Cause::lever;
  }

  // Bisects `touched`. Returns the part that causes the change, or kNoInstance if several do.
  InstanceId leverOf(size_t i, const Names& effects, std::vector<size_t> touched, TourMode mode) {
    if (lastLever_ && sameAfter(i, effects, {*lastLever_}, mode)) return first_[*lastLever_].target;
    while (touched.size() > 1) {
      const auto middle = touched.begin() + std::ptrdiff_t(touched.size() / 2);
      std::vector<size_t> low(touched.begin(), middle), high(middle, touched.end());
      if (sameAfter(i, effects, low, mode))
        touched = std::move(low);
      else if (sameAfter(i, effects, high, mode))
        touched = std::move(high);
      else
        return kNoInstance;
    }
    if (touched.empty()) return kNoInstance;
    lastLever_ = touched[0];
    return first_[touched[0]].target;
  }

  Stage& stage_;
  const Plan& plan_;
  const std::vector<Probe>& first_;
  std::vector<size_t> touched_, probed_;
  std::set<size_t> patient_;
  Names usual_;
  uint64_t used_ = 0;
  std::optional<size_t> lastLever_;
};

}  // namespace

std::vector<Revisit> revisit(Stage& stage, const Plan& plan, const std::vector<Probe>& first) {
  return Tour(stage, plan, first).revisits();
}

}  // namespace obby::engine
