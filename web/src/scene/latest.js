// Computes the state of parts after the events up to a tick. It continues from the previous tick,
// since hours of play have many events.

/** @import {PartEvent} from '../types/page_data.js' */

export class Latest {
  /**
   * `ends`: returns true if an event's value ends the state that an earlier one began.
   * @param {(value: number) => boolean} ends
   */
  constructor(ends) {
    this.ends = ends;
    /** @type {PartEvent[] | null} */
    this.events = null;
    this.tick = 0;
    this.read = 0; // number of events up to the previous tick
    /** @type {Map<number, number>} */
    this.values = new Map();
  }

  /**
   * Returns part -> value. `events`: [tick, part, value], sorted by tick.
   * @param {PartEvent[]} events
   * @param {number} tick
   * @returns {Map<number, number>}
   */
  at(events, tick) {
    if (events !== this.events || tick < this.tick)
      Object.assign(this, { events, read: 0, values: new Map() });
    this.tick = tick;
    for (; this.read < events.length && events[this.read][0] <= tick; this.read++) {
      const [, part, value] = events[this.read];
      if (this.ends(value)) this.values.delete(part);
      else this.values.set(part, value);
    }
    return this.values;
  }
}
