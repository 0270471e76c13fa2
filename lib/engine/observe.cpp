// The undisturbed run, and the probes that fork from it.
#include "engine/observe.h"

#include <sys/mman.h>

#include <algorithm>

#include "engine/air_jumps.h"
#include "engine/child.h"
#include "engine/later_round.h"
#include "engine/move_run.h"
#include "engine/probe_choice.h"
#include "engine/probe_round.h"
#include "engine/probe_run.h"
#include "engine/report_bytes.h"
#include "engine/revisit.h"
#include "engine/stage.h"

namespace obby::engine {
namespace {

constexpr double kStuck = 2;  // seconds of CPU without a beat until the child counts as hung
// Revisits may use this share of the time limit. They run once, during the rest of the undisturbed
// run.
constexpr double kRevisitShare = 0.75;
constexpr size_t kProcessMemory = size_t(2) << 30;

// Runs in the sandboxed child and does all but the probes themselves.
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
    stage_.unshield();
    report_.probedAt = plan_.probeAt;
    report_.made = stage_.made();
    report_.collisionGroups = stage_.groups();
    report_.arrived = stage_.observation().player;
    const bool isOver = stage_.isIdle();
    moves_.run(report_.moves);
    probeAll();
    if (stage_.hearsJumps()) jumpInAir();
    revisitAll();
    stage_.run(framesOf(plan_.probeSeconds));
    runUntil(std::max(0.0, plan_.seconds - plan_.probeSeconds));
    LaterRound later(stage_, plan_, children_, report_);
    if (!isOver && !stage_.isExhausted()) later.look();
    runUntil(std::max(plan_.seconds, report_.lookedAgainAt + plan_.probeSeconds));
    report_.undisturbed = stage_.observation();
    later.dropGone();
    report_.complete = !stage_.isExhausted();
    report_.over = report_.complete && stage_.isIdle();
    report_.sleeps = stage_.sleeps();
    if (!report_.complete) report_.failure = "the scripts used up their time or memory";
    report_.culprit = stage_.greedyScript();
    children_.finish();
    return std::move(report_);
  }

 private:
  // Runs until that second, or until nothing more can happen.
  void runUntil(double seconds) {
    while (stage_.frames() < framesOf(seconds) && !stage_.isExhausted() && !stage_.isIdle())
      stage_.run(60);
  }

  // Returns a report without probes: the caller repeats the run without the culprit.
  Report given(InstanceId culprit) {
    report_.undisturbed = stage_.observation();
    report_.culprit = culprit;
    report_.failure = "a script uses too much memory";
    return std::move(report_);
  }

  void probeAll() {
    std::vector<Probe> wanted = stage_.probes();
    moves_.addTargets(wanted);
    Choice chosen = choose(std::move(wanted), plan_.maxProbes);
    if (!chosen.isAll) report_.failure = kTooManyParts;
    report_.sameListeners = std::move(chosen.same);
    report_.probes = ProbeRound(stage_, plan_, children_).run(chosen.probes);
  }

  void jumpInAir() {
    children_.start(
        plan_.timeLimit * kCopyShare, [&] { return toBytes(findAirJumps(stage_)); },
        [this](const std::string& bytes) {
          if (!fromBytes(bytes, report_.airJumps)) report_.airJumps = {};
        });
  }

  // Starts the revisits, which run in parallel with the undisturbed run.
  void revisitAll() {
    children_.start(
        plan_.timeLimit * kRevisitShare,
        [&] { return toBytes(revisit(stage_, plan_, report_.probes)); },
        [this](const std::string& bytes) {
          if (!fromBytes(bytes, report_.revisits) && report_.failure.empty())
            report_.failure = "testing later touches of parts took too long";
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
  // The child stores the id of the running script here. The parent reads it if the child dies.
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
          report.failure = "no script ran, as the sandbox could not be started";
          return toBytes(report);
        }
        return toBytes(Watcher(document, own).watch());
      },
      [&](const std::string& bytes) {
        if (!fromBytes(bytes, report)) {
          report = {};
          report.failure = "the scripts took too long or crashed";
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
        {script, "left out, as it uses too much time or memory", 1, Failure::limited});
  return report;
}

}  // namespace obby::engine
