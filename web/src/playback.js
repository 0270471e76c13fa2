// The playback clock, which converts wall time to ticks of the selected trajectory.

/** @import {Store} from './store.js' */
/** @import {State} from './types/report.js' */

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 10];

/**
 * Returns the ticks between which playback runs: the loop's range, or the whole length.
 * @param {Pick<State, 'loop' | 'loopFrom' | 'loopTo'>} state
 * @param {number} length
 */
export function rangeOf({ loop, loopFrom, loopTo }, length) {
  const to = Math.min(loopTo, length);
  const isPart = loop && to - loopFrom >= 1;
  return { from: isPart ? loopFrom : 0, to: isPart ? to : length, isPart };
}

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
    const { from, to, isPart } = rangeOf(this.store.state, this.lengthOf());
    let next = tick + Math.min(seconds, 0.25) * speed * this.rateOf();
    if (isPart && tick < from) next = from;
    if (next >= to) {
      // Pauses on the last frame before looping, so that the end is visible. A range has no pause.
      const pause = isPart ? 0 : 0.7 * this.rateOf() * speed;
      if (loop && to > 0) next = next >= to + pause ? from : next;
      else next = to;
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

  // The loop's range begins, or ends, at the current moment.
  markFrom() {
    const { tick, loopTo } = this.store.state;
    const end = loopTo > tick ? loopTo : this.lengthOf();
    this.store.set({ loop: true, loopFrom: tick, loopTo: end });
  }

  markTo() {
    const { tick, loopFrom } = this.store.state;
    this.store.set({ loop: true, loopFrom: loopFrom < tick ? loopFrom : 0, loopTo: tick });
  }

  // Switches the loop. Without a loop its range is forgotten.
  toggleLoop() {
    const loop = !this.store.state.loop;
    this.store.set({ loop, ...(loop ? {} : { loopFrom: 0, loopTo: 0 }) });
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
    const at = SPEEDS.findIndex((speed) => speed >= this.store.state.speed - 1e-9);
    this.store.set({ speed: SPEEDS[Math.min(Math.max(0, at + by), SPEEDS.length - 1)] });
  }
}
