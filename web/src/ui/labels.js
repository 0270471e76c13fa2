// Names of regions, kept over their boxes as the camera moves.
import { el } from './dom.js';

export class Labels {
  constructor(root) {
    this.root = root;
    this.items = [];
  }

  set(labels) {
    this.root.replaceChildren();
    this.items = labels.map(({ text, at, color }) => {
      const node = el('span', { class: 'label', text, style: { '--tint': color } });
      this.root.append(node);
      return { node, at };
    });
  }

  update(camera, width, height, visible) {
    this.root.hidden = !visible;
    if (!visible) return;
    for (const { node, at } of this.items) {
      const p = at.clone().project(camera);
      const inside = p.z < 1 && Math.abs(p.x) < 1.1 && Math.abs(p.y) < 1.1;
      node.hidden = !inside;
      if (inside)
        node.style.transform = `translate(${((p.x + 1) / 2) * width}px, ${((1 - p.y) / 2) * height}px) translate(-50%, -100%)`;
    }
  }
}
