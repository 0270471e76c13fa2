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

const kMostPoints = 120000; // per picture; a browser without a GPU draws about 400 segments a ms
export const kLift = 0.35; // studs above the feet, so that lines do not sink into the floor

// Returns the stride of samples for all thin lines of a picture: 1, or k for every k-th.
export function skipOf(paths, indices) {
  const total = indices.reduce((sum, i) => sum + paths[i].samples, 0);
  return Math.max(1, Math.ceil(total / kMostPoints));
}

export class ThinLines {
  // `indices`: into the query's paths; `skip`: from skipOf.
  constructor(paths, indices, skip) {
    Object.assign(this, { paths, indices, skip });
    this.spans = []; // [first vertex, number of vertices] of each
    this.build();
    this.lines = new LineSegments(
      this.geometry,
      new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false }),
    );
    this.lines.renderOrder = 5;
    this.lines.frustumCulled = false;
  }

  samplesOf(path) {
    return Math.ceil((path.samples - 1) / this.skip) + 1;
  }

  build() {
    const vertices = this.indices.reduce((sum, i) => sum + this.samplesOf(this.paths[i]), 0);
    const position = new Float32Array(3 * vertices);
    let at = 0;
    for (const index of this.indices) {
      const path = this.paths[index];
      const samples = this.samplesOf(path);
      this.spans.push([at, samples]);
      for (let i = 0; i < samples; i++, at++) {
        const from = 3 * Math.min(i * this.skip, path.samples - 1);
        position[3 * at] = path.points[from];
        position[3 * at + 1] = path.points[from + 1] + kLift;
        position[3 * at + 2] = path.points[from + 2];
      }
    }
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute('position', new BufferAttribute(position, 3));
    this.geometry.setAttribute('color', new BufferAttribute(new Float32Array(3 * vertices), 3));
    const index = new BufferAttribute(new Uint32Array(2 * vertices), 1);
    this.geometry.setIndex(index.setUsage(DynamicDrawUsage));
  }

  setColors(colorOf) {
    const { array } = this.geometry.attributes.color;
    const tint = new Color();
    this.spans.forEach(([first, samples], k) => {
      tint.set(colorOf(this.paths[this.indices[k]]));
      for (let i = first; i < first + samples; i++) tint.toArray(array, 3 * i);
    });
    this.geometry.attributes.color.needsUpdate = true;
  }

  // `shown`: set of indices of the query's paths.
  setShown(shown) {
    const { array } = this.geometry.index;
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
    this.geometry.index.needsUpdate = true;
    this.geometry.setDrawRange(0, at);
    // Many lines form a translucent cloud, and few stay readable.
    this.lines.material.opacity = Math.min(0.6, Math.max(0.16, 6 / Math.sqrt(count * 4 + 1)));
  }

  dispose() {
    this.geometry.dispose();
    this.lines.material.dispose();
  }
}
