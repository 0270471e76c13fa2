// The camera: its pivot, direction and distance. It glides to whatever is framed, flies by keys,
// and can follow the player from behind or through its eyes.
import { MathUtils, PerspectiveCamera, Vector2, Vector3 } from 'three';
import { CameraInput } from './camera_input.js';
import { axesOf, fitted } from './framing.js';

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

// The part of the picture that no panel covers, as shares of its width and height.
/** @typedef {{left: number, top: number, right: number, bottom: number}} Free */

// Max distance in studs; in a larger level, twice the distance that frames it.
const kFarthest = 8000;
const kMargin = 0.86; // share of the free area that framed points may fill
const kField = 50; // degrees, vertical
const kFieldOfEyes = 70; // ... of a player's own view
const kGlide = 14; // rate of the camera's approach to its goal, per second
const kBehind = { distance: 18, pitch: -0.3 }; // initial view of a followed player
const kEyes = 3; // studs below which a followed camera moves into the player's head
const kFarBehind = 200; // max distance from a followed player
const kOffWalls = 0.5; // studs between a wall and the eye

/** @param {number} angle */
const wrapped = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

export class CameraRig {
  /** @param {HTMLElement} canvas */
  constructor(canvas) {
    this.camera = new PerspectiveCamera(kField, 1, 0.1, 20000);
    /** @type {View} */
    this.goal = { target: new Vector3(), yaw: 0.7, pitch: -0.5, distance: 60 };
    /** @type {View} */
    this.now = { target: new Vector3(), yaw: 0.7, pitch: -0.5, distance: 60 };
    this.framed = 0; // distance in studs that framed the last target
    /** @type {Set<string>} */
    this.keys = new Set();
    this.flySpeed = 40;
    this.size = new Vector2(1, 1); // pixels
    /** @type {Free} */
    this.free = { left: 0, top: 0, right: 1, bottom: 1 };
    this.middle = new Vector2(0.5, 0.5); // place of the target in the picture, gliding
    /** @type {number | null} */
    this.heading = null; // yaw of the followed player
    this.reach = Infinity; // distance of the wall behind the player, eased
    /** @type {(from: Vector3, to: Vector3) => number} */
    this.sight = () => 1; // share of a line before a wall
    this.onUserMove = () => {};
    this.input = new CameraInput(canvas, this);
  }

  get following() {
    return this.heading !== null;
  }

  // True if the camera looks through the player's eyes.
  get inside() {
    return this.following && this.now.distance < kEyes;
  }

  /**
   * @param {number} width
   * @param {number} height
   */
  resize(width, height) {
    this.size.set(width, height);
    this.camera.aspect = width / Math.max(1, height);
  }

  // Returns the slopes of the free area's borders, see fitted().
  slopes() {
    const { left, top, right, bottom } = this.free;
    const tall = Math.tan(MathUtils.degToRad(kField / 2)) * kMargin;
    return { wide: tall * this.camera.aspect * (right - left), tall: tall * (bottom - top) };
  }

