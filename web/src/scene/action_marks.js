// Marks along the selected trajectory: a dot at each jump and a small ring at each landing.
import { Group, Points, PointsMaterial, BufferGeometry, Float32BufferAttribute } from 'three';
import { dispose } from './dispose.js';
import { glyphTexture } from './markers.js';
import { kLift } from './thin_lines.js';

/** @import {Path} from '../path.js' */
/** @import {Glyph} from './markers.js' */

const kAirborne = 1; // bit of a sample's state

/**
 * @param {Path} path
 * @param {number[]} ticks
 * @param {Glyph} glyph
 * @param {string} color
 * @param {number} size
 */
function marks(path, ticks, glyph, color, size) {
  const points = ticks.flatMap((tick) => {
    const { x, y, z } = path.poseAt(tick);
    return [x, y + kLift, z];
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
  const cloud = new Points(
    geometry,
    new PointsMaterial({
      map: glyphTexture(glyph, color),
      size: size * Math.min(devicePixelRatio, 2),
      sizeAttenuation: false,
      transparent: true,
      depthWrite: false,
    }),
  );
  cloud.frustumCulled = false;
  cloud.renderOrder = 12;
  return cloud;
}

/**
 * Returns the ticks of landings.
 * @param {Path} path
 */
export function landings(path) {
  const ticks = [];
  const { state } = path;
  for (let i = 1; i < path.samples; i++)
    if (state[i - 1] & kAirborne && !(state[i] & kAirborne)) ticks.push(path.tickOf(i));
  return ticks;
}

export class ActionMarks {
  constructor() {
    this.group = new Group();
  }

  /** @param {Path | undefined} path */
  set(path) {
    this.clear();
    if (!path) return;
    this.group.add(
      marks(path, landings(path), 'ring', '#c8d2e4', 8),
      marks(path, path.jumpTicks, 'dot', '#ffffff', 11),
    );
  }

  clear() {
    dispose(this.group);
    this.group.clear();
  }
}
