// Keeps query, trajectory, time and camera in the page's address after `#`, so that a link opens
// the same view.

/** @import {App} from './app.js' */
/** @import {Camera, Report, State} from './types/report.js' */

/**
 * Returns the index of a query, or -1. Ids may repeat between levels. `n` is the index among equal
 * ids, and is omitted for the first.
 * @param {Report} report
 * @param {string | null} id
 * @param {string | null} n
 */
function queryAt(report, id, n) {
  const same = report.queries.flatMap((query, i) => (query.id === id ? [i] : []));
  return same[Number(n ?? 0)] ?? same[0] ?? -1;
}

/**
 * Returns the index of the initial query, which is the first one with an answer.
 * @param {Report} report
 */
const firstAnswered = ({ queries }) => Math.max(0, queries.findIndex(({ result }) => result));

/**
 * `hash`: an address's fragment with its `#`; `shown`: the query to show if the fragment names
 * none.
 * @param {Report} report
 * @param {string} hash
 */
export function readFragment(report, hash, shown = firstAnswered(report)) {
  const values = new URLSearchParams(hash.slice(1));
  const query = queryAt(report, values.get('q'), values.get('n'));
  /** @type {{query: number, path?: number, time?: number, camera?: Camera}} */
  const found = { query: query >= 0 ? query : shown };
  const paths = report.queries[found.query]?.paths ?? [];
  const path = values.has('traj') ? Number(values.get('traj')) : NaN;
  if (Number.isInteger(path) && path >= 0 && path < paths.length) found.path = path;
  if (values.get('traj') === 'none') found.path = -1;
  const time = values.has('t') ? Number(values.get('t')) : NaN;
  if (Number.isFinite(time) && time >= 0) found.time = time;
  const camera = (values.get('cam') ?? '').split(',').map(Number);
  if (camera.length === 6 && camera.every(Number.isFinite))
    found.camera = /** @type {Camera} */ (/** @type {unknown} */ (camera));
  return found;
}

/**
 * Returns the tick of an address's time. Times are rounded to milliseconds, so they are snapped to
 * whole ticks and never show the tick before.
 * @param {number} time
 * @param {number} rate
 */
export function tickAt(time, rate) {
  const tick = time * rate;
  const whole = Math.round(tick);
  return Math.abs(tick - whole) <= 0.0005 * rate + 1e-6 ? whole : tick;
}

/**
 * Applies changes to the address's fragment. Following or pasting a link in the open page changes
 * only the fragment.
 * @param {App} app
 */
export function followAddress(app) {
  window.addEventListener('hashchange', ({ newURL }) => {
    const { store, playback, stage } = app;
    const shown = store.state.query;
    const found = readFragment(app.report, new URL(newURL).hash, shown);
    store.set({ query: found.query });
    store.set({ path: found.path ?? app.firstPath(), playing: false, follow: false });
    store.set({ tick: Math.min(tickAt(found.time ?? 0, playback.rateOf()), app.length()) });
    if (!found.camera) return;
    stage.rig.restore(found.camera);
    app.moved = true; // the user has chosen a view
  });
}

/**
 * @param {Report} report
 * @param {State} state
 * @param {number} tickRate
 * @param {Camera} camera
 */
export function writeFragment(report, state, tickRate, camera) {
  const values = new URLSearchParams();
  const query = report.queries[state.query];
  if (query) {
    values.set('q', query.id);
    const before = report.queries.slice(0, state.query).filter(({ id }) => id === query.id);
    if (before.length > 0) values.set('n', String(before.length));
  }
  if (state.path >= 0) values.set('traj', String(state.path));
  else if (query?.paths.length > 0) values.set('traj', 'none');
  values.set('t', (state.tick / tickRate).toFixed(3));
  values.set('cam', camera.map((value) => Number(value.toFixed(2))).join(','));
  const text = `#${values.toString().replaceAll('%2C', ',')}`;
  if (text !== location.hash) history.replaceState(null, '', text);
}