  /**
   * Multiplies the distance to the target.
   * @param {number} times
   */
  approach(times) {
    const farthest = this.following ? kFarBehind : Math.max(kFarthest, 2 * this.framed);
    const next = Math.max(this.goal.distance, this.following ? kEyes : 0) * times;
    if (this.following && next < kEyes) this.goal.distance = 0;
    else this.goal.distance = MathUtils.clamp(next, 1, farthest);
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
    if (aboutEye && !this.following) {
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
  forwardOf(direction) {
    return axesOf(direction).forward;
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
    const { forward, right } = axesOf(this.goal);
    const step = seconds * this.flySpeed * (fast ? 4 : 1);
    this.goal.target.addScaledVector(forward, move.z * step).addScaledVector(right, move.x * step);
    this.goal.target.y += move.y * step;
  }

  /**
   * Frames a sphere from the current direction.
   * @param {Vector3} centre
   * @param {number} radius
   */
  frame(centre, radius) {
    const { wide, tall } = this.slopes();
    this.goal.target.copy(centre);
    this.goal.distance = Math.max(4, radius / Math.min(wide, tall));
  }

  /**
   * Frames points as closely as they allow.
   * @param {ArrayLike<number>} points x, y, z each
   * @param {Direction} direction
   */
  framePoints(points, direction, atOnce = false) {
    const { eye, near, far } = fitted(points, direction, this.slopes());
    const distance = Math.max(8, (near + far) / 2);
    const target = eye.addScaledVector(this.forwardOf(direction), distance);
    // The shorter way around.
    const yaw = this.now.yaw + wrapped(direction.yaw - this.now.yaw);
    this.goal = { target, yaw, pitch: direction.pitch, distance };
    this.framed = distance;
    if (atOnce) this.settle();
  }

  /**
   * @param {Box3} box
   * @param {Direction} direction
   */
  frameBox({ min, max }, direction, atOnce = false) {
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [
      (i & 1 ? max : min).x,
      (i & 2 ? max : min).y,
      (i & 4 ? max : min).z,
    ]);
    this.framePoints(corners, direction, atOnce);
  }

  /**
   * Follows a player. The camera turns with it; drags turn it further, and the wheel sets the
   * distance.
   * @param {Vector3} head
   * @param {number} heading yaw in radians
   */
  follow(head, heading) {
    if (this.heading === null) {
      Object.assign(this.goal, kBehind, { yaw: this.goal.yaw + wrapped(heading - this.goal.yaw) });
      this.reach = Infinity;
    } else this.goal.yaw += wrapped(heading - this.heading);
    this.heading = heading;
    this.goal.target.copy(head);
  }

  unfollow() {
    if (this.heading === null) return;
    this.heading = null;
    this.goal.distance = Math.max(this.goal.distance, kBehind.distance);
  }

  settle() {
    this.now = { ...this.goal, target: this.goal.target.clone() };
    this.middle.copy(this.wantedMiddle());
    this.reach = Infinity;
  }

  wantedMiddle() {
    const { left, top, right, bottom } = this.free;
    return new Vector2((left + right) / 2, (top + bottom) / 2);
  }

  /**
   * Returns the distance of the eye: in front of a wall behind the followed player. It comes closer
   * at once and backs away smoothly.
   * @param {number} share
   */
  clearDistance(share) {
    const { distance } = this.now;
    if (!this.following || distance < kEyes) return distance;
    const hit = this.sight(this.now.target, this.eyeOf(this.now));
    const clear = hit < 1 ? Math.max(0.5, hit * distance - kOffWalls) : distance;
    const from = Math.min(this.reach, distance);
    this.reach = clear < from ? clear : from + (clear - from) * share;
    return this.reach;
  }

  /**
   * @param {number} seconds
   * @param {boolean} fast
   */
  update(seconds, fast) {
    this.fly(seconds, fast);
    const share = 1 - Math.exp(-seconds * kGlide);
    const turn = this.following ? 1 - Math.exp((-seconds * kGlide) / 3) : share;
    this.now.target.lerp(this.goal.target, share);
    this.now.yaw += (this.goal.yaw - this.now.yaw) * turn;
    this.now.pitch += (this.goal.pitch - this.now.pitch) * share;
    this.now.distance += (this.goal.distance - this.now.distance) * share;
    this.middle.lerp(this.wantedMiddle(), share);
    const distance = this.inside ? 0.01 : this.clearDistance(share);
    this.camera.position.copy(this.eyeOf({ ...this.now, distance }));
    this.camera.fov += ((this.inside ? kFieldOfEyes : kField) - this.camera.fov) * share;
    this.camera.near = Math.max(0.05, distance / 500);
    this.camera.far = Math.max(4000, distance * 40);
    this.camera.lookAt(this.camera.position.clone().add(this.forwardOf(this.now)));
    const { x, y } = this.size;
    const [left, top] = [(0.5 - this.middle.x) * x, (0.5 - this.middle.y) * y];
    this.camera.setViewOffset(x, y, left, top, x, y);
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
