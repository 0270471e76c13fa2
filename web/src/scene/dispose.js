// What a tree of nodes holds on the GPU goes with it: taking it from the scene alone does not free that.
export function dispose(root) {
  root.traverse((node) => {
    node.geometry?.dispose();
    node.material?.map?.dispose();
    node.material?.dispose();
    if (node.isInstancedMesh) node.dispose();
  });
}

// Views that leave a scene. They are freed behind the next picture only: a program of the GPU that nothing uses any more is
// thrown away, and to make it anew for a view of the same kind takes longer than to draw.
export class Leaving {
  constructor(scene) {
    Object.assign(this, { scene, waiting: [] });
  }

  // `free`: frees the view of that group. At once if it was never drawn: a page that nobody looks at draws nothing, and its
  // stream goes on.
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
