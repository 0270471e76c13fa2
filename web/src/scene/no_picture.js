// Shows a message instead of the picture if the browser has no WebGL. The rest of the page works,
// and calls of the renderer do nothing.
import { PCFShadowMap } from 'three';
import { el } from '../ui/dom.js';

/** @import {WebGLRenderer} from 'three' */

const kMessage =
  'No 3D picture: this browser has no WebGL. Hardware acceleration may be off in its settings. ' +
  'The rest of the report works. obby-view -o FILE.png draws a picture without a browser.';

// The renderer methods that the stage calls.
/** @typedef {'setPixelRatio' | 'getPixelRatio' | 'setClearAlpha' | 'setSize'} Setters */
/** @typedef {Setters | 'clear' | 'render'} Methods */
/** @typedef {'type' | 'enabled' | 'autoUpdate' | 'needsUpdate'} Settings */
/** @typedef {Pick<WebGLRenderer['shadowMap'], Settings>} Shadows */
/** @typedef {Pick<WebGLRenderer, Methods> & {shadowMap: Shadows}} Renderer */

/** @returns {Renderer} */
const noRenderer = () => ({
  shadowMap: { type: PCFShadowMap, enabled: false, autoUpdate: false, needsUpdate: false },
  setPixelRatio() {},
  getPixelRatio: () => 1,
  setClearAlpha() {},
  setSize() {},
  clear() {},
  render() {},
});

/**
 * Shows the message, which receives pointer events. The canvas leaves the tab order.
 * @param {HTMLCanvasElement} canvas
 */
export function noPicture(canvas) {
  canvas.hidden = true;
  canvas.parentElement?.append(
    el('div', { class: 'no-picture', role: 'status' }, el('p', { text: kMessage })),
  );
  return noRenderer();
}
