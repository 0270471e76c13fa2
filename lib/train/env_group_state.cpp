// Saves and restores an env group. Refuses states that no env group of these levels can have, as
// their indices would be out of range.
#include <fmt/format.h>

#include <cmath>

#include "train/env_group.h"

namespace obby::train {

namespace {

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool isSound(const sim::World& w, const level::LevelView& level, const level::QueryView& query) {
  if (!finite(w.position) || !finite(w.velocity) || !std::isfinite(w.health)) return false;
  if (!std::isfinite(w.damage) || w.state > sim::State::fallingDown) return false;
  if (w.outcome != sim::Outcome::running || w.clockCount > sim::kMaxClocks) return false;
  for (uint8_t i = 0; i < w.clockCount; ++i) {
    if (w.clocks[i].clock >= level.clockCount) return false;
  }
  return w.waypoints <= query.waypointCount;
}

bool isSound(const sim::RigidBody& b) {
  return finite(b.position) && finite(b.velocity) && finite(b.spin) &&
         std::isfinite(b.rotation.x) && std::isfinite(b.rotation.y) &&
         std::isfinite(b.rotation.z) && std::isfinite(b.rotation.w) &&
         b.state <= sim::RigidBodyState::gone;
}

}  // namespace

Status checkPlace(const PlaceState& s, const TrainingLevel& level,
                  const EnvGroupSettings& settings) {
  if (s.waits() && s.bodies.empty() && s.reached.empty()) return {};
  if (s.levelHash != level.hash())
    return makeError("a level differs from the one that the checkpoint was trained on",
                     "give the same levels as in the earlier run");
  const auto& scene = level.scene();
  bool sound = s.players.size() == settings.worlds && s.reached.size() <= kMaxReached &&
               s.bodies.size() == s.players.size() * level.startBodies().size();
  for (const Player& p : s.players)
    sound = sound && isSound(p.world, scene.level, scene.query) && std::isfinite(p.minLeft);
  for (const Reached& r : s.reached)
    sound = sound && isSound(r.world, scene.level, scene.query) && std::isfinite(r.minLeft);
  for (const sim::RigidBody& b : s.bodies) sound = sound && isSound(b);
  return sound ? Status()
               : makeError("the checkpoint is damaged: its worlds do not match its levels");
}

EnvGroupState EnvGroup::state() const {
  EnvGroupState out;
  for (const Place& place : places_) {
    PlaceState& state = out.places.emplace_back(place);
    state.levelHash = place.level ? place.level->hash() : 0;
    state.reached.resize(place.counts.reached);
  }
  return out;
}

Status EnvGroup::restore(EnvGroupState state) {
  if (state.places.size() != places_.size())
    return makeError(fmt::format("an env group of the checkpoint has {} levels, expected {}",
                                 state.places.size(), places_.size()));
  for (uint32_t p = 0; p < places_.size(); ++p) {
    static_cast<PlaceState&>(places_[p]) = std::move(state.places[p]);
    if (places_[p].taken == 0) return makeError("an env of the checkpoint has no level");
    OBBY_RETURN_IF_ERROR(findLevel(p));
    OBBY_RETURN_IF_ERROR(needLevel(p));
    OBBY_RETURN_IF_ERROR(checkPlace(places_[p], *places_[p].level, settings_));
    if (places_[p].waits()) {
      beginPlace(places_[p]);
      continue;
    }
    places_[p].counts.reached = uint32_t(places_[p].reached.size());
    places_[p].reached.resize(kMaxReached);
  }
  return {};
}

}  // namespace obby::train
