// The filter's boxes in the picture: solid if trajectories must pass them, dashed if they must not.
import {
  Box3,
  Box3Helper,
  BoxGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineDashedMaterial,
  Mesh,
  MeshBasicMaterial,
  Vector3,
} from 'three';

/** @import {BufferGeometry} from 'three' */
/** @import {FilterBox} from '../types/report.js' */

const kKeep = '#7fd4ff';
const kDrop = '#ff9e64';

/** @param {string} color */
const fillOf = (color) =>
  new MeshBasicMaterial({
    color,
    transparent: true,
    opacity: 0.1,
    depthWrite: false,
    side: DoubleSide,
  });

export class FilterBoxes {
  constructor() {
    this.group = new Group();
    /** @type {BufferGeometry[]} */
    this.geometries = []; // geometries of the boxes shown
    // The materials stay alive between calls: a drag recreates the boxes at each move, and the
    // renderer drops a GPU program with its last material.
    const dashes = { dashSize: 0.06, gapSize: 0.06 };
    this.kept = { line: new LineBasicMaterial({ color: kKeep }), fill: fillOf(kKeep) };
    this.dropped = {
      line: new LineDashedMaterial({ color: kDrop, ...dashes }),
      fill: fillOf(kDrop),
    };
  }

  /** @param {readonly FilterBox[]} boxes */
  set(boxes) {
    this.clear();
    for (const box of boxes) this.add(box);
  }

  /** @param {FilterBox} box */
  add({ min, max, keep }) {
    const look = keep ? this.kept : this.dropped;
    const bounds = new Box3(new Vector3().fromArray(min), new Vector3().fromArray(max));
    const edges = new Box3Helper(bounds);
    for (const material of [edges.material].flat()) material.dispose();
    edges.material = look.line;
    if (!keep) {
      edges.geometry = edges.geometry.toNonIndexed();
      edges.computeLineDistances();
    }
    edges.renderOrder = 4;
    const fill = new Mesh(new BoxGeometry(1, 1, 1), look.fill);
    bounds.getCenter(fill.position);
    bounds.getSize(fill.scale);
    fill.renderOrder = 3;
    this.group.add(edges, fill);
    this.geometries.push(edges.geometry, fill.geometry);
  }

  clear() {
    for (const geometry of this.geometries.splice(0)) geometry.dispose();
    this.group.clear();
  }
}
