// Many trajectories in one buffer and one draw call. An index list selects those to draw, so that
// filters leave the points unchanged.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  LineBasicMaterial,
  LineSegments,
} from 'three';

/** @import {Path} from '../path.js' */
/** @import {Along, Tint} from '../types/report.js' */

const kMaxPoints = 120000; // max per picture; a browser without a GPU draws 400 segments a ms
export const kLift = 0.35; // studs above the feet, so that lines do not sink into the floor

/**
 * Returns the stride of samples for all thin lines of a picture: 1 for every sample, or k for
 * every k-th.
 * @param {Path[]} paths
 * @param {number[]} indices
 */
export function skipOf(paths, indices) {
  const total = indices.reduce((sum, i) => sum + paths[i].samples, 0);
  return Math.max(1, Math.ceil(total / kMaxPoints));
}

export class ThinLines {
  /**
   * `indices`: indices of the query's paths; `skip`: stride of samples, from skipOf.
   * @param {Path[]} paths
   * @param {number[]} indices
   * @param {number} skip
   */
  constructor(paths, indices, skip) {
    this.paths = paths;
    this.indices = indices;
    this.skip = skip;
    const counts = indices.map((i) => this.samplesOf(paths[i]));

    /** @type {[first: number, vertices: number][]} */
    this.spans = [];
    let first = 0;
    for (const count of counts) {
      this.spans.push([first, count]);
      first += count;
    }
    const vertices = first; // number of vertices of all lines
    this.colors = new BufferAttribute(new Float32Array(3 * vertices), 3);
    this.drawn = new BufferAttribute(new Uint32Array(2 * vertices), 1);
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute('position', new BufferAttribute(this.points(vertices), 3));
    this.geometry.setAttribute('color', this.colors);
    this.geometry.setIndex(this.drawn.setUsage(DynamicDrawUsage));
    this.lines = new LineSegments(
      this.geometry,
      new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false }),
    );
    this.lines.renderOrder = 5;
    this.lines.frustumCulled = false;
  }

  /** @param {Path} path */
  samplesOf(path) {
    return Math.ceil((path.samples - 1) / this.skip) + 1;
  }

  /** @param {number} vertices */
  points(vertices) {
    const position = new Float32Array(3 * vertices);
    this.spans.forEach(([first, samples], k) => {
      const path = this.paths[this.indices[k]];
      for (let i = 0; i < samples; i++) {
        const at = 3 * (first + i);
        const from = 3 * Math.min(i * this.skip, path.samples - 1);
        position[at] = path.points[from];
        position[at + 1] = path.points[from + 1] + kLift;
        position[at + 2] = path.points[from + 2];
      }
    });
    return position;
  }

  /**
   * @param {Tint} colorOf
   * @param {Along} [along] the colour at a sample, if it changes along a trajectory
   */
  setColors(colorOf, along) {
    const { array } = this.colors;
    const tint = new Color();
    this.spans.forEach(([first, samples], k) => {
      const path = this.paths[this.indices[k]];
      tint.set(colorOf(path));
      for (let i = 0; i < samples; i++) {
        if (along) tint.set(along(path, Math.min(i * this.skip, path.samples - 1)));
        tint.toArray(array, 3 * (first + i));
      }
    });
    this.colors.needsUpdate = true;
  }

  /**
   * `shown`: set of indices of the query's paths.
   * @param {Set<number>} shown
   */
  setShown(shown) {
    const { array } = this.drawn;
    let at = 0;
    let count = 0;
    this.spans.forEach(([first, samples], k) => {
      if (!shown.has(this.indices[k])) return;
      count += 1;
      for (let i = first; i + 1 < first + samples; i++) {
        array[at++] = i;
        array[at++] = i + 1;
      }
    });
    this.drawn.needsUpdate = true;
    this.geometry.setDrawRange(0, at);
    // Many lines form a translucent cloud; a few lines are more opaque, to stay readable.
    this.lines.material.opacity = Math.min(0.6, Math.max(0.16, 6 / Math.sqrt(count * 4 + 1)));
  }

  dispose() {
    this.geometry.dispose();
    this.lines.material.dispose();
  }
}
