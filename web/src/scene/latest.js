// What events have made of parts up to a tick. They are read on from where they were: of hours of play there are many.

/** @import {PartEvent} from '../types/page_data.js' */

export class Latest {
  /**
   * `ends`: whether a value of an event ends what one before it began.
   * @param {(value: number) => boolean} ends
   */
  constructor(ends) {
    this.ends = ends;
    /** @type {PartEvent[] | null} */
    this.events = null;
    this.tick = 0;
    this.read = 0; // events up to that tick
    /** @type {Map<number, number>} */
    this.values = new Map();
  }

  /**
   * Part -> value. `events`: [tick, part, value], in the order of ticks.
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
