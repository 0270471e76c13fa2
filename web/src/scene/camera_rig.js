// The camera, as in Studio: left-drag orbits, right-drag looks, middle-drag pans, the wheel zooms,
// WASD and QE fly. Two fingers zoom and pan. It can follow the player, and glides to whatever is
// framed.
import { MathUtils, PerspectiveCamera, Vector3 } from 'three';

/** @import {Box3} from 'three' */
/** @import {Triple} from '../types/page_data.js' */
/** @import {Camera} from '../types/report.js' */

/** @type {Record<string, Triple>} */
const kKeys = {
  KeyW: [0, 0, 1],
  KeyS: [0, 0, -1],
  KeyA: [-1, 0, 0],
  KeyD: [1, 0, 0],
  KeyE: [0, 1, 0],
  KeyQ: [0, -1, 0],
};

/** @typedef {{yaw: number, pitch: number}} Direction radians */
/** @typedef {Direction & {target: Vector3, distance: number}} View */

// Max distance in studs; in a larger level, twice the distance that frames it.
const kFarthest = 8000;

export class CameraRig {
  /** @param {HTMLElement} canvas */
  constructor(canvas) {
    this.camera = new PerspectiveCamera(50, 1, 0.1, 20000);
    this.target = new Vector3(); // pivot of orbiting
    /** @type {View} */
    this.goal = { target: new Vector3(), yaw: 0.7, pitch: -0.5, distance: 60 };
    /** @type {View} */
    this.now = { target: new Vector3(), yaw: 0.7, pitch: -0.5, distance: 60 };
    this.framed = 0; // distance in studs that framed the last target
    /** @type {Set<string>} */
    this.keys = new Set();
    this.flySpeed = 40;
    /** @type {{button: number, x: number, y: number} | null} */
    this.drag = null;
    /** @type {Map<number, {x: number, y: number}>} */
    this.fingers = new Map(); // pointer id of a touch -> position
    this.locked = false; // the left button has another function
    this.free = 1; // share of the width not covered by panels
    this.onUserMove = () => {};
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
          this.flySpeed = MathUtils.clamp(this.flySpeed * Math.exp(-event.deltaY / 600), 2, 2000);
        else this.approach(Math.exp(event.deltaY / 700));
      },
      { passive: false },
    );
    window.addEventListener('blur', () => this.keys.clear());
  }

  /**
   * Multiplies the distance to the target.
   * @param {number} times
   */
  approach(times) {
    const farthest = Math.max(kFarthest, 2 * this.framed);
    this.goal.distance = MathUtils.clamp(this.goal.distance * times, 1, farthest);
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
    this.approach(before / apart());
    this.pan(dx / 2, dy / 2);
  }

  /** @param {PointerEvent} event */
  dragTo(event) {
    if (!this.drag) return;
    const dx = event.clientX - this.drag.x;
    const dy = event.clientY - this.drag.y;
    this.drag.x = event.clientX;
    this.drag.y = event.clientY;
    if (this.drag.button === 1) this.pan(dx, dy);
    else this.turn(dx, dy, this.drag.button === 2);
  }

  /**
   * @param {number} dx
   * @param {number} dy
   * @param {boolean} aboutEye
   */
  turn(dx, dy, aboutEye) {
    const eye = this.eyeOf(this.goal);
    this.goal.yaw -= dx * 0.005;
    this.goal.pitch = MathUtils.clamp(this.goal.pitch - dy * 0.005, -1.55, 1.55);
    if (aboutEye) {
      this.onUserMove();
      this.goal.target.copy(eye).addScaledVector(this.forwardOf(this.goal), this.goal.distance);
    }
  }

  /**
   * @param {number} dx
   * @param {number} dy
   */
  pan(dx, dy) {
    this.onUserMove();
    const studs =
      (2 * this.goal.distance * Math.tan(MathUtils.degToRad(this.camera.fov / 2))) / innerHeight;
    const right = new Vector3(1, 0, 0).applyQuaternion(this.camera.quaternion);
    const up = new Vector3(0, 1, 0).applyQuaternion(this.camera.quaternion);
    this.goal.target.addScaledVector(right, -dx * studs).addScaledVector(up, dy * studs);
  }

  /** @param {Direction} direction */
  forwardOf({ yaw, pitch }) {
    return new Vector3(
      -Math.sin(yaw) * Math.cos(pitch),
      Math.sin(pitch),
      -Math.cos(yaw) * Math.cos(pitch),
    );
  }

  /** @param {View} view */
  eyeOf(view) {
    return view.target.clone().addScaledVector(this.forwardOf(view), -view.distance);
  }

  /**
   * @param {string} code
   * @param {boolean} down
   */
  key(code, down) {
    if (!(code in kKeys)) return false;
    if (down) this.keys.add(code);
    else this.keys.delete(code);
    return true;
  }

  /**
   * @param {number} seconds
   * @param {boolean} fast
   */
  fly(seconds, fast) {
    const move = new Vector3();
    for (const code of this.keys) move.add(new Vector3(...kKeys[code]));
    if (move.lengthSq() === 0) return;
    this.onUserMove();
    const forward = this.forwardOf(this.goal);
    const right = new Vector3(Math.cos(this.goal.yaw), 0, -Math.sin(this.goal.yaw));
    const step = seconds * this.flySpeed * (fast ? 4 : 1);
    this.goal.target.addScaledVector(forward, move.z * step).addScaledVector(right, move.x * step);
    this.goal.target.y += move.y * step;
  }

  /**
   * Frames a sphere. `view` may also set yaw and pitch.
   * @param {Vector3} centre
   * @param {number} radius
   * @param {Partial<Direction>} view
   */
  frame(centre, radius, view = {}, atOnce = false) {
    const fit = Math.tan(MathUtils.degToRad(this.camera.fov / 2)) * Math.min(1, this.camera.aspect);
    Object.assign(this.goal, view);
    this.goal.target.copy(centre);
    this.goal.distance = Math.max(4, (radius / fit) * 1.08);
    if (atOnce) this.settle();
  }

  /**
   * Frames a box as closely as its corners allow.
   * @param {Box3} box
   * @param {Direction} direction
   */
  frameBox(box, { yaw, pitch }, atOnce = false) {
    const centre = box.getCenter(new Vector3());
    const forward = this.forwardOf({ yaw, pitch });
    const right = new Vector3(Math.cos(yaw), 0, -Math.sin(yaw));
    const up = right.clone().cross(forward);
    const tall = Math.tan(MathUtils.degToRad(this.camera.fov / 2)) * 0.86;
    const wide = tall * this.camera.aspect * this.free;
    let distance = 8;
    for (let corner = 0; corner < 8; corner++) {
      const at = new Vector3(
        (corner & 1 ? box.max : box.min).x,
        (corner & 2 ? box.max : box.min).y,
        (corner & 4 ? box.max : box.min).z,
      ).sub(centre);
      const near = -at.dot(forward);
      distance = Math.max(
        distance,
        near + Math.abs(at.dot(right)) / wide,
        near + Math.abs(at.dot(up)) / tall,
      );
    }
    this.frame(centre, 1, { yaw, pitch }, false);
    this.goal.distance = distance;
    this.framed = distance;
    if (atOnce) this.settle();
  }

  /** @param {Vector3} point */
  follow(point) {
    this.goal.target.copy(point);
  }

  settle() {
    this.now = { ...this.goal, target: this.goal.target.clone() };
  }

  /**
   * @param {number} seconds
   * @param {boolean} fast
   */
  update(seconds, fast) {
    this.fly(seconds, fast);
    const share = 1 - Math.exp(-seconds * 14);
    this.now.target.lerp(this.goal.target, share);
    this.now.yaw += (this.goal.yaw - this.now.yaw) * share;
    this.now.pitch += (this.goal.pitch - this.now.pitch) * share;
    this.now.distance += (this.goal.distance - this.now.distance) * share;
    this.camera.position.copy(this.eyeOf(this.now));
    this.camera.near = Math.max(0.05, this.now.distance / 500);
    this.camera.far = Math.max(4000, this.now.distance * 40);
    this.camera.lookAt(this.now.target);
    this.camera.updateProjectionMatrix();
  }

  /** @returns {Camera} */
  save() {
    const { target, yaw, pitch, distance } = this.goal;
    return [target.x, target.y, target.z, yaw, pitch, distance];
  }

  /** @param {Camera} camera */
  restore([x, y, z, yaw, pitch, distance]) {
    this.goal = { target: new Vector3(x, y, z), yaw, pitch, distance };
    this.framed = Math.max(this.framed, distance);
    this.settle();
  }
}
