// The undisturbed run, and the probes that fork from it.
#include "engine/report.h"

#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "engine/air_jumps.h"
#include "engine/child.h"
#include "engine/effect_names.h"
#include "engine/fall_looks.h"
#include "engine/move_run.h"
#include "engine/probe_run.h"
#include "engine/report_bytes.h"
#include "engine/revisit.h"
#include "engine/stage.h"

namespace obby::engine {

namespace {

constexpr double kStuck = 2;  // seconds of CPU without a beat
// Probes of parts with the same listeners, if there are too many parts for all: more of them rarely
// show anything new.
constexpr uint32_t kMaxSameListeners = 100;
// Those of them whose player may die: each death takes RespawnTime, 300 frames by default.
constexpr uint32_t kMaxComebacks = 40;
// Second looks at parts that harm, of parts with the same listeners.
constexpr uint32_t kMaxSecondLooks = 20;
// Shares of the whole time limit. One copy of the place that hangs must leave time for the others;
// revisits run once, during the rest of the undisturbed run.
constexpr double kCopyShare = 0.25, kRevisitShare = 0.75;
constexpr size_t kProcessMemory = size_t(2) << 30;

// In the caged child: everything but the probes themselves.
class Watcher {
 public:
  Watcher(const Document& document, const Plan& plan)
      : plan_(plan),
        stage_(document, plan.settings),
        children_(plan.processes),
        moves_(stage_, plan, children_) {}

  Report watch() {
    watchBeat(stage_.beat(), kStuck);
    stage_.start();
    stage_.run(framesOf(plan_.probeAt));
    if (stage_.greedyScript() != kNoInstance) return given(stage_.greedyScript());
    stage_.revive();
    report_.probedAt = plan_.probeAt;
    report_.made = stage_.made();
    report_.collisionGroups = stage_.groups();
    report_.arrived = stage_.observation().player;
    moves_.run(report_.moves);
    probeAll();
    if (stage_.hearsJumps()) jumpInAir();
    revisitAll();
    stage_.run(framesOf(plan_.probeSeconds));
    while (stage_.frames() < framesOf(plan_.seconds) && !stage_.isExhausted() && !stage_.isIdle())
      stage_.run(60);
    report_.undisturbed = stage_.observation();
    report_.complete = !stage_.isExhausted();
    report_.over = report_.complete && stage_.isIdle();
    report_.sleeps = stage_.sleeps();
    if (!report_.complete) report_.failure = "the scripts' budget was used up";
    report_.culprit = stage_.greedyScript();
    children_.finish();
    return std::move(report_);
  }

 private:
  // Not worth while: it is done again without that script.
  Report given(InstanceId culprit) {
    report_.undisturbed = stage_.observation();
    report_.culprit = culprit;
    report_.failure = "a script uses too much memory";
    return std::move(report_);
  }

  void probeAll() {
    std::vector<Probe> wanted = stage_.probes();
    moves_.addTargets(wanted);
    if (wanted.size() > plan_.mostProbes) choose(wanted);
    for (Probe& probe : wanted) probe.at = plan_.probeAt;
    report_.probes.resize(wanted.size());
    runAll(wanted);
    children_.finish();
    lookAgainAtHarm(wanted);
    lookAtFalls(stage_, plan_, children_, wanted, report_.probes);
    for (size_t i = 0; i < wanted.size(); ++i)
      if (wanted[i].byPlace && happens(report_.probes[i])) {
        lookAllOver(wanted[i], i);
        if (wanted[i].approach == Approach::inside) lookFromOutside(wanted[i], i);
      }
  }

  // Keeps the first part of each set of listeners, then the second of each, and so on, in order.
  void choose(std::vector<Probe>& wanted) {
    std::map<uint64_t, uint32_t> seen;
    std::vector<std::pair<uint32_t, size_t>> ranks;  // number of earlier parts with its listeners
    for (size_t i = 0; i < wanted.size(); ++i)
      ranks.emplace_back(seen[wanted[i].listenerHash]++, i);
    std::sort(ranks.begin(), ranks.end());
    std::vector<bool> taken(wanted.size());
    for (size_t i = 0; i < plan_.mostProbes; ++i) {
      const auto& [rank, index] = ranks[i];
      taken[index] = rank < kMaxSameListeners || wanted[index].listenerHash == 0;
    }
    std::vector<Probe> probes;
    std::map<uint64_t, uint32_t> first;  // probe by listenerHash
    for (size_t i = 0; i < wanted.size(); ++i) {
      if (!taken[i]) continue;
      if (wanted[i].listenerHash != 0)
        first.emplace(wanted[i].listenerHash, uint32_t(probes.size()));
      probes.push_back(wanted[i]);
    }
    for (size_t i = 0; i < wanted.size(); ++i) {
      if (taken[i]) continue;
      const auto found = first.find(wanted[i].listenerHash);
      if (found != first.end())
        report_.sameListeners.push_back({wanted[i].target, found->second});
      else
        report_.failure = "too many parts to touch";
    }
    wanted = std::move(probes);
  }

  static bool happens(const Probe& probe) {
    return !probe.seen.changes.empty() || !probe.seen.harms.empty();
  }

