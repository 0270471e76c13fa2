// Marks the ends of attempts, one glyph per outcome, and the runners: a dot for each trajectory at
// the current tick.
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

// Draws a glyph with a dark rim, readable on any part.
export function glyphTexture(glyph, color) {
  const canvas = document.createElement('canvas');
  canvas.width = 64;
  canvas.height = 64;
  const g = canvas.getContext('2d');
  g.lineCap = 'round';
  g.lineJoin = 'round';
  for (const [style, width] of [
    ['rgba(8,10,15,0.85)', 13],
    [color, 6.5],
  ]) {
    g.strokeStyle = style;
    g.lineWidth = width;
    g.beginPath();
    kDraw[glyph](g);
    g.stroke();
  }
  return new CanvasTexture(canvas);
}

function points(positions, material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(new Uint32Array(positions.length / 3), 1));
  const cloud = new Points(geometry, material);
  cloud.frustumCulled = false;
  cloud.renderOrder = 9;
  return cloud;
}

export class Markers {
  constructor(query, pixelRatio) {
    this.paths = query.paths;
    this.ends = new Group();
    this.clouds = []; // {cloud, indices}, for filters
    for (const [outcome, style] of Object.entries(OUTCOME_STYLE)) {
      const indices = [];
      const at = [];
      query.paths.forEach((path, index) => {
        if (path.outcome !== outcome || outcome === 'goal') return;
        indices.push(index);
        const [x, y, z] = path.end();
        at.push(x, y + 0.35, z);
      });
      if (!at.length) continue;
      const cloud = points(
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
      this.clouds.push({ cloud, indices });
      this.ends.add(cloud);
    }
    this.runners = this.runnerCloud(pixelRatio);
    this.clouds.push({ cloud: this.runners, indices: query.paths.map((_, i) => i) });
    this.group = new Group();
    this.group.add(this.ends, this.runners);
  }

  runnerCloud(pixelRatio) {
    const cloud = points(
      new Float32Array(this.paths.length * 3),
      new PointsMaterial({
        size: 5 * pixelRatio,
        sizeAttenuation: false,
        vertexColors: true,
        transparent: true,
        depthWrite: false,
        map: glyphTexture('dot', '#ffffff'),
      }),
    );
    cloud.material.size = 13 * pixelRatio;
    cloud.geometry.setAttribute(
      'color',
      new Float32BufferAttribute(new Float32Array(3 * this.paths.length), 3),
    );
    cloud.geometry.attributes.position.setUsage(DynamicDrawUsage);
    return cloud;
  }

  // `tint`: path -> colour, for the runners. Ends keep the colour of their outcome.
  setColors(tint) {
    const { color } = this.runners.geometry.attributes;
    const mixed = new Color();
    this.paths.forEach((path, i) => mixed.set(tint(path)).toArray(color.array, 3 * i));
    color.needsUpdate = true;
  }

  // `shown`: set of indices.
  setShown(shown) {
    for (const { cloud, indices } of this.clouds) {
      const { index } = cloud.geometry;
      let at = 0;
      indices.forEach((path, i) => {
        if (shown.has(path)) index.array[at++] = i;
      });
      index.needsUpdate = true;
      cloud.geometry.setDrawRange(0, at);
    }
  }

  update(tick) {
    if (!this.runners.visible) return;
    const position = this.runners.geometry.attributes.position;
    this.paths.forEach((path, i) => {
      const pose = path.poseAt(tick);
      position.setXYZ(i, pose.x, pose.y + 1, pose.z);
    });
    position.needsUpdate = true;
  }

  dispose() {
    dispose(this.group);
  }
}
