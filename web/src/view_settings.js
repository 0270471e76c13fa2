// The reader's view settings, which the browser keeps for the next page: camera mode, colours,
// speed, layers and theme. Only what differs from the defaults is kept.
import { COLORINGS } from './coloring.js';
import { SPEEDS } from './playback.js';
import { INITIAL } from './store.js';

/** @import {App} from './app.js' */
/** @import {State} from './types/report.js' */

const kKey = 'obby-view';

/** @type {(value: unknown) => boolean} */
const isSwitch = (value) => typeof value === 'boolean';
/** @type {(...values: unknown[]) => (value: unknown) => boolean} */
const isOneOf = (...values) => (value) => values.includes(value);

/**
 * The kept settings, each with a test of its values. Another version may have kept others.
 * @satisfies {Partial<Record<keyof State, (value: unknown) => boolean>>}
 */
const kSettings = {
  follow: isSwitch,
  colorBy: isOneOf(...Object.keys(COLORINGS)),
  colors: isOneOf('roles', 'level'),
  speed: isOneOf(...SPEEDS),
  loop: isSwitch,
  theme: isOneOf('auto', 'light', 'dark'),
  solutions: isSwitch,
  attempts: isSwitch,
  markers: isSwitch,
  runners: isSwitch,
  regions: isSwitch,
  labels: isSwitch,
  motionPaths: isSwitch,
  grid: isSwitch,
  heat: isSwitch,
  cut: isSwitch,
};
const kNames = /** @type {(keyof typeof kSettings)[]} */ (Object.keys(kSettings));

/**
 * Returns the settings of a kept text that this page knows.
 * @param {string | null} text
 * @returns {Partial<State>}
 */
export function settingsOf(text) {
  let kept;
  try {
    kept = JSON.parse(text ?? '{}');
  } catch {
    return {};
  }
  const known = kNames.filter((name) => kSettings[name](kept?.[name]));
  return Object.fromEntries(known.map((name) => [name, kept[name]]));
}

// A browser may refuse storage, for example to pages that are files.
export function keptSettings() {
  try {
    return settingsOf(localStorage.getItem(kKey));
  } catch {
    return {};
  }
}

/** @param {State} state */
function keep(state) {
  const changed = kNames.filter((name) => state[name] !== INITIAL[name]);
  try {
    if (!changed.length) localStorage.removeItem(kKey);
    else
      localStorage.setItem(
        kKey,
        JSON.stringify(Object.fromEntries(changed.map((name) => [name, state[name]]))),
      );
  } catch {
    // The settings then last as long as the page.
  }
}

/**
 * Keeps the settings from now on. A link that says where the camera is ends the following.
 * @param {App} app
 * @param {Partial<State>} kept the settings that the page began with
 */
export function keepSettings(app, { follow }) {
  app.store.set({ follow: Boolean(follow && app.path() && !app.moved) });
  app.store.on(kNames, keep);
}

/** @param {App} app */
export function resetSettings({ store, status }) {
  store.set(Object.fromEntries(kNames.map((name) => [name, INITIAL[name]])));
  status.say('View settings are reset');
}
