// What a tree of nodes holds on the GPU goes with it: taking it from the scene alone does not free that.
import { InstancedMesh, Line, Mesh, Points, PointsMaterial } from 'three';

/** @import {Object3D, Scene} from 'three' */

/** @param {Object3D} root */
export function dispose(root) {
  root.traverse((node) => {
    if (!(node instanceof Mesh || node instanceof Line || node instanceof Points)) return;
    const { geometry, material: own } = /** @type {Mesh | Line | Points} */ (node);
    geometry.dispose();
    for (const material of [own].flat()) {
      if (material instanceof PointsMaterial) material.map?.dispose();
      material.dispose();
    }
    if (node instanceof InstancedMesh) node.dispose();
  });
}

// Views that leave a scene. They are freed behind the next picture only: a program of the GPU that nothing uses any more is
// thrown away, and to make it anew for a view of the same kind takes longer than to draw.
export class Leaving {
  /** @param {Scene} scene */
  constructor(scene) {
    this.scene = scene;
    /** @type {(() => void)[]} */
    this.waiting = [];
  }

  /**
   * `free`: frees the view of that group. At once if it was never drawn: a page that nobody looks at draws nothing, and its
   * stream goes on.
   * @param {Object3D} group
   * @param {() => void} free
   */
  take(group, free) {
    this.scene.remove(group);
    if (group.userData.drawn) this.waiting.push(free);
    else free();
  }

  free() {
    for (const free of this.waiting.splice(0)) free();
  }

  // There is a new picture.
  drawn() {
    for (const { userData } of this.scene.children) userData.drawn = true;
    this.free();
  }
}
