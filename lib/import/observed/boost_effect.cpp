#include "import/observed/boost_effect.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace obby::importer {
namespace {

using engine::Change;
using engine::kFrame;
using engine::PlayerState;

bool differs(double factor) { return std::abs(factor - 1) > 1e-6; }

// The player's speeds and gravity as ratios of the former values, updated with each change.
class Speeds {
 public:
  Speeds(const engine::Report& report, const engine::Probe& probe)
      : before_(report.undisturbed.player),
        gravity_(report.arrived.gravity),
        lift_(report.arrived.lift),
        world_(gravity_),
        base_(gravity_ - lift_),
        usesHeight_(!probe.seen.player.usesJumpPower) {}

  // Applies a change. Returns true if the property has its former value.
  bool apply(const std::string& property, double value) {
    const bool byForce = property == "note lift";
    if (byForce || property == "Gravity") {
      (byForce ? lift_ : gravity_) = value;
      return !differs(gravity());
    }
    factors_[property] = ratioTo(property, value);
    return !differs(factors_[property]);
  }

  double walk() const { return factorOf("WalkSpeed"); }
  // Returns the ratio of jump speeds, from JumpPower or JumpHeight. A jump height holds under any
  // gravity of the world, so gravity changes the speed. Forces on the player do not.
  double jump() const {
    if (!usesHeight_) return factorOf("JumpPower");
    const double world = world_ > 0 && gravity_ > 0 ? gravity_ / world_ : 1;
    return std::sqrt(factorOf("JumpHeight") * world);
  }
  double gravity() const {
    const double now = gravity_ - lift_;
    return base_ > 0 ? now / base_ : now == base_ ? 1 : -1;
  }

 private:
  double factorOf(const char* property) const {
    const auto found = factors_.find(property);
    return found == factors_.end() ? 1 : found->second;
  }
  double ratioTo(const std::string& property, double value) const {
    const double before = property == "WalkSpeed"   ? before_.walkSpeed
                          : property == "JumpPower" ? before_.jumpPower
                                                    : before_.jumpHeight;
    return before > 0 ? value / before : 1;
  }

  const PlayerState& before_;
  double gravity_, lift_;
  const double world_, base_;
  const bool usesHeight_;
  std::map<std::string, double> factors_;
};

}  // namespace

bool changesSpeed(const Change& change) {
  const std::string& property = change.property;
  if (change.target != engine::kPlayer) return property == "Gravity" || property == "note lift";
  return property == "WalkSpeed" || property == "JumpPower" || property == "JumpHeight";
}

std::optional<Booster> boosterOf(const engine::Report& report, const engine::Probe& probe,
                                 const std::vector<const Change*>& changes) {
  Speeds speeds(report, probe);
  Booster boost;
  double last = 0;
  bool seen = false, changed = false, restored = false;
  for (const Change* change : changes) {
    const double* const value = std::get_if<double>(&change->value);
    if (!value) continue;
    if (!seen) boost.line = change->line;
    seen = true;
    last = change->time;
    restored |= speeds.apply(change->property, *value);
    if (differs(speeds.walk())) boost.walk = float(speeds.walk());
    if (differs(speeds.jump())) boost.jump = float(speeds.jump());
    if (differs(speeds.gravity())) boost.gravity = float(speeds.gravity());
    changed |= differs(speeds.walk()) || differs(speeds.jump()) || differs(speeds.gravity());
  }
  if (!changed && !restored) return std::nullopt;
  boost.resets = !changed;  // it undoes other boosts
  boost.forever =
      boost.resets || differs(speeds.walk()) || differs(speeds.jump()) || differs(speeds.gravity());
  if (boost.forever) return boost;
  // The time counts from the last touch. A boost that ends when the player leaves has no duration.
  const bool ends = std::abs(last - probe.left) < 3 * kFrame;
  boost.seconds = ends ? 0 : std::max(kFrame, last - changes.front()->time);
  return boost;
}

}  // namespace obby::importer
