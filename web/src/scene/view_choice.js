// Chooses the side from which a query is shown first. Of several directions it takes the one that
// hides least of the start, the trajectory and the goal. lib/view/picture/view_choice.cpp does the
// same for pictures.
import { Vector3 } from 'three';
import { fitted } from './framing.js';

/** @import {Direction} from './camera_rig.js' */
/** @import {Solids} from './solids.js' */

const kAzimuths = 12;
const kPitches = [-0.55, -0.8, -1.1]; // radians
const kSteep = 0.08; // cost of each steeper pitch
const kFills = 0.3; // worth of a view that fills the picture
const kLevel = 0.28; // worth of a view whose points are all equally far away
const kReads = 0.06; // worth of a view with the start on the left
const kTolerance = 0.6; // studs before a point within which a part does not hide it
const kMaxTests = 4e6; // max pairs of a solid and a line

/**
 * The places of a query that a view must show.
 * @typedef {object} Subject
 * @property {ArrayLike<number>} frame points to frame: x, y, z each
 * @property {Vector3[]} seen points that must not be hidden
 * @property {Vector3 | null} from
 * @property {Vector3 | null} to
 */

/** @returns {Direction[]} in order of preference */
export function directions() {
  const out = [];
  for (const pitch of kPitches)
    for (let i = 0; i < kAzimuths; i++)
      out.push({ yaw: 0.55 + (2 * Math.PI * i) / kAzimuths, pitch });
  return out;
}

/**
 * Returns the share of the points that no solid hides.
 * @param {Vector3[]} points
 * @param {Vector3} eye
 * @param {Solids} solids
 */
export function visibleShare(points, eye, solids) {
  if (!points.length) return 1;
  let seen = 0;
  for (const point of points) {
    const distance = eye.distanceTo(point);
    if (solids.firstHit(eye, point) * distance >= distance - kTolerance) seen += 1;
  }
  return seen / points.length;
}

/**
 * Returns the direction of the best view.
 * @param {Subject} subject
 * @param {Solids} solids
 * @param {{wide: number, tall: number}} slopes
 * @returns {Direction}
 */
export function bestDirection({ frame, seen, from, to }, solids, slopes) {
  const all = directions();
  const max = Math.max(4, Math.floor(kMaxTests / (all.length * Math.max(1, solids.all.length))));
  const step = Math.max(1, Math.ceil(seen.length / max));
  const tested = seen.filter((_, i) => i % step === 0 || i === seen.length - 1);
  let best = all[0];
  let most = -Infinity;
  for (const direction of all) {
    const { eye, near, far, fillX, fillY } = fitted(frame, direction, slopes);
    const right = new Vector3(Math.cos(direction.yaw), 0, -Math.sin(direction.yaw));
    const reads = from && to && to.clone().sub(from).dot(right) > 0 ? kReads : 0;
    const worth =
      visibleShare(tested, eye, solids) +
      kFills * Math.sqrt(fillX * fillY) +
      kLevel * (near / far) +
      reads -
      kSteep * kPitches.indexOf(direction.pitch);
    if (worth <= most) continue;
    most = worth;
    best = direction;
  }
  return best;
}
