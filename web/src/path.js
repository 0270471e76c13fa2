// A trajectory: its samples, and the player's input between them.
import { bytes, floats, words } from './bytes.js';
import { BodyTrack } from './tracks.js';

/** @import {PathData, Triple} from './types/page_data.js' */
/** @import {Box, Pose, Query} from './types/report.js' */

/**
 * Returns the player's input during a tick, or nothing before the first.
 * @param {Uint16Array} runs
 * @param {number} tick
 */
function actionAt(runs, tick) {
  let end = 0;
  for (let i = 0; tick >= 0 && i + 2 < runs.length; i += 3) {
    end += runs[i];
    if (tick < end)
      return { walk: (runs[i + 1] & 1) !== 0, jump: (runs[i + 1] & 2) !== 0, heading: runs[i + 2] };
  }
  return { walk: false, jump: false, heading: 0 };
}

/**
 * Returns a function that decodes the text on its first call. Drawing all trajectories needs only
 * the points, and a user opens only a few of thousands.
 * @template T, V
 * @param {T} text
 * @param {(text: T) => V} as
 */
function unread(text, as) {
  /** @type {T | null} */
  let left = text;
  /** @type {V | undefined} */
  let value;
  return () => {
    if (left !== null) [value, left] = [as(left), null];
    return /** @type {V} */ (value);
  };
}

export class Path {
  /**
   * @param {PathData} raw
   * @param {Query} query
   */
  constructor(raw, query) {
    this.query = query;
    this.kind = raw.kind;
    this.provisional = raw.provisional === true; // the search still improves it
    this.index = raw.index;
    this.method = raw.method;
    this.body = raw.body;
    this.frameRate = raw.frameRate;
    this.outcome = raw.outcome;
    this.part = raw.part;
    this.avoid = raw.avoid;
    this.route = raw.route;
    this.ticks = raw.ticks;
    this.jumps = raw.jumps;
    this.startTick = raw.startTick;
    this.stride = raw.stride;
    this.mismatch = raw.mismatch;
    this.difficulty = raw.difficulty;
    this.jumpTicks = raw.jumpTicks;
    this.events = raw.events;
    this.motions = raw.motions;
    this.points = floats(raw.position);
    this.samples = this.points.length / 3;
    this.read = {
      yaw: unread(raw.yaw, words),
      state: unread(raw.state, bytes),
      runs: unread(raw.runs, words),
      bodies: unread(raw.bodies ?? [], (tracks) => tracks.map((track) => new BodyTrack(track))),
    };
    /** @type {number | undefined} */
    this.serial = undefined; // live: its number in the stream
    /** @type {Box | null} */
    this.bounds = null; // bounds of all samples, set by choice.js
    /** @type {Float32Array | null} */
    this.sums = null; // studs walked up to each sample
  }

  get yaw() {
    return this.read.yaw();
  }

  get state() {
    return this.read.state();
  }

  get runs() {
    return this.read.runs();
  }

  get bodies() {
    return this.read.bodies();
  }

  /**
   * Returns the tick of a sample. Samples are `stride` ticks apart; the last one may be closer.
   * @param {number} sample
   */
  tickOf(sample) {
    return Math.min(sample * this.stride, this.ticks);
  }

  /**
   * Returns the two samples around a tick, and the weight of the second.
   * @param {number} tick
   */
  at(tick) {
    const last = this.samples - 1;
    const now = Math.min(Math.max(0, tick), this.ticks);
    const i = now < this.ticks ? Math.floor(now / this.stride) : last;
    const j = Math.min(i + 1, last);
    const gap = this.tickOf(j) - this.tickOf(i) || 1;
    return { i, j, share: (now - this.tickOf(i)) / gap };
  }

  /**
   * Returns the velocity just before a sample, in studs a tick on each axis; zero at the start.
   * @param {number} sample
   * @returns {Pose['perTick']}
   */
  speedBefore(sample) {
    const from = Math.max(0, sample - 1);
    const gap = this.tickOf(sample) - this.tickOf(from) || 1;
    const p = this.points;
    const along = (/** @type {number} */ k) => (p[3 * sample + k] - p[3 * from + k]) / gap;
    return [along(0), along(1), along(2)];
  }

  /**
   * Returns the interpolated pose at a tick.
   * @param {number} tick
   * @returns {Pose}
   */
  poseAt(tick) {
    const { i, j, share } = this.at(tick);
    const p = this.points;
    const mix = (/** @type {number} */ k) => p[3 * i + k] + (p[3 * j + k] - p[3 * i + k]) * share;
    let turn = this.yaw[j] - this.yaw[i];
    if (turn > 32768) turn -= 65536;
    if (turn < -32768) turn += 65536;
    const yaw = ((this.yaw[i] + turn * share) / 65536) * 2 * Math.PI;
    const speed = this.speedBefore(share > 1e-6 ? j : i);
    return { x: mix(0), y: mix(1), z: mix(2), yaw, state: this.state[i], perTick: speed };
  }

  /**
   * Returns the input during the tick that ends at or contains `tick`, or nothing at the start.
   * @param {number} tick
   */
  actionBefore(tick) {
    return actionAt(this.runs, Math.ceil(tick - 1e-6) - 1);
  }

  walked() {
    const sums = new Float32Array(this.samples);
    const p = this.points;
    for (let i = 1; i < this.samples; i++)
      sums[i] = sums[i - 1] + Math.hypot(p[3 * i] - p[3 * i - 3], p[3 * i + 2] - p[3 * i - 1]);
    return sums;
  }

  /**
   * Returns the horizontal distance walked up to `tick`, in studs. Sums are cached.
   * @param {number} tick
   */
  travelled(tick) {
    this.sums ??= this.walked();
    const { i, j, share } = this.at(tick);
    return this.sums[i] + (this.sums[j] - this.sums[i]) * share;
  }

  /** @returns {Triple} */
  end() {
    const k = 3 * (this.samples - 1);
    return [this.points[k], this.points[k + 1], this.points[k + 2]];
  }
}
