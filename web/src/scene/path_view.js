// Trajectories of a query as lines. Attempts are thin and faint in one buffer, solutions bright,
// and the selected one thick. Its played part is brighter than the rest.
import { AdditiveBlending, Color, Group } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { BAND_STYLE, GHOST_COLOR, pathColor, SELECTED_COLOR } from '../palette.js';
import { dispose } from './dispose.js';
import { kLift, skipOf, ThinLines } from './thin_lines.js';

/** @import {Object3D} from 'three' */
/** @import {LineMaterialParameters} from 'three/addons/lines/LineMaterial.js' */
/** @import {Path} from '../path.js' */
/** @import {Along, Query, State, Tint} from '../types/report.js' */

// Max thick solutions. Further ones are thin lines, because a thick line costs a draw call and many
// pixels.
const kMaxThick = 12;

/**
 * Returns pairs of points for line segments, from sample `first` to sample `last`.
 * @param {Path} path
 */
function segmentsOf(path, first = 0, last = path.samples - 1) {
  const out = new Float32Array(Math.max(0, last - first) * 6);
  for (let i = 0; first + i < last; i++) {
    for (let k = 0; k < 6; k++)
      out[6 * i + k] = path.points[3 * (first + i) + k] + (k % 3 === 1 ? kLift : 0);
  }
  return out;
}

/**
 * @param {Path} path
 * @param {string} color
 * @param {number} width
 * @param {number} opacity
 * @param {LineMaterialParameters} options
 * @param {[first?: number, last?: number]} range
 */
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

/**
 * Colours a line along its trajectory; without `along` it keeps its one colour.
 * @param {Object3D} line
 * @param {Path} path
 * @param {Along | undefined} along
 */
function paint(line, path, along) {
  if (!(line instanceof LineSegments2) || (!along && !line.material.vertexColors)) return;
  if (along) {
    const colors = new Float32Array(6 * (path.samples - 1));
    const color = new Color();
    for (let i = 0; i < path.samples; i++) {
      color.set(along(path, i));
      if (i > 0) color.toArray(colors, 6 * i - 3);
      if (i < path.samples - 1) color.toArray(colors, 6 * i);
    }
    line.geometry.setColors(colors);
    line.material.color.set('#ffffff');
  }
  line.material.vertexColors = Boolean(along);
  line.material.needsUpdate = true;
}

export class PathView {
  /** @param {Query} query */
  constructor(query) {
    this.paths = query.paths;
    /** @type {Tint} */
    this.tint = pathColor;
    /** @type {Along | undefined} */
    this.along = undefined;
    this.group = new Group();
    const indices = query.paths.map((_, i) => i);
    const isSolution = (/** @type {number} */ i) => query.paths[i].kind === 'solution';
    const solutions = indices.filter(isSolution);
    const attempts = indices.filter((i) => !isSolution(i));
    const further = solutions.slice(kMaxThick);
    const skip = skipOf(query.paths, [...attempts, ...further]);
    this.failed = new ThinLines(query.paths, attempts, skip);
    this.further = new ThinLines(query.paths, further, skip);
    this.attempts = this.failed.lines;
    this.solutions = new Group();
    /** @type {Map<number, LineSegments2>} */
    this.thick = new Map(); // index -> line
    for (const i of solutions.slice(0, kMaxThick)) this.addSolution(i);
    this.solutions.add(this.further.lines);
    this.selection = new Group();
    this.rival = new Group(); // the ghost of a comparison
    this.hovered = new Group();
    /** @type {Object3D[]} */
    this.left = []; // removed lines that are not freed yet
    /** @type {LineSegments2 | null} */
    this.played = null; // the selected trajectory up to the current moment
    /** @type {LineSegments2 | null} */
    this.hardest = null; // the hardest step of the selected trajectory
    this.group.add(this.attempts, this.solutions, this.rival, this.hovered, this.selection);
  }

  /** @param {number} index */
  addSolution(index) {
    const path = this.paths[index];
    const dashes = path.mismatch ? { dashed: true, dashSize: 1, gapSize: 0.6 } : {};
    const line = thickLine(path, pathColor(path), 2.2, 0.75, dashes);
    if (path.mismatch) line.computeLineDistances();
    this.thick.set(index, line);
    this.solutions.add(line);
  }

