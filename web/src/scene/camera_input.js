// Turns the pointer over the picture into moves of the camera, as in Studio: left-drag orbits,
// right-drag looks, middle-drag pans, the wheel zooms. Two fingers zoom and pan.
import { MathUtils } from 'three';

/** @import {CameraRig} from './camera_rig.js' */

export class CameraInput {
  /**
   * @param {HTMLElement} canvas
   * @param {CameraRig} rig
   */
  constructor(canvas, rig) {
    this.rig = rig;
    /** @type {{button: number, x: number, y: number} | null} */
    this.drag = null;
    /** @type {Map<number, {x: number, y: number}>} */
    this.fingers = new Map(); // pointer id of a touch -> position
    this.locked = false; // the left button has another function
    this.listen(canvas);
  }

  /** @param {HTMLElement} canvas */
  listen(canvas) {
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      if (event.pointerType === 'touch') {
        if (event.isPrimary) this.fingers.clear(); // the end of a previous touch was not reported
        this.fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      }
      this.drag = null;
      if (this.fingers.size > 1) return;
      if (this.locked && event.button === 0) return;
      this.drag = {
        button: event.shiftKey && event.button === 0 ? 1 : event.button,
        x: event.clientX,
        y: event.clientY,
      };
    });
    canvas.addEventListener('pointermove', (event) => {
      if (this.fingers.size > 1) this.pinch(event);
      else this.dragTo(event);
    });
    const end = (/** @type {PointerEvent} */ { pointerId }) => {
      this.drag = null;
      this.fingers.delete(pointerId);
    };
    canvas.addEventListener('pointerup', end);
    canvas.addEventListener('pointercancel', end);
    canvas.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        if (this.drag?.button === 2)
          this.rig.flySpeed = MathUtils.clamp(
            this.rig.flySpeed * Math.exp(-event.deltaY / 600),
            2,
            2000,
          );
        else this.rig.approach(Math.exp(event.deltaY / 700));
      },
      { passive: false },
    );
    window.addEventListener('blur', () => this.rig.keys.clear());
  }

  /**
   * Handles the move of one of several fingers. Only the first two count.
   * @param {PointerEvent} event
   */
  pinch({ pointerId, clientX, clientY }) {
    const finger = this.fingers.get(pointerId);
    if (!finger) return;
    const [a, b] = this.fingers.values();
    const apart = () => Math.max(1, Math.hypot(a.x - b.x, a.y - b.y));
    const before = apart();
    const [dx, dy] = [clientX - finger.x, clientY - finger.y];
    [finger.x, finger.y] = [clientX, clientY];
    if (finger !== a && finger !== b) return;
    this.rig.approach(before / apart());
    this.rig.pan(dx / 2, dy / 2);
  }

  /** @param {PointerEvent} event */
  dragTo(event) {
    if (!this.drag) return;
    const dx = event.clientX - this.drag.x;
    const dy = event.clientY - this.drag.y;
    this.drag.x = event.clientX;
    this.drag.y = event.clientY;
    if (this.drag.button === 1) this.rig.pan(dx, dy);
    else this.rig.turn(dx, dy, this.drag.button === 2);
  }
}
