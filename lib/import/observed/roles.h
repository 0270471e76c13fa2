// Roles by observation: what parts were seen to do while the place's scripts ran.
#pragma once

#include <optional>
#include <vector>

#include "import/observed/place.h"
#include "import/roles/role.h"

namespace obby::importer {

// A loss: a part that is not there at the start.
constexpr const char* kComesLater = "part that comes later";

// What scripts changed of parts before play began.
void noteSettled(RoleContext& context, const ObservedPlace& place);
// The player once scripts change its speeds no more; where they go on, as at the first probes.
const engine::PlayerState& settledPlayer(const engine::Report& report);
// Speeds that scripts give each new player.
void applyPlayerState(RoleContext& context, const ObservedPlace& place);
// Motions of what moves by itself.
void movingFromObservation(RoleContext& context, const engine::Report& report);
// Parts that come and go, belts that change: what happens by itself in a rhythm.
void timersFromObservation(RoleContext& context, const engine::Report& report);
// Parts that are not there until a touch or use brings them.
void broughtFromObservation(RoleContext& context, const ObservedPlace& place);
// What a touch or use does, to the player and to other parts.
void touchesFromObservation(RoleContext& context, const engine::Report& report);
// What it does once other parts have been touched: guesses, after those by names.
void laterTouchesFromObservation(RoleContext& context, const engine::Report& report);
// What a touch or use does to constraints and movers, once it is known what they do by themselves.
void touchedDrivesFromObservation(RoleContext& context, const engine::Report& report);
// What scripts do about the player's own moves.
void movesFromObservation(RoleContext& context, const engine::Report& report);
// Names the events and values that scripts wait for and that nothing raised or varied.
void noteUnraised(RoleContext& context, const engine::Report& report);
// Names what was seen and is not in the level, and scripts that failed.
void noteObservedLosses(RoleContext& context, const ObservedPlace& place);

// The line that moves a part: that of its track, or of what sets the tween, constraint or mover
// that moves it.
engine::Line moverOf(const engine::Observation& seen, InstanceId part, const engine::Track& track);
// A part's poses at `frames` frames from `first` on; it is at `start` until its track begins.
std::vector<Pose> posesOf(const Pose& start, const engine::Track& track, uint32_t first,
                          uint32_t frames);
// The motion of a part that is at these poses, a frame each; nothing: it moves, but neither in a
// round nor to an end. `rest`: frames without a change after which it has come to its end.
std::optional<Motion> motionOf(const std::vector<Pose>& poses, size_t rest);

}  // namespace obby::importer
