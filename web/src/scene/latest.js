// What events have made of parts up to a tick. They are read on from where they were: of hours of play there are many.
export class Latest {
  // `ends`: whether a value of an event ends what one before it began.
  constructor(ends) {
    this.ends = ends;
    this.events = null;
  }

  // Part -> value. `events`: [tick, part, value], in the order of ticks.
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
