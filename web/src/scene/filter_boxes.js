// The boxes of the filter in the picture: what must be passed is solid, what must not be is dashed.
import {
  Box3,
  Box3Helper,
  BoxGeometry,
  DoubleSide,
  Group,
  LineDashedMaterial,
  Mesh,
  MeshBasicMaterial,
  Vector3,
} from 'three';

const kKeep = '#7fd4ff';
const kDrop = '#ff9e64';

export class FilterBoxes {
  constructor() {
    this.group = new Group();
  }

  set(boxes) {
    this.clear();
    for (const box of boxes) this.add(box);
  }

  add({ min, max, keep }) {
    const color = keep ? kKeep : kDrop;
    const bounds = new Box3(new Vector3(...min), new Vector3(...max));
    const edges = new Box3Helper(bounds, color);
    if (!keep) {
      edges.material.dispose();
      edges.material = new LineDashedMaterial({ color, dashSize: 0.06, gapSize: 0.06 });
      edges.geometry = edges.geometry.toNonIndexed();
      edges.computeLineDistances();
    }
    edges.renderOrder = 4;
    const fill = new Mesh(
      new BoxGeometry(1, 1, 1),
      new MeshBasicMaterial({
        color,
        transparent: true,
        opacity: 0.1,
        depthWrite: false,
        side: DoubleSide,
      }),
    );
    bounds.getCenter(fill.position);
    bounds.getSize(fill.scale);
    fill.renderOrder = 3;
    this.group.add(edges, fill);
  }

  clear() {
    for (const node of [...this.group.children]) {
      node.geometry.dispose();
      node.material.dispose();
      this.group.remove(node);
    }
  }
}