  /**
   * @param {State} state
   * @param {boolean} dimmed
   */
  show({ solutions }, dimmed) {
    this.solutions.visible = solutions;
    for (const line of this.thick.values()) line.material.opacity = dimmed ? 0.28 : 0.75;
  }

  /**
   * `shown`: set of indices.
   * @param {Set<number>} shown
   */
  setShown(shown) {
    this.failed.setShown(shown);
    this.further.setShown(shown);
    for (const [index, line] of this.thick) line.visible = shown.has(index);
  }

  /**
   * @param {Tint} tint
   * @param {Along} [along] the colour at a sample, if it changes along a trajectory
   */
  setColors(tint, along) {
    this.tint = tint;
    this.along = along;
    this.failed.setColors(tint, along);
    this.further.setColors(tint, along);
    for (const [index, line] of this.thick) {
      line.material.color.set(tint(this.paths[index]));
      paint(line, this.paths[index], along);
    }
  }

  /** @param {Group} group */
  empty(group) {
    for (const line of [...group.children]) {
      group.remove(line);
      this.left.push(line);
    }
  }

  // Frees removed lines after the next picture, for the reason given at Leaving.
  sweep() {
    for (const line of this.left.splice(0)) dispose(line);
  }

  /** @param {Path | undefined} path */
  select(path) {
    this.empty(this.selection);
    this.played = null;
    if (!path) return;
    const tint = this.tint(path);
    // Hidden sections shine faintly through the parts.
    this.played = thickLine(path, path.outcome === 'goal' ? SELECTED_COLOR : '#ffffff', 4.2, 1);
    this.selection.add(
      thickLine(path, tint, 2.5, 0.3, { depthTest: false, blending: AdditiveBlending }),
      thickLine(path, '#0b0e14', 7.5, 0.45),
      thickLine(path, tint, 3.6, 0.75),
      this.played,
    );
    for (const i of [2, 3]) paint(this.selection.children[i], path, this.along);
    this.selection.children.forEach((line, i) => {
      line.renderOrder = 7 + i;
    });
    this.markHardest(path);
  }

  /**
   * Highlights the hardest step of the selected line.
   * @param {Path} path
   */
  markHardest(path) {
    this.hardest = null;
    if (!path.difficulty) return;
    const { startTick, ticks, band } = path.difficulty.hardest;
    const sample = (/** @type {number} */ tick) => {
      const { i, j, share } = path.at(tick);
      return share < 0.5 ? i : j;
    };
    const [first, last] = [sample(startTick), sample(startTick + ticks)];
    if (last <= first) return;
    this.hardest = thickLine(path, BAND_STYLE[band].color, 9, 0.85, {}, [first, last]);
    this.hardest.renderOrder = 8; // above the dark border, below the line itself
    this.selection.add(this.hardest);
  }

  /**
   * Draws the ghost of a comparison, dashed.
   * @param {Path | undefined} path
   */
  compare(path) {
    this.empty(this.rival);
    if (!path) return;
    const dashes = { dashed: true, dashSize: 0.9, gapSize: 0.5 };
    const line = thickLine(path, GHOST_COLOR, 3.2, 0.95, dashes);
    line.computeLineDistances();
    this.rival.add(line);
  }

  /** @param {Path | undefined} path */
  hover(path) {
    this.empty(this.hovered);
    if (path) this.hovered.add(thickLine(path, '#ffffff', 3, 0.9));
  }

  /**
   * Sets how much of the selected line has been played.
   * @param {Path} path
   * @param {number} tick
   */
  play(path, tick) {
    if (!this.played) return;
    const { i, j, share } = path.at(tick);
    const count = share > 0 ? j : i;
    this.played.geometry.instanceCount = count;
    this.played.visible = count > 0;
  }

  dispose() {
    this.solutions.remove(this.further.lines);
    for (const group of [this.selection, this.rival, this.hovered, this.solutions])
      this.empty(group);
    this.sweep();
    this.failed.dispose();
    this.further.dispose();
  }
}
