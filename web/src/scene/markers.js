// Marks the ends of attempts by a glyph per outcome, and the runners by a dot for each trajectory
// at the current tick.
import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  Color,
  DynamicDrawUsage,
  Float32BufferAttribute,
  Group,
  Points,
  PointsMaterial,
} from 'three';
import { OUTCOME_STYLE } from '../palette.js';
import { dispose } from './dispose.js';

/** @import {Query, Tint} from '../types/report.js' */

/** @typedef {'ring' | 'dot' | 'cross' | 'down' | 'up' | 'bar' | 'clock'} Glyph */

/** @type {Record<Glyph, (g: CanvasRenderingContext2D) => void>} */
const kDraw = {
  ring: (g) => {
    g.arc(32, 32, 17, 0, 7);
  },
  dot: (g) => {
    g.arc(32, 32, 7, 0, 7);
  },
  cross: (g) => {
    g.moveTo(18, 18);
    g.lineTo(46, 46);
    g.moveTo(46, 18);
    g.lineTo(18, 46);
  },
  down: (g) => {
    g.moveTo(16, 24);
    g.lineTo(32, 44);
    g.lineTo(48, 24);
  },
  up: (g) => {
    g.moveTo(16, 40);
    g.lineTo(32, 20);
    g.lineTo(48, 40);
  },
  bar: (g) => {
    g.arc(32, 32, 17, 0, 7);
    g.moveTo(20, 44);
    g.lineTo(44, 20);
  },
  clock: (g) => {
    g.arc(32, 32, 17, 0, 7);
    g.moveTo(32, 22);
    g.lineTo(32, 32);
    g.lineTo(40, 36);
  },
};

/**
 * Draws a glyph with a dark rim, readable on any part.
 * @param {Glyph} glyph
 * @param {string} color
 */
export function glyphTexture(glyph, color) {
  const canvas = document.createElement('canvas');
  canvas.width = 64;
  canvas.height = 64;
  const g = canvas.getContext('2d');
  if (!g) throw new Error('this browser gives no canvas to draw on');
  g.lineCap = 'round';
  g.lineJoin = 'round';
  for (const { style, width } of [
    { style: 'rgba(8,10,15,0.85)', width: 13 },
    { style: color, width: 6.5 },
  ]) {
    g.strokeStyle = style;
    g.lineWidth = width;
    g.beginPath();
    kDraw[glyph](g);
    g.stroke();
  }
  return new CanvasTexture(canvas);
}

/**
 * @param {number[] | Float32Array} positions
 * @param {PointsMaterial} material
 */
function cloudOf(positions, material) {
  const geometry = new BufferGeometry();
  const position = new Float32BufferAttribute(positions, 3);
  const index = new BufferAttribute(new Uint32Array(positions.length / 3), 1);
  geometry.setAttribute('position', position);
  geometry.setIndex(index);
  const cloud = new Points(geometry, material);
  cloud.frustumCulled = false;
  cloud.renderOrder = 9;
  return { cloud, position, index };
}

export class Markers {
  /**
   * @param {Query} query
   * @param {number} pixelRatio
   */
  constructor(query, pixelRatio) {
    this.paths = query.paths;
    this.ends = new Group();
    /** @type {{cloud: Points, index: BufferAttribute, indices: number[]}[]} */
    this.clouds = []; // for filters
    for (const [outcome, style] of Object.entries(OUTCOME_STYLE)) {
      /** @type {number[]} */
      const indices = [];
      /** @type {number[]} */
      const at = [];
      query.paths.forEach((path, index) => {
        if (path.outcome !== outcome || outcome === 'goal') return;
        indices.push(index);
        const [x, y, z] = path.end();
        at.push(x, y + 0.35, z);
      });
      if (!at.length) continue;
      const { cloud, index } = cloudOf(
        at,
        new PointsMaterial({
          map: glyphTexture(style.glyph, style.color),
          size: 15 * pixelRatio,
          sizeAttenuation: false,
          transparent: true,
          depthTest: true,
          depthWrite: false,
        }),
      );
      this.clouds.push({ cloud, index, indices });
      this.ends.add(cloud);
    }
    const { cloud, position, index } = this.runnerCloud(pixelRatio);
    this.runners = cloud;
    this.places = position.setUsage(DynamicDrawUsage);
    this.colors = new Float32BufferAttribute(new Float32Array(3 * this.paths.length), 3);
    cloud.geometry.setAttribute('color', this.colors);
    this.clouds.push({ cloud, index, indices: query.paths.map((_, i) => i) });
    this.group = new Group();
    this.group.add(this.ends, this.runners);
  }

  /** @param {number} pixelRatio */
  runnerCloud(pixelRatio) {
    return cloudOf(
      new Float32Array(this.paths.length * 3),
      new PointsMaterial({
        size: 13 * pixelRatio,
        sizeAttenuation: false,
        vertexColors: true,
        transparent: true,
        depthWrite: false,
        map: glyphTexture('dot', '#ffffff'),
      }),
    );
  }

  /**
   * `tint`: path -> colour, for the runners. Ends keep the colour of their outcome.
   * @param {Tint} tint
   */
  setColors(tint) {
    const mixed = new Color();
    this.paths.forEach((path, i) => mixed.set(tint(path)).toArray(this.colors.array, 3 * i));
    this.colors.needsUpdate = true;
  }

  /**
   * `shown`: set of indices.
   * @param {Set<number>} shown
   */
  setShown(shown) {
    for (const { cloud, index, indices } of this.clouds) {
      let at = 0;
      indices.forEach((path, i) => {
        if (shown.has(path)) index.array[at++] = i;
      });
      index.needsUpdate = true;
      cloud.geometry.setDrawRange(0, at);
    }
  }

  /** @param {number} tick */
  update(tick) {
    if (!this.runners.visible) return;
    this.paths.forEach((path, i) => {
      const pose = path.poseAt(tick);
      this.places.setXYZ(i, pose.x, pose.y + 1, pose.z);
    });
    this.places.needsUpdate = true;
  }

  dispose() {
    dispose(this.group);
  }
}
