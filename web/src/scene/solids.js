// The parts as solids that block lines of sight. Each solid is a simple shape in its own unit
// space, where its box reaches from -1 to 1 on each axis.
import { Matrix4, Quaternion, Vector3 } from 'three';
import { SHAPES } from '../data.js';
import { scaleOf } from './shapes.js';

/** @import {Shape} from '../types/page_data.js' */
/** @import {Level} from '../types/report.js' */

const kOpaque = 128; // min opacity of a part that hides anything, of 255

/**
 * Half spaces that bound a shape besides its box: a x + b y + c z <= 0.
 * @type {Partial<Record<Shape, [number, number, number][]>>}
 */
const kHalfSpaces = {
  wedge: [[0, 1, -1]],
  cornerWedge: [
    [-1, 1, 0],
    [0, 1, 1],
  ],
};

/**
 * Axes on which the shape is round.
 * @type {Partial<Record<Shape, [number, number, number]>>}
 */
const kRound = { ball: [1, 1, 1], cylinder: [0, 1, 1] };

/** @typedef {[number, number, number]} Point */

/**
 * Clips [lo, hi] of the line from + t * by to value + t * slope <= 0.
 * @param {[number, number]} range
 * @param {number} value
 * @param {number} slope
 */
function clip(range, value, slope) {
  if (Math.abs(slope) < 1e-12) {
    if (value > 0) range[1] = -1;
  } else if (slope > 0) range[1] = Math.min(range[1], -value / slope);
  else range[0] = Math.max(range[0], -value / slope);
}

/**
 * Clips the range to the inside of a round shape.
 * @param {[number, number]} range
 * @param {Point} from
 * @param {Point} by
 * @param {Point} axes
 */
function clipRound(range, from, by, axes) {
  let [a, b, c] = [0, 0, -1];
  for (let k = 0; k < 3; k++) {
    a += axes[k] * by[k] * by[k];
    b += axes[k] * from[k] * by[k];
    c += axes[k] * from[k] * from[k];
  }
  if (a < 1e-12) {
    if (c > 0) range[1] = -1;
    return;
  }
  const root = b * b - a * c;
  if (root <= 0) {
    range[1] = -1;
    return;
  }
  range[0] = Math.max(range[0], (-b - Math.sqrt(root)) / a);
  range[1] = Math.min(range[1], (-b + Math.sqrt(root)) / a);
}

/**
 * Returns the share of the segment before it enters the unit shape, or Infinity if it misses.
 * @param {Shape} shape
 * @param {Point} from
 * @param {Point} by
 */
export function entry(shape, from, by) {
  /** @type {[number, number]} */
  const range = [0, 1];
  for (let k = 0; k < 3 && range[0] <= range[1]; k++) {
    clip(range, from[k] - 1, by[k]);
    clip(range, -from[k] - 1, -by[k]);
  }
  for (const n of kHalfSpaces[shape] ?? [])
    clip(
      range,
      n[0] * from[0] + n[1] * from[1] + n[2] * from[2],
      n[0] * by[0] + n[1] * by[1] + n[2] * by[2],
    );
  const round = kRound[shape];
  if (round && range[0] <= range[1]) clipRound(range, from, by, round);
  return range[0] <= range[1] ? range[0] : Infinity;
}

/**
 * A solid: its part, its shape, and the box of a hull's piece in studs from the part's centre.
 * @typedef {{part: number, shape: Shape, middle: Vector3, half: Vector3}} Solid
 */

/**
 * @param {Level} level
 * @returns {Solid[]}
 */
function solidsOf(level) {
  const hulls = new Map(level.hulls.map(({ part, pieces }) => [part, pieces]));
  /** @type {Solid[]} */
  const out = [];
  for (let part = 0; part < level.count; part++) {
    if (level.look[4 * part + 3] < kOpaque) continue;
    const shape = SHAPES[level.shape[part]];
    const size = level.size.subarray(3 * part, 3 * part + 3);
    const pieces = hulls.get(part) ?? [];
    for (const piece of pieces) {
      const low = new Vector3(Infinity, Infinity, Infinity);
      const high = low.clone().negate();
      for (let i = 0; i + 2 < piece.length; i += 3) {
        const corner = new Vector3().fromArray(piece, i);
        low.min(corner);
        high.max(corner);
      }
      const half = high.clone().sub(low).multiplyScalar(0.5);
      out.push({ part, shape, middle: low.add(high).multiplyScalar(0.5), half });
    }
    if (pieces.length) continue;
    const extent = shape === 'hull' ? [...size] : scaleOf(shape, size);
    const half = new Vector3().fromArray(extent).multiplyScalar(0.5);
    out.push({ part, shape, middle: new Vector3(), half });
  }
  return out;
}

export class Solids {
  /** @param {Level} level */
  constructor(level) {
    this.all = solidsOf(level);
    this.centre = new Float64Array(3 * this.all.length);
    this.radius = new Float64Array(this.all.length);
    this.inverse = this.all.map(() => new Matrix4()); // world to unit space
    /** @type {Set<number>} */
    this.away = new Set(); // parts that are absent now
    /** @type {Map<number, number[]>} */
    this.ofPart = new Map();
    this.all.forEach(({ part }, i) => {
      this.ofPart.set(part, [...(this.ofPart.get(part) ?? []), i]);
    });
    const [position, rotation] = [new Vector3(), new Quaternion()];
    for (const part of this.ofPart.keys()) {
      rotation.fromArray(level.rotation, 4 * part).normalize();
      this.place(part, position.fromArray(level.position, 3 * part), rotation);
    }
  }

  /**
   * @param {number} part
   * @param {Vector3} position
   * @param {Quaternion} rotation
   */
  place(part, position, rotation) {
    for (const i of this.ofPart.get(part) ?? []) {
      const { middle, half } = this.all[i];
      const centre = middle.clone().applyQuaternion(rotation).add(position);
      centre.toArray(this.centre, 3 * i);
      this.radius[i] = half.length();
      const scale = half.clone().max(new Vector3(0.01, 0.01, 0.01));
      this.inverse[i].compose(centre, rotation, scale).invert();
    }
  }

  /**
   * @param {number} part
   * @param {boolean} away the part is absent
   */
  setAway(part, away) {
    if (away) this.away.add(part);
    else this.away.delete(part);
  }

  /**
   * Returns the share of the segment before the first solid, or 1.
   * @param {Vector3} from
   * @param {Vector3} to
   */
  firstHit(from, to) {
    const [bx, by, bz] = [to.x - from.x, to.y - from.y, to.z - from.z];
    const squared = bx * bx + by * by + bz * bz || 1;
    let best = 1;
    for (let i = 0; i < this.all.length; i++) {
      const x = this.centre[3 * i] - from.x;
      const y = this.centre[3 * i + 1] - from.y;
      const z = this.centre[3 * i + 2] - from.z;
      const t = Math.min(1, Math.max(0, (x * bx + y * by + z * bz) / squared));
      const apart = (x - t * bx) ** 2 + (y - t * by) ** 2 + (z - t * bz) ** 2;
      if (apart > this.radius[i] ** 2) continue;
      if (this.away.size && this.away.has(this.all[i].part)) continue;
      best = Math.min(best, this.hit(i, from, to));
    }
    return best;
  }

  /**
   * @param {number} i
   * @param {Vector3} from
   * @param {Vector3} to
   */
  hit(i, from, to) {
    const a = from.clone().applyMatrix4(this.inverse[i]);
    const b = to.clone().applyMatrix4(this.inverse[i]).sub(a);
    return entry(this.all[i].shape, [a.x, a.y, a.z], [b.x, b.y, b.z]);
  }
}
