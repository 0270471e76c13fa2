// Fits a camera to points: the closest place along a direction from which all are in the free
// area of the picture.
import { Vector3 } from 'three';

const kNearest = 8; // min studs from the eye to the nearest point

/** @import {Direction} from './camera_rig.js' */

/**
 * The axes of a view.
 * @param {Direction} direction
 */
export function axesOf({ yaw, pitch }) {
  const forward = new Vector3(
    -Math.sin(yaw) * Math.cos(pitch),
    Math.sin(pitch),
    -Math.cos(yaw) * Math.cos(pitch),
  );
  const right = new Vector3(Math.cos(yaw), 0, -Math.sin(yaw));
  return { forward, right, up: right.clone().cross(forward) };
}

/**
 * A fitted camera: its eye, the depths in studs between which the points are, and the shares of
 * the free width and height that they fill.
 * @typedef {{eye: Vector3, near: number, far: number, fillX: number, fillY: number}} Fit
 */

/**
 * Each border of the picture bounds the eye by a linear inequality, so the fit is exact.
 * @param {ArrayLike<number>} points x, y, z each; at least one point
 * @param {Direction} direction
 * @param {{wide: number, tall: number}} slopes studs from the middle to the border of the free
 *   area, per stud of depth
 * @returns {Fit}
 */
export function fitted(points, direction, { wide, tall }) {
  const { forward, right, up } = axesOf(direction);
  const across = { low: Infinity, high: -Infinity }; // bounds of the eye on the right axis
  const along = { low: Infinity, high: -Infinity }; // ... on the up axis
  const depth = { low: Infinity, high: -Infinity };
  for (let i = 0; i + 2 < points.length; i += 3) {
    const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
    const a = x * right.x + y * right.y + z * right.z;
    const b = x * up.x + y * up.y + z * up.z;
    const c = x * forward.x + y * forward.y + z * forward.z;
    across.low = Math.min(across.low, a + wide * c);
    across.high = Math.max(across.high, a - wide * c);
    along.low = Math.min(along.low, b + tall * c);
    along.high = Math.max(along.high, b - tall * c);
    depth.low = Math.min(depth.low, c);
    depth.high = Math.max(depth.high, c);
  }
  const byWidth = (across.low - across.high) / (2 * wide);
  const byHeight = (along.low - along.high) / (2 * tall);
  const back = Math.min(byWidth, byHeight, depth.low - kNearest);
  const eye = right
    .clone()
    .multiplyScalar((across.low + across.high) / 2)
    .addScaledVector(up, (along.low + along.high) / 2)
    .addScaledVector(forward, back);
  const [near, far] = [depth.low - back, depth.high - back];
  const middle = (near + far) / 2;
  return {
    eye,
    near,
    far,
    fillX: Math.max(0, 1 - (byWidth - back) / middle),
    fillY: Math.max(0, 1 - (byHeight - back) / middle),
  };
}
