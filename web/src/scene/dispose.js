// What a tree of nodes holds on the GPU goes with it: taking it from the scene alone does not free that.
export function dispose(root) {
  root.traverse((node) => {
    node.geometry?.dispose();
    node.material?.map?.dispose();
    node.material?.dispose();
    if (node.isInstancedMesh) node.dispose();
  });
}
