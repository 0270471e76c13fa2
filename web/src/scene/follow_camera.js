// The view of the camera that follows a player: the direction of travel, smoothed so that hops and
// turns on the spot do not shake it.

/** @import {Path} from '../path.js' */

const kWindow = 0.6; // seconds before and after the current moment
const kFarthest = 3; // max seconds, while the player hardly moves
const kMinMove = 3; // studs that define a direction

/**
 * Returns the yaw of the player's travel around a tick, in radians; the player's own yaw if it
 * hardly moves.
 * @param {Path} path
 * @param {number} tick
 * @param {number} rate ticks a second
 */
export function headingAt(path, tick, rate) {
  for (let span = kWindow; span <= kFarthest; span *= 1.5) {
    const [a, b] = [path.poseAt(tick - span * rate), path.poseAt(tick + span * rate)];
    const [dx, dz] = [b.x - a.x, b.z - a.z];
    if (Math.hypot(dx, dz) >= kMinMove) return Math.atan2(-dx, -dz);
  }
  return path.poseAt(tick).yaw;
}
