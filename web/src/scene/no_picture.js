// Where the browser has no WebGL: a message in place of the picture. All else of the page goes on, and what it tells the
// renderer is told nobody.
import { el } from '../ui/dom.js';

const kMessage =
  'No 3D picture: this browser has no WebGL. Hardware acceleration may be off in its settings. ' +
  'The rest of the report works. obby-view -o FILE.png draws a picture without a browser.';

// What the stage asks of a renderer.
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

// The message takes the pointer, and the keyboard passes by.
export function noPicture(canvas) {
  canvas.hidden = true;
  canvas.parentElement.append(
    el('div', { class: 'no-picture', role: 'status' }, el('p', { text: kMessage })),
  );
  return new NoRenderer();
}
