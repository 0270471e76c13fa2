// The page's state, one flat object. `set` notifies listeners of the changed names. No other object
// holds state.
import { UNFILTERED } from './choice.js';

export class Store {
  constructor(initial) {
    this.state = { ...initial };
    this.listeners = [];
  }

  set(patch) {
    const changed = new Set();
    for (const [name, value] of Object.entries(patch)) {
      if (this.state[name] !== value) {
        this.state[name] = value;
        changed.add(name);
      }
    }
    if (changed.size) for (const listener of this.listeners) listener(this.state, changed);
  }

  // Calls the listener when one of `names` has changed.
  on(names, listener) {
    this.listeners.push((state, changed) => {
      if (names.some((name) => changed.has(name))) listener(state, changed);
    });
  }
}

export const INITIAL = {
  ...UNFILTERED,
  sort: 'found',
  descending: false,
  order: [], // indices of the listed trajectories, set by main.js from filters and sorting
  colorBy: 'outcome',
  isolate: false, // draw only the selected one
  ghost: -1, // trajectory that runs next to the selected one
  frame: -1, // part for the camera to frame; main.js resets it
  drawing: false, // the next drag draws a box
  theme: 'auto', // or 'light', 'dark'
  heat: false,
  heatMost: 0, // count of the fullest tile
  heatWays: false, // show the listed trajectories even if the search's own heat map is known
  cut: true,
  query: 0,
  path: -1,
  tick: 0,
  playing: false,
  speed: 1,
  loop: true,
  follow: false,
  followNewest: false, // live: select each new solution
  hoverPath: -1,
  part: -1,
  colors: 'roles',
  solutions: true,
  attempts: true,
  markers: true,
  runners: false,
  regions: true,
  labels: true,
  grid: true,
  motionPaths: true,
};
