// Draws the picture with its background and labels into another canvas, for pictures and films.

/** @import {App} from '../app.js' */

const kBackground = ['#1b212d', '#12151c', '#0e1117']; // as in stage.css
const kLabelFont = '600 11.5px Inter, system-ui, sans-serif';
const kLabelGround = 'rgba(14, 17, 23, 0.78)';

/**
 * @param {CanvasRenderingContext2D} pen
 * @param {HTMLElement} label
 * @param {DOMRect} frame
 */
function drawLabel(pen, label, frame) {
  const box = label.getBoundingClientRect();
  const [x, y] = [box.left - frame.left, box.top - frame.top];
  pen.fillStyle = kLabelGround;
  pen.beginPath();
  pen.roundRect(x, y, box.width, box.height, box.height / 2);
  pen.fill();
  pen.fillStyle = label.style.getPropertyValue('--tint');
  pen.fillText(label.textContent ?? '', x + box.width / 2, y + box.height / 2);
}

/**
 * Draws the current picture. The canvas must have the size of the view, in pixels.
 * @param {App} app
 * @param {HTMLCanvasElement} target
 */
export function drawStill(app, target) {
  const view = app.stage.canvas;
  const pen = target.getContext('2d');
  if (!pen) throw new Error('this browser has no 2D canvas');
  const { width, height } = target;
  const frame = view.getBoundingClientRect();
  const scale = width / Math.max(1, frame.width);
  const ground = pen.createRadialGradient(width / 2, 0, 0, width / 2, 0, Math.max(width, height));
  kBackground.forEach((color, i) => ground.addColorStop(i / 2, color));
  pen.fillStyle = ground;
  pen.fillRect(0, 0, width, height);
  pen.drawImage(view, 0, 0, width, height);
  const root = app.labels.root;
  if (root.hidden) return;
  pen.save();
  pen.scale(scale, scale);
  pen.font = kLabelFont;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  for (const { node } of app.labels.items) if (!node.hidden) drawLabel(pen, node, frame);
  pen.restore();
}

/**
 * Returns a canvas of the view's size.
 * @param {App} app
 */
export function stillCanvas({ stage }) {
  const target = document.createElement('canvas');
  // Encoders of films need even sizes.
  target.width = Math.max(2, stage.canvas.width - (stage.canvas.width % 2));
  target.height = Math.max(2, stage.canvas.height - (stage.canvas.height % 2));
  return target;
}
