// The undisturbed run, and the probes that fork from it.
#include "engine/report.h"

#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/archive.h"
#include "engine/child.h"
#include "engine/stage.h"

namespace obby::engine {

// ADL finds these for the archives.
template <class A>
void fields(A& a, Change& c) {
  a(c.time), a(c.target), a(c.property), a(c.value), a(c.line);
}
template <class A>
void fields(A& a, Track& t) {
  a(t.start), a(t.poses), a(t.line);
}
template <class A>
void fields(A& a, TweenWay& w) {
  a(w.property), a(w.from), a(w.to);
}
template <class A>
void fields(A& a, Tween& t) {
  a(t.time), a(t.id), a(t.target), a(t.seconds), a(t.delay), a(t.style), a(t.direction),
      a(t.repeats);
  a(t.reverses), a(t.ways), a(t.line);
}
template <class A>
void fields(A& a, Problem& p) {
  a(p.script), a(p.text), a(p.count);
}
template <class A>
void fields(A& a, MadePart& m) {
  a(m.id), a(m.origin), a(m.className), a(m.name), a(m.properties);
}
template <class A>
void fields(A& a, Observation& o) {
  a(o.changes), a(o.tracks), a(o.tweens), a(o.harms), a(o.problems), a(o.counts), a(o.player);
  a(o.frames);
}
template <class A>
void fields(A& a, Probe& p) {
  a(p.target), a(p.approach), a(p.at), a(p.left), a(p.seen), a(p.lost), a(p.byPlace), a(p.allOver);
}
template <class A>
void fields(A& a, Report& r) {
  a(r.undisturbed), a(r.probes), a(r.made), a(r.arrived), a(r.probedAt), a(r.complete), a(r.over),
      a(r.failure), a(r.culprit);
}

namespace {

constexpr double kFrame = 1.0 / 60;
constexpr double kHold = 0.6;     // seconds that a probe stays
constexpr double kSecondHit = 5;  // seconds that it waits to be harmed again
constexpr double kQuiet = 1.0;    // seconds without a change end a probe
constexpr double kAtLeast = 1.5;
constexpr double kStuck = 2;  // seconds of CPU without a beat
constexpr size_t kProcessMemory = size_t(2) << 30;

template <class T>
std::string bytesOf(T& value) {
  BytesOut out;
  out(value);
  return std::move(out.bytes);
}

uint32_t framesOf(double seconds) { return uint32_t(std::lround(seconds / kFrame)); }

// Whether a second hit is still to come after the first.
bool awaitsHit(Stage& stage, double now) {
  double first = -1, last = -1;
  for (const Harm& harm : stage.harms())
    if (harm.to < harm.from) {
      if (first < 0) first = harm.time;
      last = harm.time;
    }
  return first >= 0 && last == first && now < first + kSecondHit;
}

// What a probe does in its copy of the place. One that is harmed and lives touches the part in each
// frame until it is harmed again. `share`: see Stage::standAt.
Probe runProbe(Stage& stage, const Plan& plan, Probe probe, float share = 0) {
  stage.restart();
  const uint32_t most = framesOf(plan.probeSeconds);
  const bool stands = probe.approach != Approach::use;
  uint32_t hold = framesOf(kHold), frame = 0, quiet = 0;
  if (!stands) stage.use(probe.target);
  while (frame < most && (frame < framesOf(kAtLeast) || quiet < framesOf(kQuiet))) {
    const bool again = stands && frame <= hold && awaitsHit(stage, probe.at + frame * kFrame);
    if (again) hold = std::max(hold, frame + 1);
    if (stands && frame < hold)
      stage.standAt(probe.target, probe.approach == Approach::inside, share);
    else if (stands && frame == hold)
      stage.leave();
    if (again) stage.touchAgain();
    const size_t before = stage.activity();
    stage.run(1);
    ++frame;
    quiet = stage.activity() == before && !stage.isBusy() && !again ? quiet + 1 : 0;
    if (!stage.playerLives()) break;
  }
  probe.left = probe.at + hold * kFrame;
  probe.seen = stage.observation();
  return probe;
}

// In the caged child: everything but the probes themselves.
class Watcher {
 public:
  Watcher(const Document& document, const Plan& plan)
      : plan_(plan), stage_(document, plan.settings), children_(plan.processes) {}

  Report watch() {
    watchBeat(stage_.beat(), kStuck);
    stage_.start();
    stage_.run(framesOf(plan_.probeAt));
    if (stage_.greedyScript() != kNoInstance) return given(stage_.greedyScript());
    stage_.revive();
    report_.probedAt = plan_.probeAt;
    report_.made = stage_.made();
    report_.arrived = stage_.observation().player;
    probeAll();
    stage_.run(framesOf(plan_.probeSeconds));
    while (stage_.frames() < framesOf(plan_.seconds) && !stage_.isExhausted() && !stage_.isIdle())
      stage_.run(60);
    report_.undisturbed = stage_.observation();
    report_.complete = !stage_.isExhausted();
    report_.over = report_.complete && stage_.isIdle();
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
    if (wanted.size() > plan_.mostProbes) {
      report_.failure = "too many parts to touch";
      wanted.resize(plan_.mostProbes);
    }
    for (Probe& probe : wanted) probe.at = plan_.probeAt;
    report_.probes.resize(wanted.size());
    runAll(wanted);
    children_.finish();
    for (size_t i = 0; i < wanted.size(); ++i)
      if (wanted[i].byPlace && happens(report_.probes[i])) lookAllOver(wanted[i], i);
  }

  static bool happens(const Probe& probe) {
    return !probe.seen.changes.empty() || !probe.seen.harms.empty();
  }

  void lookAllOver(const Probe& wanted, size_t index) {
    constexpr float kTowardsCorner = 0.8f;
    for (const float share : {kTowardsCorner, -kTowardsCorner})
      children_.start(
          plan_.timeLimit / 4,
          [&, share] {
            Probe probe = runProbe(stage_, plan_, wanted, share);
            return bytesOf(probe);
          },
          [this, index](const std::string& bytes) {
            Probe probe;
            BytesIn in(bytes);
            if (!bytes.empty()) in(probe);
            if (!happens(probe)) report_.probes[index].allOver = false;
          });
  }

  void runAll(const std::vector<Probe>& wanted) {
    for (size_t i = 0; i < wanted.size(); ++i) {
      report_.probes[i] = wanted[i];
      children_.start(
          plan_.timeLimit / 4,
          [&, i] {
            Probe probe = runProbe(stage_, plan_, wanted[i]);
            return bytesOf(probe);
          },
          [this, i](const std::string& bytes) {
            BytesIn in(bytes);
            Probe& probe = report_.probes[i];
            if (!bytes.empty()) in(probe);
            probe.lost = bytes.empty() || !in.good;
          });
    }
  }

  const Plan& plan_;
  Stage stage_;
  Children children_;
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
          return bytesOf(report);
        }
        Report seen = Watcher(document, own).watch();
        return bytesOf(seen);
      },
      [&](const std::string& bytes) {
        BytesIn in(bytes);
        if (!bytes.empty()) in(report);
        if (bytes.empty() || !in.good) {
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
  constexpr int kMostCulprits = 3;
  Plan own = plan;
  Report report = observeOnce(document, own);
  for (int i = 0; i < kMostCulprits && report.culprit < document.instances.size(); ++i) {
    own.settings.skipped.push_back(report.culprit);
    report = observeOnce(document, own);
  }
  for (const InstanceId script : own.settings.skipped)
    report.undisturbed.problems.push_back(
        {script, "it uses too much time or memory, so it is left out", 1});
  return report;
}

}  // namespace obby::engine
