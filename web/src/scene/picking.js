// Picks what is under the pointer: trajectories by screen distance, since lines are thin, then
// parts.
import { Matrix4, Plane, Raycaster, Vector2, Vector3 } from 'three';
import { partsOf } from './level_view.js';
import { kLift } from './thin_lines.js';

/** @import {Group, PerspectiveCamera} from 'three' */
/** @import {Path} from '../path.js' */

/**
 * The picture's camera and size in pixels.
 * @typedef {{camera: PerspectiveCamera, width: number, height: number}} Screen
 */
/** @typedef {[x: number, y: number]} At pixels */

const kReach = 9; // pixels
const kMaxPoints = 150000; // max points per pick; beyond it only every k-th sample is tested

/**
 * @param {number} px
 * @param {number} py
 * @param {number} ax
 * @param {number} ay
 * @param {number} bx
 * @param {number} by
 */
function distanceToSegment(px, py, ax, ay, bx, by) {
  const dx = bx - ax;
  const dy = by - ay;
  const lengthSquared = dx * dx + dy * dy;
  const t =
    lengthSquared > 0
      ? Math.min(1, Math.max(0, ((px - ax) * dx + (py - ay) * dy) / lengthSquared))
      : 0;
  return Math.hypot(px - ax - t * dx, py - ay - t * dy);
}

/**
 * Returns the nearest approach of a path to a screen point.
 * @param {Path} path
 * @param {Matrix4} matrix
 * @param {Screen} screen
 * @param {At} at
 * @param {number} skip
 */
function approach(path, matrix, { width, height }, [x, y], skip) {
  const m = matrix.elements;
  let best = Infinity;
  let tick = 0;
  let lastX = 0;
  let lastY = 0;
  let valid = false;
  for (let i = 0; i < path.samples; i += skip) {
    const [px, py, pz] = [
      path.points[3 * i],
      path.points[3 * i + 1] + kLift,
      path.points[3 * i + 2],
    ];
    const w = m[3] * px + m[7] * py + m[11] * pz + m[15];
    if (w <= 0.01) {
      valid = false;
      continue;
    }
    const sx = (((m[0] * px + m[4] * py + m[8] * pz + m[12]) / w) * 0.5 + 0.5) * width;
    const sy = (0.5 - ((m[1] * px + m[5] * py + m[9] * pz + m[13]) / w) * 0.5) * height;
    const d = valid ? distanceToSegment(x, y, lastX, lastY, sx, sy) : Math.hypot(x - sx, y - sy);
    if (d < best) {
      best = d;
      tick = path.tickOf(i);
    }
    [lastX, lastY, valid] = [sx, sy, true];
  }
  return { distance: best, tick };
}

/**
 * Returns {path: index, tick} or null. Solutions win over attempts at equal distance.
 * @param {Path[]} paths
 * @param {Screen} screen
 * @param {At} at
 * @param {(path: Path, index: number) => boolean} visible
 * @returns {{path: number, tick: number} | null}
 */
export function pickPath(paths, screen, at, visible) {
  const { camera } = screen;
  const matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const total = paths.reduce((sum, path) => sum + path.samples, 0);
  const skip = Math.max(1, Math.ceil(total / kMaxPoints));
  /** @type {{path: number, tick: number, distance: number} | null} */
  let best = null;
  for (const [index, path] of paths.entries()) {
    if (!visible(path, index)) continue;
    const found = approach(path, matrix, screen, at, skip);
    const distance = found.distance - (path.kind === 'solution' ? 4 : 0);
    if (found.distance <= kReach && (!best || distance < best.distance))
      best = { path: index, tick: found.tick, distance };
  }
  return best;
}

/**
 * @param {Screen} screen
 * @param {At} at
 */
function rayThrough({ camera, width, height }, [x, y]) {
  const ray = new Raycaster();
  ray.setFromCamera(new Vector2((x / width) * 2 - 1, 1 - (y / height) * 2), camera);
  return ray;
}

/**
 * Returns the point where the ray through a screen point meets the height `y`, or null.
 * @param {Screen} screen
 * @param {At} at
 * @param {number} y
 */
export function pointAtHeight(screen, at, y) {
  const { ray } = rayThrough(screen, at);
  return ray.intersectPlane(new Plane(new Vector3(0, 1, 0), -y), new Vector3());
}

/**
 * Returns the point where the ray meets a part, or else the height `y`.
 * @param {Group} group
 * @param {Screen} screen
 * @param {At} at
 * @param {number} y
 */
export function pointOnParts(group, screen, at, y) {
  const hit = rayThrough(screen, at).intersectObject(group, true)[0];
  return hit ? hit.point : pointAtHeight(screen, at, y);
}

/**
 * @param {Group} group
 * @param {Screen} screen
 * @param {At} at
 * @returns {number}
 */
export function pickPart(group, screen, at) {
  const hit = rayThrough(screen, at).intersectObject(group, true)[0];
  return hit ? partsOf(hit.object)[hit.instanceId ?? 0] : -1;
}
