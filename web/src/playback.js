// The playback clock, which converts wall time to ticks of the selected trajectory.

/** @import {Store} from './store.js' */

export class Playback {
  /**
   * @param {Store} store
   * @param {() => number} lengthOf ticks
   * @param {() => number} rateOf ticks a second
   */
  constructor(store, lengthOf, rateOf) {
    this.store = store;
    this.lengthOf = lengthOf;
    this.rateOf = rateOf;
  }

  /** @param {number} seconds */
  advance(seconds) {
    const { playing, tick, speed, loop } = this.store.state;
    if (!playing) return;
    const length = this.lengthOf();
    let next = tick + Math.min(seconds, 0.25) * speed * this.rateOf();
    if (next >= length) {
      // Pauses on the last frame before looping, so that the end is visible.
      const pause = 0.7 * this.rateOf() * speed;
      if (loop && length > 0) next = next >= length + pause ? 0 : next;
      else next = length;
      if (!loop) this.store.set({ playing: false });
    }
    this.store.set({ tick: next });
  }

  toggle() {
    const { playing, tick } = this.store.state;
    if (!this.lengthOf()) return;
    if (!playing && tick >= this.lengthOf()) this.store.set({ tick: 0 });
    this.store.set({ playing: !playing });
  }

  /** @param {number} tick */
  seek(tick) {
    this.store.set({ tick: Math.min(Math.max(0, tick), this.lengthOf()) });
  }

  /** @param {number} by */
  step(by) {
    this.store.set({ playing: false });
    const tick = Math.min(this.store.state.tick, this.lengthOf());
    this.seek(by > 0 ? Math.floor(tick + 1e-6) + by : Math.ceil(tick - 1e-6) + by);
  }

  /** @param {number} by */
  faster(by) {
    const speeds = [0.1, 0.25, 0.5, 1, 2, 4, 10];
    const at = speeds.findIndex((speed) => speed >= this.store.state.speed - 1e-9);
    this.store.set({ speed: speeds[Math.min(Math.max(0, at + by), speeds.length - 1)] });
  }
}
