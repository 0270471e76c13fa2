// Gives parts the effects of a touch or use: the difference between a probe and the undisturbed
// run.
#include <algorithm>

#include "import/observed/effect_roles.h"
#include "import/observed/effects_of.h"
#include "import/observed/progress.h"
#include "import/observed/revisits.h"
#include "import/observed/roles.h"
#include "import/observed/settle.h"
#include "import/stages/numbers.h"

namespace obby::importer {
namespace {

constexpr const char* kPosition = "acts only while the player's HumanoidRootPart is inside";

class Touches {
 public:
  Touches(RoleContext& context, const engine::Report& report)
      : context_(context), report_(report), roles_(context, report) {}

  void take(const engine::Probe& probe) {
    PartDraft* const part = partOf(probe);
    const ProbeEffects effects = effectsAt(part, probe);
    if (!part) return roles_.takeAbility(probe.approach, report_.airJumps, effects);
    noteFailure(*part, probe, effects.empty());
    if (probe.byFall)
      note("touch that acts differently in a fall", part->id, "simulated as for a walking player");
    if (probe.lost)
      return note("touch whose test failed", part->id,
                  "the scripts took too long or crashed; treated as a plain part");
    if (probe.sleeps)
      note("script still waiting at the end of the run", part->id,
           "the level lacks the effects after the wait");
    if (effects.empty()) {
      if (!probe.byPlace) takeHeardOnly(*part, false);
      return;
    }
    if (!probe.allOver)
      return note("region where scripts act", part->id,
                  "only a region of the part has the effect; treated as a plain part");
    if (effects.stage) part->stageSigns[NumberFrom::asked] = 0;
    if (probe.byPlace) part->touch = true;  // the script polls; it does not wait for a touch
    part->byRoot = probe.byRoot && part->shape == Shape::block && effects.touchesPlayer();
    if (part->byRoot) part->evidence.push_back({"byRoot", kPosition, false});
    roles_.setGuessed(comesLater(probe, effects));
    give(*part, probe, effects);
    noteLater(*part, probe, effects);
    roles_.setGuessed(false);
  }

  // Gives the unprobed part the effects of the probed one, as a guess.
  void take(const engine::SameListeners& unprobed) {
    const engine::Probe& probe = report_.probes[unprobed.probe];
    PartDraft* const part = context_.part(unprobed.target);
    if (!part) return;
    const ProbeEffects effects = effectsAt(partOf(probe), probe);
    const auto own = effects.asOf(probe.target, part->id);
    if (probe.lost || !own)
      return note("touch that was not tested", part->id,
                  "the place has too many parts to test; the effect is unknown");
    if (own->empty()) {
      takeHeardOnly(*part, true);
      return;
    }
    roles_.setGuessed(true);
    roles_.takePlayer(*part, *own);
    roles_.takeParts(*part, false, *own);
    noteLater(*part, probe, *own);
    roles_.setGuessed(false);
  }

  void takeDrives(const engine::Probe& probe) {
    PartDraft* const part = partOf(probe);
    if (part && !probe.lost && probe.allOver && roles_.setsJoints(probe))
      roles_.takeDrives(*part, probe, effectsOf(report_, probe));
  }

  void take(const engine::Revisit& revisit) {
    PartDraft* const part = partOf(revisit.probe);
    const engine::Probe* const first = firstOf(revisit.probe);
    if (!part || !first || !first->allOver) return;
    const ProbeEffects before = effectsAt(part, *first), now = effectsAt(part, revisit.probe);
    const std::string when = whenOf(context_.tree, revisit);
    if (const ProbeEffects added = addedIn(before, now); !added.empty()) {
      if (part->heardOnly)
        std::erase_if(part->evidence, [](const Evidence& e) { return e.role == kHarmless; });
      part->heardOnly = false;
      roles_.setGuessed(!added.onlyStage());
      if (added.stage) part->stageSigns[NumberFrom::asked] = ++asked_;
      give(*part, revisit.probe, added);
      if (roles_.setsJoints(revisit.probe)) roles_.takeDrives(*part, revisit.probe, added);
      roles_.setGuessed(false);
      if (!added.onlyStage()) noteMore(*part, when, added);
    }
    if (const ProbeEffects ended = endedIn(before, now); !ended.empty())
      note("touch whose effect wears off", part->id,
           when + "; simulated as if it did not wear off; " + roles_.reason(ended.line()));
  }

  // Names listeners without a visible effect: scripts may count such touches towards a later
  // effect. Levers whose effect is known are left out.
  void noteHidden() {
    for (const engine::Probe& probe : report_.probes) {
      PartDraft* const part = partOf(probe);
      if (!part || part->checkpoint || part->goal) continue;
      if (probe.lost || probe.byPlace || probe.byFall || !effectsAt(part, probe).empty()) continue;
      const bool isKnown = std::any_of(
          report_.revisits.begin(), report_.revisits.end(), [&](const engine::Revisit& revisit) {
            return revisit.lever == probe.target || revisit.probe.target == probe.target;
          });
      if (!isKnown)
        note("input without a visible effect", part->id,
             "scripts may count its touches for a later effect");
    }
  }

