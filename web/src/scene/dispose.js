// Frees the GPU resources of a tree of nodes. Removing it from the scene does not free them.
export function dispose(root) {
  root.traverse((node) => {
    node.geometry?.dispose();
    node.material?.map?.dispose();
    node.material?.dispose();
    if (node.isInstancedMesh) node.dispose();
  });
}

// Views that leave a scene. They are freed only after the next picture: the renderer drops an
// unused GPU program, and compiling it again for a similar view takes longer than drawing.
export class Leaving {
  constructor(scene) {
    Object.assign(this, { scene, waiting: [] });
  }

  // `free`: frees the group's view. It runs at once if the view was never drawn, because a hidden
  // page draws nothing while its stream goes on.
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
