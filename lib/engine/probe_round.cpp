#include "engine/probe_round.h"

#include <map>

#include "engine/effect_names.h"
#include "engine/fall_looks.h"
#include "engine/probe_run.h"
#include "engine/report_bytes.h"

namespace obby::engine {
namespace {

// Max probes of parts with the same listeners in which the player may die. Each death takes
// RespawnTime, 300 frames by default.
constexpr uint32_t kMaxComebacks = 40;
// Max second probes of harmful parts with the same listeners.
constexpr uint32_t kMaxSecondLooks = 20;

bool happens(const Probe& probe) {
  return !probe.seen.changes.empty() || !probe.seen.harms.empty();
}

bool happensAgain(const Probe& first, const Probe& again) {
  return harms(first) ? harms(again) : happens(again);
}

}  // namespace

std::vector<Probe> ProbeRound::run(std::vector<Probe> wanted) {
  for (Probe& probe : wanted) probe.at = stage_.frames() / 60.0;
  probes_.resize(wanted.size());
  runAll(wanted);
  children_.finish();
  lookAgainAtHarm(wanted);
  lookAtFalls(stage_, plan_, children_, wanted, probes_);
  for (size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i].byPlace && happens(probes_[i])) {
      lookAllOver(wanted[i], i);
      if (wanted[i].approach == Approach::inside) lookFromOutside(wanted[i], i);
    }
  children_.finish();
  return std::move(probes_);
}

void ProbeRound::lookAgainAtHarm(const std::vector<Probe>& wanted) {
  std::map<uint64_t, uint32_t> looks;  // number of second probes, by listenerHash
  for (size_t i = 0; i < wanted.size(); ++i) {
    const auto stay = secondLookAt(probes_[i]);
    if (!stay || looks[wanted[i].listenerHash]++ >= kMaxSecondLooks) continue;
    children_.start(
        limit_, [&, i, stay] { return toBytes(lookAgain(stage_, plan_, wanted[i], *stay)); },
        [this, i, stay](const std::string& bytes) {
          SecondLook& look = secondLookOf(probes_[i], *stay);
          if (!fromBytes(bytes, look)) look = {};
        });
  }
  children_.finish();
}

void ProbeRound::lookAllOver(const Probe& wanted, size_t index) {
  constexpr float kTowardsCorner = 0.8f;
  for (const float share : {kTowardsCorner, -kTowardsCorner})
    children_.start(
        limit_, [&, share] { return toBytes(runProbe(stage_, plan_, wanted, {.share = share})); },
        [this, index](const std::string& bytes) {
          Probe probe;
          Probe& first = probes_[index];
          if (!fromBytes(bytes, probe) || !happensAgain(first, probe)) first.allOver = false;
        });
}

// Probes in front of three faces, where the middle of the body is outside the part. Scripts that
// check the middle then do not see it in the part.
void ProbeRound::lookFromOutside(const Probe& wanted, size_t index) {
  probes_[index].byRoot = true;
  for (const int face : {1, 2, 3})
    children_.start(
        limit_, [&, face] { return toBytes(runProbe(stage_, plan_, wanted, {.face = face})); },
        [this, index](const std::string& bytes) {
          Probe probe;
          Probe& first = probes_[index];
          if (!fromBytes(bytes, probe) || happensAgain(first, probe)) first.byRoot = false;
        });
}

void ProbeRound::runAll(const std::vector<Probe>& wanted) {
  std::map<uint64_t, uint32_t> seen;  // probes by listenerHash
  for (size_t i = 0; i < wanted.size(); ++i) {
    const bool comesBack =
        wanted[i].listenerHash == 0 || seen[wanted[i].listenerHash]++ < kMaxComebacks;
    probes_[i] = wanted[i];
    stage_.noteWork();
    children_.start(
        limit_,
        [&, i, comesBack] {
          return toBytes(runProbe(stage_, plan_, wanted[i], {.comesBack = comesBack}));
        },
        [this, i](const std::string& bytes) {
          Probe& probe = probes_[i];
          probe.lost = !fromBytes(bytes, probe);
        });
  }
}

}  // namespace obby::engine
