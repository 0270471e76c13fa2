// Trajectories of a query as lines: attempts thin and faint in one buffer, solutions bright, the selected one thick,
// with the part already played brighter than what is to come.
import {
  AdditiveBlending,
  BufferGeometry,
  Color,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  NormalBlending,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { BAND_STYLE, pathColor, SELECTED_COLOR } from '../palette.js';

export const kLift = 0.35; // studs above the feet, so that lines do not sink into the floor

// Pairs of points, as line segments want them, from one sample to another.
function segmentsOf(path, first = 0, last = path.samples - 1) {
  const out = new Float32Array(Math.max(0, last - first) * 6);
  for (let i = 0; first + i < last; i++) {
    for (let k = 0; k < 6; k++)
      out[6 * i + k] = path.points[3 * (first + i) + k] + (k % 3 === 1 ? kLift : 0);
  }
  return out;
}

function thinLines(paths) {
  const position = [];
  const color = [];
  const tint = new Color();
  for (const path of paths) {
    const segments = segmentsOf(path);
    tint.set(pathColor(path));
    for (let i = 0; i < segments.length; i += 3) {
      position.push(segments[i], segments[i + 1], segments[i + 2]);
      color.push(tint.r, tint.g, tint.b);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(position, 3));
  geometry.setAttribute('color', new Float32BufferAttribute(color, 3));
  // Many attempts add up to a cloud, few stay readable.
  const opacity = Math.min(0.6, Math.max(0.16, 6 / Math.sqrt(paths.length * 4 + 1)));
  const lines = new LineSegments(
    geometry,
    new LineBasicMaterial({
      vertexColors: true,
      transparent: true,
      opacity,
      depthWrite: false,
      blending: NormalBlending,
    }),
  );
  lines.renderOrder = 5;
  return lines;
}

function thickLine(path, color, width, opacity, options = {}, range = []) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(segmentsOf(path, ...range));
  const material = new LineMaterial({
    color,
    linewidth: width,
    transparent: true,
    opacity,
    depthWrite: false,
    ...options,
  });
  const line = new LineSegments2(geometry, material);
  line.renderOrder = 6;
  return line;
}

export class PathView {
  constructor(query) {
    this.paths = query.paths;
    this.group = new Group();
    this.attempts = thinLines(
      query.paths.filter((path) => path.outcome !== 'goal' || path.kind !== 'solution'),
    );
    this.solutions = new Group();
    for (const path of query.paths) {
      if (path.kind === 'solution') this.solutions.add(this.solutionLine(path));
    }
    this.selection = new Group();
    this.hovered = new Group();
    this.group.add(this.attempts, this.solutions, this.hovered, this.selection);
  }

  solutionLine(path) {
    const dashes = path.mismatch ? { dashed: true, dashSize: 1, gapSize: 0.6 } : {};
    const line = thickLine(path, pathColor(path), 2.2, 0.75, dashes);
    if (path.mismatch) line.computeLineDistances();
    return line;
  }

  show({ solutions, attempts }, dimmed) {
    this.solutions.visible = solutions;
    this.attempts.visible = attempts;
    for (const line of this.solutions.children) line.material.opacity = dimmed ? 0.28 : 0.75;
  }

  empty(group) {
    for (const line of [...group.children]) {
      line.geometry.dispose();
      line.material.dispose();
      group.remove(line);
    }
  }

  select(path) {
    this.empty(this.selection);
    if (!path) return;
    // What lies behind parts shines through faintly.
    this.selection.add(
      thickLine(path, pathColor(path), 2.5, 0.3, { depthTest: false, blending: AdditiveBlending }),
      thickLine(path, '#0b0e14', 7.5, 0.45),
      thickLine(path, pathColor(path), 3.6, 0.75),
      thickLine(path, path.outcome === 'goal' ? SELECTED_COLOR : '#ffffff', 4.2, 1),
    );
    this.selection.children.forEach((line, i) => {
      line.renderOrder = 7 + i;
    });
    this.played = this.selection.children[3];
    this.markHardest(path);
  }

  // The hardest step stands out from the rest of the selected line.
  markHardest(path) {
    this.hardest = null;
    if (!path.difficulty) return;
    const { startTick, ticks, band } = path.difficulty.hardest;
    const sample = (tick) => Math.min(path.samples - 1, Math.round(tick / path.stride));
    const range = [sample(startTick), sample(startTick + ticks)];
    if (range[1] <= range[0]) return;
    this.hardest = thickLine(path, BAND_STYLE[band].color, 9, 0.85, {}, range);
    this.hardest.renderOrder = 8; // over the dark border, below the line itself
    this.selection.add(this.hardest);
  }

  hover(path) {
    this.empty(this.hovered);
    if (path) this.hovered.add(thickLine(path, '#ffffff', 3, 0.9));
  }

  // How much of the selected line has been played.
  play(path, tick) {
    if (!path || !this.played) return;
    const count = Math.min(path.samples - 1, Math.ceil(tick / path.stride));
    this.played.geometry.instanceCount = Math.max(0, count);
    this.played.visible = count > 0;
  }

  dispose() {
    this.empty(this.selection);
    this.empty(this.hovered);
    this.empty(this.solutions);
    this.attempts.geometry.dispose();
    this.attempts.material.dispose();
  }
}