  static bool happensAgain(const Probe& first, const Probe& again) {
    return harms(first) ? harms(again) : happens(again);
  }

  void lookAgainAtHarm(const std::vector<Probe>& wanted) {
    std::map<uint64_t, uint32_t> looks;  // by listenerHash
    for (size_t i = 0; i < wanted.size(); ++i) {
      const auto stay = secondLookAt(report_.probes[i]);
      if (!stay || looks[wanted[i].listenerHash]++ >= kMaxSecondLooks) continue;
      children_.start(
          plan_.timeLimit * kCopyShare,
          [&, i, stay] { return toBytes(lookAgain(stage_, plan_, wanted[i], *stay)); },
          [this, i, stay](const std::string& bytes) {
            SecondLook& look = secondLookOf(report_.probes[i], *stay);
            if (!fromBytes(bytes, look)) look = {};
          });
    }
    children_.finish();
  }

  void lookAllOver(const Probe& wanted, size_t index) {
    constexpr float kTowardsCorner = 0.8f;
    for (const float share : {kTowardsCorner, -kTowardsCorner})
      children_.start(
          plan_.timeLimit * kCopyShare,
          [&, share] { return toBytes(runProbe(stage_, plan_, wanted, {.share = share})); },
          [this, index](const std::string& bytes) {
            Probe probe;
            Probe& first = report_.probes[index];
            if (!fromBytes(bytes, probe) || !happensAgain(first, probe)) first.allOver = false;
          });
  }

  // Before three faces: a script that looks at the middle of the body does not see it in the part.
  void lookFromOutside(const Probe& wanted, size_t index) {
    report_.probes[index].byRoot = true;
    for (const int face : {1, 2, 3})
      children_.start(
          plan_.timeLimit * kCopyShare,
          [&, face] { return toBytes(runProbe(stage_, plan_, wanted, {.face = face})); },
          [this, index](const std::string& bytes) {
            Probe probe;
            Probe& first = report_.probes[index];
            if (!fromBytes(bytes, probe) || happensAgain(first, probe)) first.byRoot = false;
          });
  }

  void runAll(const std::vector<Probe>& wanted) {
    std::map<uint64_t, uint32_t> seen;  // probes by listenerHash
    for (size_t i = 0; i < wanted.size(); ++i) {
      const bool comesBack =
          wanted[i].listenerHash == 0 || seen[wanted[i].listenerHash]++ < kMaxComebacks;
      report_.probes[i] = wanted[i];
      stage_.noteWork();
      children_.start(
          plan_.timeLimit * kCopyShare,
          [&, i, comesBack] {
            return toBytes(runProbe(stage_, plan_, wanted[i], {.comesBack = comesBack}));
          },
          [this, i](const std::string& bytes) {
            Probe& probe = report_.probes[i];
            probe.lost = !fromBytes(bytes, probe);
          });
    }
  }

  void jumpInAir() {
    children_.start(
        plan_.timeLimit * kCopyShare, [&] { return toBytes(findAirJumps(stage_)); },
        [this](const std::string& bytes) {
          if (!fromBytes(bytes, report_.airJumps)) report_.airJumps = {};
        });
  }

  // While the undisturbed run goes on.
  void revisitAll() {
    children_.start(
        plan_.timeLimit * kRevisitShare,
        [&] { return toBytes(revisit(stage_, plan_, report_.probes)); },
        [this](const std::string& bytes) {
          if (!fromBytes(bytes, report_.revisits) && report_.failure.empty())
            report_.failure = "later touches of parts took too long";
        });
  }

  const Plan& plan_;
  Stage stage_;
  Children children_;
  Moves moves_;
  Report report_;
};

Report observeOnce(const Document& document, const Plan& plan) {
  Report report;
  // The child leaves the script that runs here, for when it dies.
  void* const shared =
      mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  Plan own = plan;
  if (shared != MAP_FAILED) own.settings.runningScript = static_cast<InstanceId*>(shared);
  if (shared != MAP_FAILED) *own.settings.runningScript = kNoInstance;
  Children children(1);
  children.start(
      plan.timeLimit,
      [&]() -> std::string {
        if (!enterCage(plan.timeLimit, kProcessMemory)) {
          report.failure = "there is no cage to run scripts in";
          return toBytes(report);
        }
        return toBytes(Watcher(document, own).watch());
      },
      [&](const std::string& bytes) {
        if (!fromBytes(bytes, report)) {
          report = {};
          report.failure = "the scripts took too long or broke down";
          if (own.settings.runningScript) report.culprit = *own.settings.runningScript;
        }
      });
  children.finish();
  if (shared != MAP_FAILED) munmap(shared, 4096);
  return report;
}

}  // namespace

Report observe(const Document& document, const Plan& plan) {
  constexpr int kMaxCulprits = 3;
  Plan own = plan;
  Report report = observeOnce(document, own);
  for (int i = 0; i < kMaxCulprits && report.culprit < document.instances.size(); ++i) {
    own.settings.skipped.push_back(report.culprit);
    report = observeOnce(document, own);
  }
  for (const InstanceId script : own.settings.skipped)
    report.undisturbed.problems.push_back(
        {script, "it uses too much time or memory, so it is left out", 1, Failure::limited});
  return report;
}

}  // namespace obby::engine
