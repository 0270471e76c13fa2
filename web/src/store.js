// The page's state, one flat object. `set` notifies listeners of the changed names. No other object
// holds state.
import { UNFILTERED } from './choice.js';
import { NO_RULER } from './ruler.js';

/** @import {State} from './types/report.js' */

export class Store {
  /** @param {State} initial */
  constructor(initial) {
    this.state = { ...initial };
    /** @type {((state: State, changed: Set<string>) => void)[]} */
    this.listeners = [];
  }

  /** @param {Partial<State>} patch */
  set(patch) {
    const names = /** @type {(keyof State)[]} */ (Object.keys(patch));
    const changed = new Set(names.filter((name) => this.state[name] !== patch[name]));
    Object.assign(this.state, patch);
    if (changed.size) for (const listener of this.listeners) listener(this.state, changed);
  }

  /**
   * @template {keyof State} K
   * @param {K} name
   * @param {State[K]} value
   */
  put(name, value) {
    const patch = /** @type {Partial<State>} */ ({ [name]: value });
    this.set(patch);
  }

  /**
   * Calls the listener when one of `names` has changed.
   * @param {readonly (keyof State)[]} names
   * @param {(state: State) => void} listener
   */
  on(names, listener) {
    this.listeners.push((state, changed) => {
      if (names.some((name) => changed.has(name))) listener(state);
    });
  }
}

/** @type {State} */
export const INITIAL = {
  ...UNFILTERED,
  sort: 'found',
  descending: false,
  order: [],
  colorBy: 'outcome',
  isolate: false,
  ghost: -1,
  frame: -1,
  drawing: false,
  measuring: false,
  ruler: NO_RULER,
  status: '',
  theme: 'auto',
  heat: false,
  heatMax: 0,
  heatTrajectories: false,
  cut: true,
  query: 0,
  path: -1,
  tick: 0,
  playing: false,
  speed: 1,
  loop: true,
  loopFrom: 0,
  loopTo: 0,
  follow: false,
  followNewest: false,
  hoverPath: -1,
  part: -1,
  colors: 'roles',
  solutions: true,
  attempts: false,
  markers: true,
  runners: false,
  regions: true,
  labels: true,
  grid: true,
  motionPaths: true,
};
