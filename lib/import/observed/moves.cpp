// Applies script effects of the player's own moves. Launches become the player's jump; other
// effects become losses.
#include <algorithm>
#include <cmath>
#include <optional>

#include "import/draft/world.h"
#include "import/observed/effects_of.h"
#include "import/observed/roles.h"

namespace obby::importer {
namespace {

using engine::Approach;
using engine::Probe;

constexpr double kAtOnce = 0.1;  // seconds from the take-off

const char* harmKind(Approach approach) {
  switch (approach) {
    case Approach::walk: return "harm by walking";
    case Approach::jump: return "harm by jumping";
    case Approach::fall: return "harm by falling";
    default: return "harm by climbing, swimming or sitting";
  }
}

class Moves {
 public:
  Moves(RoleContext& context, const engine::Report& report) : context_(context), report_(report) {}

  void take() {
    for (const Probe& move : report_.moves) {
      if (move.lost) continue;
      const ProbeEffects effects = effectsOf(report_, move);
      if (move.approach == Approach::away) {
        if (effects.touchesPlayer())
          note("script that acts on players without a touch", "not simulated; ", effects.line());
        continue;
      }
      takeHarm(move, effects);
      takeChanges(effects);
      if (move.approach == Approach::jump) takeLaunch(effects);
    }
    launch();
    for (const Probe& probe : report_.probes)
      if (probe.approach == Approach::keys) takeSinks(probe);
  }

 private:
  void note(const char* kind, const char* text, engine::Line line) {
    context_.level.noteUnmodelled(kind, context_.tree, kNoInstance,
                                  text + lineReason(context_.tree, line));
  }

  // Reads the harm that a move causes. A jump that kills at once is removed.
  void takeHarm(const Probe& move, const ProbeEffects& effects) {
    if (!effects.harm) return;
    const auto& harms = move.seen.harms;
    const auto first = std::find_if(harms.begin(), harms.end(),
                                    [](const engine::Harm& harm) { return harm.hurts(); });
    const bool sudden = !move.seen.player.alive && first->time - move.at < kAtOnce;
    if (move.approach == Approach::jump && sudden) {
      context_.level.world.jumpSpeed = 0;
      context_.level.noteIgnored("ability of the player", "",
                                 "jumping kills, so the simulated player cannot jump; " +
                                     lineReason(context_.tree, first->line));
      return;
    }
    note(harmKind(move.approach), "not simulated; ", effects.harm->line);
  }

  void takeChanges(const ProbeEffects& effects) {
    if (effects.boost)
      note("speed that scripts change", "depends on how the player moves; not simulated; ",
           effects.boost->line);
    if (effects.teleport || effects.force || effects.trips)
      note("push without a touch", "depends on how the player moves; not simulated; ",
           effects.line());
    if (!effects.aways.empty() || !effects.backs.empty() || !effects.moved.empty())
      note("part that the player's moves change", "not simulated; ", effects.line());
  }

  void takeLaunch(const ProbeEffects& effects) {
    ++jumps_;
    if (!effects.push) return;
    const Push& push = *effects.push;
    const float speed = push.launchSpeed(context_.level.world.gravity);
    if (!(speed > 0)) return;
    ++launches_;
    if (!speed_ || speed < *speed_) speed_ = speed;
    line_ = push.line;
    held_ |= push.seconds > 0;
  }

  // Takes a launch that comes with every jump as the player's jump.
  void launch() {
    if (launches_ == 0 || context_.level.world.jumpSpeed == 0) return;
    if (launches_ < jumps_)
      return note("ability of the player", "the simulated player never uses it; ", line_);
    context_.level.world.jumpSpeed = *speed_;
    context_.level.noteIgnored(
        "ability of the player", "",
        "a script launches the player at each jump; simulated as the jump; " +
            lineReason(context_.tree, line_));
    if (held_) note("push that lasts", "simulated as one push; ", line_);
  }

  // Notes controls that scripts take from the player by an action of their own.
  void takeSinks(const Probe& keys) {
    for (const engine::Change& change : keys.seen.changes) {
      const auto* const name = std::get_if<std::string>(&change.value);
      if (change.property != "note sinks" || !name) continue;
      const bool jump = *name == "CharacterJump" || *name == "Space";
      const bool walk = name->rfind("Character", 0) == 0 && !jump;
      if (walk || (jump && launches_ == 0 && report_.airJumps.count == 0))
        note("controls that scripts take away", "the simulated player keeps them; ", change.line);
    }
  }

  RoleContext& context_;
  const engine::Report& report_;
  int jumps_ = 0, launches_ = 0;
  std::optional<float> speed_;
  bool held_ = false;
  engine::Line line_;
};

}  // namespace

void movesFromObservation(RoleContext& context, const engine::Report& report) {
  Moves(context, report).take();
}

}  // namespace obby::importer
