// The part of the picture that no panel covers.

/** @import {Free} from '../scene/camera_rig.js' */

/** @typedef {keyof Free} Side */

/** @param {Free} area */
const sizeOf = ({ left, top, right, bottom }) =>
  Math.max(0, right - left) * Math.max(0, bottom - top);

/**
 * Cuts a strip off the area, on the side where it costs least, so that the panel is outside.
 * @param {Free} area
 * @param {Free} panel
 * @returns {Free}
 */
function without(area, panel) {
  const apart =
    panel.left >= area.right ||
    panel.right <= area.left ||
    panel.top >= area.bottom ||
    panel.bottom <= area.top;
  if (apart) return area;
  const cuts = [
    { ...area, right: panel.left },
    { ...area, bottom: panel.top },
    { ...area, left: panel.right },
    { ...area, top: panel.bottom },
  ];
  return cuts.reduce((best, cut) => (sizeOf(cut) > sizeOf(best) ? cut : best));
}

/**
 * Returns the free area as shares of the canvas. Panels that leave less than a quarter of it are
 * ignored.
 * @param {HTMLElement} canvas
 * @param {HTMLElement[]} panels
 * @returns {Free}
 */
export function freeArea(canvas, panels) {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const share = (/** @type {DOMRect} */ box) => ({
    left: (box.left - left) / Math.max(1, width),
    right: (box.right - left) / Math.max(1, width),
    top: (box.top - top) / Math.max(1, height),
    bottom: (box.bottom - top) / Math.max(1, height),
  });
  const shown = panels.map((panel) => panel.getBoundingClientRect()).filter((box) => box.width > 0);
  /** @type {Free} */
  const whole = { left: 0, top: 0, right: 1, bottom: 1 };
  const free = shown.map(share).sort((a, b) => sizeOf(b) - sizeOf(a)).reduce(without, whole);
  return sizeOf(free) >= 0.25 ? free : whole;
}
