// Keyboard shortcuts. They are disabled while the user types or holds Ctrl, Alt or Meta. Space
// toggles a focused check box.
import { isAttempt } from './choice.js';
import { NO_RULER } from './ruler.js';
import { nextTheme } from './theme.js';

/** @import {App} from './app.js' */
/** @import {NamesOf} from './types/report.js' */

const kWithAlt = /^[[\]]$/; // characters that some keyboards type with Alt

/** @param {EventTarget | null} target */
function typing(target) {
  return (
    target instanceof HTMLElement &&
    (target.matches('input:not([type=checkbox], [type=range]), select, textarea') ||
      target.isContentEditable)
  );
}

/** @param {KeyboardEvent} event */
const ticking = ({ key, target }) =>
  key === ' ' && target instanceof HTMLElement && target.matches('input[type=checkbox]');

/**
 * @param {App} app
 * @param {number} by
 */
function moveQuery(app, by) {
  const max = app.report.queries.length;
  if (max <= 0) return;
  const at = app.store.state.query;
  app.store.set({ query: (Math.max(0, at + (at < 0 ? Math.max(by, 0) : by)) + max) % max });
}

/**
 * Selects the trajectory `by` rows further down the list, at its first tick.
 * @param {App} app
 * @param {number} by
 */
function neighbour(app, by) {
  const { order: listed, path, attempts } = app.store.state;
  const paths = app.query()?.paths ?? [];
  const order = listed.filter((i) => attempts || i === path || !isAttempt(paths[i]));
  if (!order.length) return;
  const at = order.indexOf(path);
  const next = at < 0 ? (by > 0 ? 0 : order.length - 1) : (at + by + order.length) % order.length;
  app.store.set({ path: order[next], tick: 0 });
}

/**
 * Pins the selected trajectory as the ghost for comparisons.
 * @param {App} app
 */
function pin({ store }) {
  const { path, ghost } = store.state;
  store.set({ ghost: ghost >= 0 ? -1 : path });
}

/**
 * Starts or ends the drawing of a box. Without trajectories it is disabled, because the filter that
 * removes boxes is hidden then.
 * @param {App} app
 */
function draw(app) {
  const drawing = !app.store.state.drawing && Boolean(app.query()?.paths.length);
  app.store.set({ drawing });
}

/**
 * Returns the views, for one that ends the following of the player.
 * @param {App} app
 */
function free({ store, views }) {
  store.set({ follow: false });
  return views;
}

/** @param {App} app */
function follow(app) {
  if (!app.path()) app.status.say('Select a trajectory to follow its player');
  app.store.set({ follow: !app.store.state.follow && Boolean(app.path()) });
}

/** @type {NamesOf<boolean>[]} */
const kToggles = [
  'solutions',
  'attempts',
  'markers',
  'runners',
  'regions',
  'labels',
  'motionPaths',
  'grid',
  'heat',
  'cut',
];

/**
 * Actions by printed character, for keys whose position differs between keyboards.
 * @type {Record<string, ((app: App, event: KeyboardEvent) => void) | undefined>}
 */
const kByKey = {
  '?': (app) => app.help.toggle(),
  F1: (app) => app.help.toggle(),
  '[': (app) => moveQuery(app, -1),
  ']': (app) => moveQuery(app, 1),
  '+': (app) => app.playback.faster(1),
  '=': (app) => app.playback.faster(1),
  '-': (app) => app.playback.faster(-1),
  ' ': (app) => app.playback.toggle(),
  ArrowLeft: (app, event) => app.playback.step(event.shiftKey ? -10 : -1),
  ArrowRight: (app, event) => app.playback.step(event.shiftKey ? 10 : 1),
  ArrowUp: (app) => neighbour(app, -1),
  ArrowDown: (app) => neighbour(app, 1),
  Home: (app) => app.playback.seek(0),
  End: (app) => app.playback.seek(app.length()),
  Escape: (app) =>
    app.store.set(
      app.store.state.drawing
        ? { drawing: false }
        : app.store.state.measuring
          ? { measuring: false, ruler: NO_RULER }
          : { path: -1, part: -1, ghost: -1, playing: false, follow: false },
    ),
  b: (app) => draw(app),
  i: (app) => app.store.set({ isolate: !app.store.state.isolate }),
  x: (app) => pin(app),
  y: (app) => nextTheme(app.store),
  l: (app) => app.playback.toggleLoop(),
  ',': (app) => app.playback.step(-1),
  '.': (app) => app.playback.step(1),
  '<': (app) => app.playback.markFrom(),
  '>': (app) => app.playback.markTo(),
  m: (app) => app.ruler.toggle(),
  c: (app) => app.store.set({ colors: app.store.state.colors === 'roles' ? 'level' : 'roles' }),
  f: (app) => app.focusSelection(),
  g: (app) => follow(app),
  t: (app) => free(app).above(),
  r: (app) => free(app).course(),
};

/** @param {App} app */
export function bindKeys(app) {
  window.addEventListener('keydown', (event) => {
    app.shift = event.shiftKey;
    if (typing(event.target) || ticking(event)) return;
    if (event.ctrlKey || event.metaKey || (event.altKey && !kWithAlt.test(event.key))) return;
    if (app.help.dialog.open && !['?', 'F1'].includes(event.key)) return;
    if (app.stage.rig.key(event.code, true)) return;
    const act = kByKey[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    const toggle = /^\d$/.test(event.key) ? kToggles[(Number(event.key) + 9) % 10] : undefined;
    if (!act && !toggle) return;
    event.preventDefault();
    if (act) act(app, event);
    else if (toggle) app.store.put(toggle, !app.store.state[toggle]);
  });
  window.addEventListener('keyup', (event) => {
    app.shift = event.shiftKey;
    app.stage.rig.key(event.code, false);
    // A focused button would treat Space as a click. Only the help wants that.
    if (event.key === ' ' && event.target instanceof HTMLButtonElement && !app.help.dialog.open)
      event.preventDefault();
  });
}
