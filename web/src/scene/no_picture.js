// Shows a message instead of the picture if the browser has no WebGL. The rest of the page works,
// and calls of the renderer do nothing.
import { el } from '../ui/dom.js';

const kMessage =
  'No 3D picture: this browser has no WebGL. Hardware acceleration may be off in its settings. ' +
  'The rest of the report works. obby-view -o FILE.png draws a picture without a browser.';

// The renderer methods that the stage calls.
class NoRenderer {
  constructor() {
    this.shadowMap = {};
  }

  setPixelRatio() {}

  getPixelRatio() {
    return 1;
  }

  setClearAlpha() {}

  setSize() {}

  clear() {}

  render() {}
}

// The message takes pointer events, and the canvas leaves the tab order.
export function noPicture(canvas) {
  canvas.hidden = true;
  canvas.parentElement.append(
    el('div', { class: 'no-picture', role: 'status' }, el('p', { text: kMessage })),
  );
  return new NoRenderer();
}
