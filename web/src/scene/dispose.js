// Frees the GPU resources of a tree of nodes. Removing the tree from the scene does not.
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

// Views removed from a scene. They are freed only after the next picture, because the renderer
// drops an unused GPU program, and compiling it again for a similar view takes longer than
// drawing.
export class Leaving {
  /** @param {Scene} scene */
  constructor(scene) {
    this.scene = scene;
    /** @type {(() => void)[]} */
    this.waiting = [];
  }

  /**
   * `free`: frees the group's view. It runs at once if the view was never drawn: a hidden page
   * draws nothing while its stream continues.
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

  // Called after each new picture.
  drawn() {
    for (const { userData } of this.scene.children) userData.drawn = true;
    this.free();
  }
}
