// Where the listed ways go: a tile for each cell of two studs, the brighter the more ways pass it. Cells of the search
// are not in the stream; these are counted from the ways' positions, each way once a cell.
import { Color, Group, InstancedMesh, Matrix4, MeshBasicMaterial, PlaneGeometry } from 'three';
import { rampColor } from '../coloring.js';

const kCell = 2; // studs
const kMostTiles = 20000; // the most visited are kept
const kLift = 0.12; // studs above the lowest feet of the cell

// [{x, y, z, ways}] in studs: the cell's middle, and the lowest feet in it.
export function visits(paths) {
  const cells = new Map();
  for (const path of paths) {
    const seen = new Set();
    for (let i = 0; i < path.samples; i++) {
      const at = [0, 1, 2].map((k) => Math.floor(path.points[3 * i + k] / kCell));
      const key = at.join(' ');
      const feet = path.points[3 * i + 1];
      let cell = cells.get(key);
      if (!cell) {
        const [x, z] = [at[0], at[2]].map((v) => (v + 0.5) * kCell);
        cell = { x, y: feet, z, ways: 0 };
        cells.set(key, cell);
      }
      cell.y = Math.min(cell.y, feet);
      if (!seen.has(key)) cell.ways += 1;
      seen.add(key);
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
