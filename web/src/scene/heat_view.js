// Shows where the search has been, or where the listed trajectories go. Each cube has a tile whose
// brightness grows with the search's cells in it, or with the trajectories through it. A trajectory
// counts once per cube.
import { Color, Group, InstancedMesh, Matrix4, MeshBasicMaterial, PlaneGeometry } from 'three';
import { heatColor } from '../color_ramps.js';

/** @import {Path} from '../path.js' */
/** @import {HeatMap} from '../types/report.js' */

const kCell = 2; // studs, for trajectories
const kMaxTiles = 20000; // max tiles; the most visited are kept
const kLift = 0.12; // studs above the lowest feet of the cell

/**
 * The cube's centre in studs, with the lowest feet as y.
 * @typedef {{x: number, y: number, z: number, count: number}} Cell
 */

/**
 * Returns a cell's key, unique up to 65,536 studs from the origin; farther cells collide.
 * @param {number} x
 * @param {number} y
 * @param {number} z
 */
const keyOf = (x, y, z) =>
  (((x + 32768) & 65535) * 65536 + ((y + 32768) & 65535)) * 65536 + ((z + 32768) & 65535);

/**
 * @param {Path[]} paths
 * @returns {{size: number, cells: Cell[]}}
 */
export function visits(paths) {
  /** @type {Map<number, Cell & {last: Path | null}>} */
  const cells = new Map();
  for (const path of paths) {
    let here = NaN;
    /** @type {Cell & {last: Path | null} | undefined} */
    let cell;
    for (let i = 0; i < 3 * path.samples; i += 3) {
      const feet = path.points[i + 1];
      const x = Math.floor(path.points[i] / kCell);
      const z = Math.floor(path.points[i + 2] / kCell);
      const key = keyOf(x, Math.floor(feet / kCell), z);
      // A sample is usually in the cell of the previous sample.
      if (key !== here) cell = cells.get(key);
      here = key;
      if (!cell) {
        cell = { x: (x + 0.5) * kCell, y: feet, z: (z + 0.5) * kCell, count: 0, last: null };
        cells.set(key, cell);
      }
      if (feet < cell.y) cell.y = feet;
      // Trajectories are processed in turn, so comparing with the last visitor counts each
      // trajectory once.
      if (cell.last !== path) cell.count += 1;
      cell.last = path;
    }
  }
  return { size: kCell, cells: [...cells.values()] };
}

/**
 * Returns the cells of a result's heat map, in the form that visits() returns.
 * @param {HeatMap} map
 * @returns {{size: number, cells: Cell[]}}
 */
export function searched({ size, feet, counts }) {
  const middle = (/** @type {number} */ v) => (Math.floor(v / size) + 0.5) * size;
  const cells = Array.from(counts, (count, i) => ({
    x: middle(feet[3 * i]),
    y: feet[3 * i + 1],
    z: middle(feet[3 * i + 2]),
    count,
  }));
  return { size, cells };
}

/**
 * Returns 0 for a count of 1 and 1 for the maximum, on a logarithmic scale, since counts span
 * orders of magnitude.
 * @param {number} count
 * @param {number} max
 */
export const heatShare = (count, max) => (max > 1 ? Math.log(count) / Math.log(max) : 0);

export class HeatView {
  constructor() {
    this.group = new Group();
    /** @type {InstancedMesh | null} */
    this.mesh = null;
    this.max = 0; // max count of any tile
    // The material stays alive between maps: each filter recreates the map, and the renderer
    // drops a GPU program with its last material.
    this.material = new MeshBasicMaterial({
      transparent: true,
      opacity: 0.9,
      depthWrite: false,
      fog: false, // must match the legend
    });
  }

  /** @param {{size: number, cells: Cell[]}} map */
  set({ size, cells: all }) {
    this.clear();
    const cells = all.sort((a, b) => b.count - a.count).slice(0, kMaxTiles);
    if (!cells.length) return;
    const mesh = new InstancedMesh(
      new PlaneGeometry(size * 0.92, size * 0.92).rotateX(-Math.PI / 2),
      this.material,
      cells.length,
    );
    this.max = cells[0].count;
    /** @type {Map<number, Color>} */
    const colors = new Map(); // cached by count, since there are few distinct counts
    const place = new Matrix4();
    cells.forEach(({ x, y, z, count }, i) => {
      const color = colors.get(count) ?? new Color(heatColor(heatShare(count, this.max)));
      colors.set(count, color);
      mesh.setMatrixAt(i, place.makeTranslation(x, y + kLift, z));
      mesh.setColorAt(i, color);
    });
    mesh.renderOrder = 4;
    mesh.frustumCulled = false;
    this.mesh = mesh;
    this.group.add(mesh);
  }

  clear() {
    this.max = 0;
    this.mesh?.geometry.dispose();
    this.mesh?.dispose();
    this.mesh = null;
    this.group.clear();
  }
}
