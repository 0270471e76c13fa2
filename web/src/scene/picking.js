// Picks what is under the pointer: trajectories by screen distance, since lines are thin, then
// parts.
import { Matrix4, Plane, Raycaster, Vector2, Vector3 } from 'three';
import { kLift } from './thin_lines.js';

const kReach = 9; // pixels
const kMostPoints = 150000; // tested per pick; beyond it only every k-th sample

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

// Returns the nearest approach of a path to a screen point.
function approach(path, matrix, width, height, x, y, skip) {
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

// Returns {path: index, tick} or null. Solutions win over attempts at equal distance.
export function pickPath(paths, camera, width, height, x, y, visible) {
  const matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const total = paths.reduce((sum, path) => sum + path.samples, 0);
  const skip = Math.max(1, Math.ceil(total / kMostPoints));
  let best = null;
  paths.forEach((path, index) => {
    if (!visible(path, index)) return;
    const found = approach(path, matrix, width, height, x, y, skip);
    const distance = found.distance - (path.kind === 'solution' ? 4 : 0);
    if (found.distance <= kReach && (!best || distance < best.distance))
      best = { path: index, tick: found.tick, distance };
  });
  return best;
}

function rayThrough(camera, width, height, x, y) {
  const ray = new Raycaster();
  ray.setFromCamera(new Vector2((x / width) * 2 - 1, 1 - (y / height) * 2), camera);
  return ray;
}

// Returns the point where the ray through a screen point meets the height `y`, or null.
export function pointAtHeight(camera, width, height, at, y) {
  const { ray } = rayThrough(camera, width, height, ...at);
  return ray.intersectPlane(new Plane(new Vector3(0, 1, 0), -y), new Vector3());
}

// Returns the point where the ray meets a part, or else that height.
export function pointOnParts(group, camera, width, height, at, y) {
  const hit = rayThrough(camera, width, height, ...at).intersectObject(group, true)[0];
  return hit ? hit.point : pointAtHeight(camera, width, height, at, y);
}

export function pickPart(group, camera, width, height, x, y) {
  const hit = rayThrough(camera, width, height, x, y).intersectObject(group, true)[0];
  return hit ? hit.object.userData.parts[hit.instanceId] : -1;
}
