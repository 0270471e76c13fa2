// Derives roles from observations of parts while the place's scripts ran.
#pragma once

#include <optional>
#include <vector>

#include "import/document/observed_place.h"
#include "import/draft/role_context.h"

namespace obby::importer {

// A loss: a part that is missing at the start.
constexpr const char* kComesLater = "part that appears later";

// Notes changes that scripts made to parts before play began.
void noteSettled(RoleContext& context, const ObservedPlace& place);
// Returns the player's state after scripts last changed its speeds. If changes go on, returns its
// state at the first probes.
const engine::PlayerState& settledPlayer(const engine::Report& report);
// Applies speeds that scripts give each new player.
void applyPlayerState(RoleContext& context, const ObservedPlace& place);
// Gives parts that move by themselves their motions.
void movingFromObservation(RoleContext& context, const engine::Report& report);
// Gives their timers to parts that appear or vanish by themselves. Notes conveyors whose velocity
// scripts change.
void timersFromObservation(RoleContext& context, const engine::Report& report);
// Marks parts that only a touch or use brings into the world.
void broughtFromObservation(RoleContext& context, const ObservedPlace& place);
// Gives parts the effects that a touch or use of them has on the player and on parts.
void touchesFromObservation(RoleContext& context, const engine::Report& report);
// Gives parts the effects that depend on earlier touches of other parts, as guesses. Roles guessed
// from names come first.
void laterTouchesFromObservation(RoleContext& context, const engine::Report& report);
// Gives parts the effects of a touch or use on constraints and movers. Call it after the motions of
// those are known.
void touchedDrivesFromObservation(RoleContext& context, const engine::Report& report);
// Applies the effects of the player's own moves to the level.
void movesFromObservation(RoleContext& context, const engine::Report& report);
// Notes events and values that scripts wait for and that did not occur or vary.
void noteUnraised(RoleContext& context, const engine::Report& report);
// Notes observations that the level lacks, and scripts that failed.
void noteObservedLosses(RoleContext& context, const ObservedPlace& place);

// Returns the line that moves a part: its track's, or that of its tween, constraint or mover.
engine::Line moverOf(const engine::Observation& seen, InstanceId part, const engine::Track& track);
// Returns the part's poses in `frames` frames from `first` on. The part is at `start` until its
// track begins.
std::vector<Pose> posesOf(const Pose& start, const engine::Track& track, uint32_t first,
                          uint32_t frames);
// Returns the motion of a part with these poses, one per frame. Returns nullopt if it moves neither
// in a round nor to an end. The motion has ended after `rest` frames without a change.
std::optional<Motion> motionOf(const std::vector<Pose>& poses, size_t rest);

}  // namespace obby::importer
