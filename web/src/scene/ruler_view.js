// The ruler in the picture: the straight line between two points, and its horizontal and vertical
// parts, visible through parts.
import {
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
} from 'three';

/** @import {Triple} from '../types/page_data.js' */

export const RULER_COLOR = '#ffffff';
const kLegs = '#7fd4ff';
const kCross = 0.4; // half the size of the mark at an end, studs

/**
 * Returns the line segments of a mark.
 * @param {Triple} at
 */
function cross([x, y, z]) {
  const k = kCross;
  return [x - k, y, z, x + k, y, z, x, y - k, z, x, y + k, z, x, y, z - k, x, y, z + k];
}

export class RulerView {
  constructor() {
    this.group = new Group();
    // The materials stay alive: the renderer drops a GPU program with its last material.
    const options = { depthTest: false, transparent: true };
    this.straight = new LineBasicMaterial({ color: RULER_COLOR, ...options });
    this.legs = new LineBasicMaterial({ color: kLegs, ...options });
  }

  /** @param {readonly Triple[]} points */
  set([a, b]) {
    for (const line of [...this.group.children]) {
      if (line instanceof LineSegments) line.geometry.dispose();
      this.group.remove(line);
    }
    if (!a) return;
    this.add([...cross(a), ...(b ? [...a, ...b, ...cross(b)] : [])], this.straight);
    if (b) this.add([...a, b[0], a[1], b[2], b[0], a[1], b[2], ...b], this.legs);
  }

  /**
   * @param {number[]} points
   * @param {LineBasicMaterial} material
   */
  add(points, material) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
    const line = new LineSegments(geometry, material);
    line.renderOrder = 21;
    line.frustumCulled = false;
    this.group.add(line);
  }
}
