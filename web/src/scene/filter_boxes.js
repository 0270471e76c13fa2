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

const kKeep = '#7fd4ff';
const kDrop = '#ff9e64';

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
    // Kept alive: with its last material a GPU program is dropped, and a drag recreates boxes at
    // each move.
    const dashes = { dashSize: 0.06, gapSize: 0.06 };
    this.kept = { line: new LineBasicMaterial({ color: kKeep }), fill: fillOf(kKeep) };
    this.dropped = {
      line: new LineDashedMaterial({ color: kDrop, ...dashes }),
      fill: fillOf(kDrop),
    };
  }

  set(boxes) {
    this.clear();
    for (const box of boxes) this.add(box);
  }

  add({ min, max, keep }) {
    const look = keep ? this.kept : this.dropped;
    const bounds = new Box3(new Vector3(...min), new Vector3(...max));
    const edges = new Box3Helper(bounds);
    edges.material.dispose();
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
  }

  clear() {
    for (const node of [...this.group.children]) {
      node.geometry.dispose();
      this.group.remove(node);
    }
  }
}
