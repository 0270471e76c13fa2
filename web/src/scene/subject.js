// The points that a view of a query or of a level must contain.
import { Box3, Quaternion, Vector3 } from 'three';

/** @import {Path} from '../path.js' */
/** @import {Region} from '../types/page_data.js' */
/** @import {Level, Query} from '../types/report.js' */
/** @import {Subject} from './view_choice.js' */

const kMaxHalf = 24; // studs; a goal as large as a floor is framed in part
const kMaxRegions = 24;
const kMaxPaths = 12;
const kSamples = 48; // tested samples of the first trajectory
const kWaist = 2; // studs above the feet
const kHead = 5.5;
const kAround = 4; // studs around the start
const kNear = 12; // studs of the floor around the start
const kGround = 4; // a ground is this much longer than all else
const kMinGround = 500; // studs
const kEnds = 6; // weight of start and goal in samples

/**
 * Adds the corners of an oriented box.
 * @param {number[]} out
 * @param {Vector3} position
 * @param {Quaternion} rotation
 * @param {Vector3} half
 */
function addCorners(out, position, rotation, half) {
  const corner = new Vector3();
  for (let i = 0; i < 8; i++) {
    corner.set(i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z);
    out.push(...corner.applyQuaternion(rotation).add(position));
  }
}

/**
 * @param {number[]} out
 * @param {Region} region
 */
function addRegion(out, { position, rotation, size }) {
  const max = new Vector3(kMaxHalf, kMaxHalf, kMaxHalf);
  const half = new Vector3(...size).multiplyScalar(0.5).min(max);
  addCorners(out, new Vector3(...position), new Quaternion(...rotation).normalize(), half);
}

/**
 * Returns the corners of a part.
 * @param {Level} level
 * @param {number} part
 */
function partCorners(level, part) {
  /** @type {number[]} */
  const out = [];
  const half = new Vector3().fromArray(level.size, 3 * part).multiplyScalar(0.5);
  const rotation = new Quaternion().fromArray(level.rotation, 4 * part).normalize();
  addCorners(out, new Vector3().fromArray(level.position, 3 * part), rotation, half);
  return out;
}

/**
 * Returns the corners of all parts but a ground that is much larger than everything else.
 * @param {Level} level
 */
export function cornersOf(level) {
  const parts = Array.from({ length: level.count }, (_, part) => {
    const corners = partCorners(level, part);
    const box = new Box3().setFromArray(corners);
    return { corners, box, length: box.getSize(new Vector3()).length() };
  }).sort((a, b) => a.length - b.length);
  const rest = new Box3(); // of all smaller parts
  let count = 0;
  for (const { box, length } of parts) {
    const size = rest.getSize(new Vector3()).length();
    if (count > 0 && length > Math.max(kMinGround, kGround * size)) break;
    rest.union(box);
    count += 1;
  }
  return parts.slice(0, count).flatMap(({ corners }) => corners);
}

/**
 * Adds the part that the player stands on, as far as it is near.
 * @param {number[]} out
 * @param {Level} level
 * @param {Vector3} feet
 */
function addFloor(out, level, feet) {
  const floor = new Box3();
  const low = feet.clone().subScalar(kNear);
  const high = feet.clone().addScalar(kNear);
  const box = new Box3();
  for (let part = 0; part < level.count; part++) {
    box.setFromArray(partCorners(level, part));
    const { min, max } = box;
    const isBelow = max.y <= feet.y + 1 && max.y >= low.y && max.y > floor.max.y;
    if (isBelow && min.x <= feet.x && max.x >= feet.x && min.z <= feet.z && max.z >= feet.z)
      floor.copy(box);
  }
  if (floor.isEmpty()) return;
  const { min, max } = floor.intersect(new Box3(low, high));
  for (const x of [min.x, max.x]) for (const z of [min.z, max.z]) out.push(x, max.y, z);
}

/**
 * Returns the trajectories to frame: the solutions, or else the selected one, or the closest.
 * @param {Query} query
 */
function pathsOf({ paths }) {
  const solutions = paths.filter(({ kind }) => kind === 'solution').slice(0, kMaxPaths);
  if (solutions.length) return solutions;
  return paths.filter(({ kind }) => kind === 'closest').slice(0, 1);
}

/**
 * @param {number[]} out
 * @param {Path} path
 */
function addPath(out, { points, samples }) {
  const step = Math.max(1, Math.floor(samples / 200));
  for (let i = 0; i < samples; i += step) {
    const [x, y, z] = points.subarray(3 * i, 3 * i + 3);
    out.push(x, y, z, x, y + kHead, z);
  }
}

/**
 * @param {Query} query
 * @param {Level | undefined} level
 * @returns {Subject}
 */
export function subjectOf(query, level) {
  /** @type {number[]} */
  const frame = [];
  const { start, startPosition, goal, goals, visits, waypoints, result } = query;
  const ends = [...(goal ? [goal] : []), ...goals].slice(0, kMaxRegions);
  const between = [...waypoints.map(({ region }) => region), ...visits].slice(0, kMaxRegions);
  for (const region of [...(start ? [start] : []), ...ends, ...between]) addRegion(frame, region);
  const at = startPosition ?? start?.position;
  const from = at ? new Vector3(...at).add(new Vector3(0, kWaist, 0)) : null;
  if (from) {
    const around = new Vector3(kAround, kHead / 2, kAround);
    const middle = from.clone().add(new Vector3(0, kHead / 2 - kWaist, 0));
    addCorners(frame, middle, new Quaternion(), around);
    if (level) addFloor(frame, level, from.clone().sub(new Vector3(0, kWaist, 0)));
  }
  const to = ends.length ? new Vector3(...ends[0].position) : null;
  const paths = pathsOf(query);
  for (const path of paths) addPath(frame, path);
  const { from: before = -1, to: after = -1 } = result?.cut ?? {};
  for (const part of [before, after])
    if (level && part >= 0 && part < level.count)
      frame.push(...level.position.subarray(3 * part, 3 * part + 3));
  return { frame, seen: seenOf(paths[0], from, to), from, to };
}

/**
 * Returns the points that must be visible. Start and goal count several times.
 * @param {Path | undefined} path
 * @param {Vector3 | null} from
 * @param {Vector3 | null} to
 */
function seenOf(path, from, to) {
  const out = [];
  for (let i = 0; i < kEnds; i++) out.push(...[from, to].filter((end) => end !== null));
  if (!path) return out;
  const step = Math.max(1, Math.floor(path.samples / kSamples));
  for (let i = 0; i < path.samples; i += step) {
    const point = new Vector3().fromArray(path.points, 3 * i);
    out.push(point.add(new Vector3(0, kWaist, 0)));
  }
  return out;
}