 private:
  // Evidence of listeners without effects takes precedence over a tag.
  static void takeHeardOnly(PartDraft& part, bool guessed) {
    const auto isTag = [](const Evidence& e) {
      return e.role == "kill" && e.reason.rfind("tag ", 0) == 0;
    };
    if (part.kill && std::any_of(part.evidence.begin(), part.evidence.end(), isTag)) {
      part.kill.reset();
      std::erase_if(part.evidence, isTag);
    }
    if (part.kill || hasEvidence(part, kHarmless)) return;
    part.heardOnly = true;
    part.evidence.push_back(
        {kHarmless, "scripts handle its touch but do nothing to the player", guessed});
  }

  // Returns the part that a player touches; for a click or prompt the part that contains it.
  PartDraft* partOf(const engine::Probe& probe) {
    for (InstanceId id = probe.target; id < context_.tree.size(); id = context_.tree.at(id).parent)
      if (PartDraft* const part = context_.part(id)) return part;
    return nullptr;
  }
  // Returns the effects. A stored number with an uninformative name is a stage if the part states
  // the same number.
  ProbeEffects effectsAt(const PartDraft* part, const engine::Probe& probe) const {
    ProbeEffects effects = effectsOf(report_, probe);
    if (!part) return effects;
    PartDraft copy;
    copy.id = part->id;
    if (!effects.unnamed.empty()) readNumbers(context_.tree, copy.id, copy);
    const StageSigns& own = copy.stageSigns;
    takeOwnNumber(effects,
                  {own[NumberFrom::value], own[NumberFrom::name], own[NumberFrom::folder]});
    takeComeback(effects, report_, probe, *part);
    return effects;
  }
  const engine::Probe* firstOf(const engine::Probe& again) const {
    const auto first =
        std::find_if(report_.probes.begin(), report_.probes.end(),
                     [&](const engine::Probe& probe) { return probe.target == again.target; });
    return first == report_.probes.end() ? nullptr : &*first;
  }

  void give(PartDraft& part, const engine::Probe& probe, const ProbeEffects& effects) {
    const bool used = probe.approach == engine::Approach::use;
    if (!used)
      roles_.takePlayer(part, effects);
    else if (effects.touchesPlayer())
      note("interaction that affects the player", part.id,
           "not simulated; " + roles_.reason(effects.line()));
    roles_.takeParts(part, used, effects);
  }

  // Returns true if the second round found the effects at a part that had existed before.
  bool comesLater(const engine::Probe& probe, const ProbeEffects& effects) const {
    return probe.at > report_.probedAt && !effects.onlyStage() &&
           !isMadeLater(report_, probe.target);
  }
  void noteLater(PartDraft& part, const engine::Probe& probe, const ProbeEffects& effects) {
    if (comesLater(probe, effects)) noteMore(part, "some time after the start", effects);
  }
  void noteMore(PartDraft& part, const std::string& when, const ProbeEffects& more) {
    note("touch with a later effect", part.id,
         when + "; simulated as present from the start; " + roles_.reason(more.line()));
  }
  // Notes a script error that leaves the effects of a touch unknown. After an unsupported feature,
  // or without any effect, the script may go on in the game.
  void noteFailure(const PartDraft& part, const engine::Probe& probe, bool isEmpty) {
    const auto& usual = report_.undisturbed.problems;
    for (const engine::Problem& problem : probe.seen.problems) {
      const bool always =
          std::any_of(usual.begin(), usual.end(), [&](const engine::Problem& known) {
            return known.script == problem.script && known.text == problem.text;
          });
      const bool tells = problem.failure == engine::Failure::refused ||
                         (problem.failure == engine::Failure::usual && !isEmpty);
      if (!always && !tells) return note("touch handler that fails", part.id, problem.text);
    }
  }

  void note(const char* kind, InstanceId id, const std::string& text) {
    context_.level.noteUnmodelled(kind, context_.tree, id, text);
  }

  RoleContext& context_;
  const engine::Report& report_;
  EffectRoles roles_;
  int asked_ = 0;  // number of checkpoints so far that require others first
};

}  // namespace

void touchesFromObservation(RoleContext& context, const engine::Report& report) {
  Touches touches(context, report);
  for (const engine::Probe& probe : report.probes) touches.take(probe);
  for (const engine::SameListeners& unprobed : report.sameListeners) touches.take(unprobed);
}

void touchedDrivesFromObservation(RoleContext& context, const engine::Report& report) {
  Touches touches(context, report);
  for (const engine::Probe& probe : report.probes) touches.takeDrives(probe);
}

void laterTouchesFromObservation(RoleContext& context, const engine::Report& report) {
  Touches touches(context, report);
  for (const engine::Revisit& revisit : report.revisits) touches.take(revisit);
  touches.noteHidden();
}

}  // namespace obby::importer
