// Poses over time of parts that follow the level clock, and of dynamic parts in a trajectory.
import { floats, longs, shorts } from './bytes.js';

/** @import {BodyTrackData, TrackData} from './types/page_data.js' */
/** @import {Between} from './types/report.js' */

// Poses of a moving part, one sample every `stride` ticks from tick 0 on. The samples repeat from
// `loopFrom` on; with -1 the last pose stays.
export class Track {
  /** @param {TrackData} raw */
  constructor(raw) {
    this.part = raw.part;
    this.stride = raw.stride;
    this.count = raw.count;
    this.loopFrom = raw.loopFrom;
    // If true, ticks count from the motion's start, which the trajectory's events state.
    this.triggered = Boolean(raw.triggered);
    this.position = raw.position ? floats(raw.position) : null;
    this.rotation = raw.rotation ? shorts(raw.rotation) : null;
  }

  /**
   * Returns the two samples around a tick, and the weight of the second.
   * @param {number} tick
   * @returns {Between}
   */
  at(tick) {
    const s = Math.max(0, tick / this.stride);
    let i = Math.floor(s);
    const share = s - i;
    const wrap = (/** @type {number} */ k) => {
      if (k < this.count) return k;
      if (this.loopFrom < 0) return this.count - 1;
      return this.loopFrom + ((k - this.loopFrom) % (this.count - this.loopFrom));
    };
    const next = wrap(i + 1);
    i = wrap(i);
    // A jump back to the first key must not be interpolated across the level.
    return { i, next: this.jumps(i, next) ? i : next, share };
  }

  /**
   * @param {number} i
   * @param {number} next
   */
  jumps(i, next) {
    if (next >= i || !this.position) return false;
    const p = this.position;
    return (
      Math.hypot(
        p[3 * i] - p[3 * next],
        p[3 * i + 1] - p[3 * next + 1],
        p[3 * i + 2] - p[3 * next + 2],
      ) > 4
    );
  }
}

// Poses of a dynamic part at some ticks of a trajectory, with linear interpolation.
export class BodyTrack {
  /** @param {BodyTrackData} raw */
  constructor(raw) {
    this.part = raw.part;
    this.ticks = longs(raw.ticks);
    this.position = floats(raw.position);
    this.rotation = shorts(raw.rotation);
  }

  /**
   * Returns the same as Track.at().
   * @param {number} tick
   * @returns {Between}
   */
  at(tick) {
    const { ticks } = this;
    let [i, end] = [0, ticks.length - 1];
    while (end - i > 1) {
      const middle = (i + end) >> 1;
      if (ticks[middle] <= tick) i = middle;
      else end = middle;
    }
    const share = (tick - ticks[i]) / (ticks[end] - ticks[i] || 1);
    return { i, next: end, share: Math.min(1, Math.max(0, share)) };
  }
}
