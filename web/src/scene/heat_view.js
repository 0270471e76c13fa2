// Where the listed ways go: a tile for each cell of two studs, the brighter the more ways pass it. Cells of the search
// are not in the stream; these are counted from the ways' positions, each way once a cell.
import { Color, Group, InstancedMesh, Matrix4, MeshBasicMaterial, PlaneGeometry } from 'three';
import { rampColor } from '../coloring.js';

const kCell = 2; // studs
const kMostTiles = 20000; // the most visited are kept
const kLift = 0.12; // studs above the lowest feet of the cell

// One number for a cell, whole up to 65,536 studs from the middle of the world; farther ones fall together.
const keyOf = (x, y, z) =>
  (((x + 32768) & 65535) * 65536 + ((y + 32768) & 65535)) * 65536 + ((z + 32768) & 65535);

// [{x, y, z, ways}] in studs: the cell's middle, and the lowest feet in it.
export function visits(paths) {
  const cells = new Map();
  for (const path of paths) {
    for (let i = 0; i < 3 * path.samples; i += 3) {
      const feet = path.points[i + 1];
      const x = Math.floor(path.points[i] / kCell);
      const z = Math.floor(path.points[i + 2] / kCell);
      const key = keyOf(x, Math.floor(feet / kCell), z);
      let cell = cells.get(key);
      if (!cell) {
        cell = { x: (x + 0.5) * kCell, y: feet, z: (z + 0.5) * kCell, ways: 0, last: null };
        cells.set(key, cell);
      }
      if (feet < cell.y) cell.y = feet;
      // Ways come one after another, so that the last visitor tells whether this one was here.
      if (cell.last !== path) cell.ways += 1;
      cell.last = path;
    }
  }
  return [...cells.values()];
}

export class HeatView {
  constructor() {
    this.group = new Group();
  }

  set(paths) {
    this.clear();
    const cells = visits(paths)
      .sort((a, b) => b.ways - a.ways)
      .slice(0, kMostTiles);
    if (!cells.length) return;
    const mesh = new InstancedMesh(
      new PlaneGeometry(kCell * 0.92, kCell * 0.92).rotateX(-Math.PI / 2),
      new MeshBasicMaterial({ transparent: true, opacity: 0.6, depthWrite: false }),
      cells.length,
    );
    // Counts spread over orders of magnitude.
    const scale = Math.log(cells[0].ways + 1);
    const color = new Color();
    const place = new Matrix4();
    cells.forEach(({ x, y, z, ways }, i) => {
      mesh.setMatrixAt(i, place.makeTranslation(x, y + kLift, z));
      mesh.setColorAt(i, color.set(rampColor(Math.log(ways + 1) / scale)));
    });
    mesh.renderOrder = 4;
    mesh.frustumCulled = false;
    this.most = cells[0].ways;
    this.group.add(mesh);
  }

  clear() {
    for (const mesh of [...this.group.children]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
      mesh.dispose();
      this.group.remove(mesh);
    }
  }
}
