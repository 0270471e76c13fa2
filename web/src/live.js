// The page of obby-view --live. It starts the app with the first level and merges later changes.
// Selection, filters, camera and playback stay.
import { LiveFeed } from './live_feed.js';
import { LiveReport } from './live_report.js';
import { keepingPlace } from './ui/dom.js';
import { LiveMark } from './ui/live_mark.js';

/** @import {App} from './app.js' */
/** @import {Path} from './path.js' */
/** @import {LivePiece} from './types/page_data.js' */
/** @import {Query, Report} from './types/report.js' */

/**
 * Returns true if the queries differ only in the numbers of a running search, which change often
 * and need no redraw.
 * @param {Query | undefined} before
 * @param {Query | undefined} now
 */
function onlyNumbers(before, now) {
  if (!before || !now || before.paths.length !== now.paths.length) return false;
  if (before.result || now.result) return false;
  const rest = (/** @type {Query} */ { paths, progress, running, ...facts }) =>
    JSON.stringify(facts);
  return rest(before) === rest(now) && before.paths.every((path, i) => path === now.paths[i]);
}

/**
 * Returns the index of a trajectory after an update. Indices may have changed, and a trajectory may
 * have arrived again with fewer samples. A first solution has become the improved one.
 * @param {Path | undefined} path
 * @param {Path[]} paths
 */
function successor(path, paths) {
  if (!path) return -1;
  const same = paths.findIndex(({ serial }) => serial === path.serial);
  return same >= 0 || !path.provisional ? same : paths.findIndex(({ kind }) => kind === 'solution');
}

export class Live {
  /**
   * `begin`: report -> app. `fail`: reports why there is nothing to show.
   * @param {HTMLElement} side
   * @param {(report: Report) => App} begin
   * @param {(error: unknown) => void} fail
   */
  constructor(side, begin, fail) {
    this.side = side;
    this.begin = begin;
    /** @type {App | undefined} */
    this.app = undefined;
    this.live = new LiveReport();
    /** @type {boolean | undefined} */
    this.connected = undefined; // unknown
    this.taking = false; // news is being merged
    this.chosen = false; // the reader has selected a trajectory of this query, or cleared it
    this.mark = new LiveMark();
    side.append(this.mark.root);
    this.feed = new LiveFeed({
      revisionOf: () => this.live.revision,
      take: (raw) => this.take(raw),
      tell: (connected) => this.tell(connected),
      fail,
    });
    this.show();
    this.feed.open();
  }

  /**
   * After the end of the stream, a lost connection does not matter.
   * @param {boolean} connected
   */
  tell(connected) {
    this.connected = connected;
    if (!connected && this.live.state !== 'live') this.feed.close();
    this.show();
  }

  show() {
    this.mark.show(this.live.state, this.connected, this.live.report, Boolean(this.app));
  }

  /** @param {LivePiece} raw */
  take(raw) {
    const { app, live } = this;
    const chosen = app?.path();
    const ghost = app?.ghost();
    const before = app?.query();
    const changed = live.take(raw, [chosen, ghost]);
    this.taking = true;
    if (app) {
      this.refresh(app, changed, before, [chosen, ghost]);
      if (!before && app.query() && !app.moved) app.views.query(true);
      this.selectFirst(app);
      this.followNewest(app, changed.fresh);
    } else if (live.report.levels.length) {
      this.app = this.begin(live.report);
      this.app.live = this;
      this.watchSelection(this.app);
      this.side.prepend(this.mark.root);
      this.mark.bind(this.app.store);
    }
    this.taking = false;
    this.show();
  }

  /**
   * @param {App} app
   * @param {ReturnType<LiveReport['take']>} changed
   * @param {Query | undefined} before
   * @param {[Path | undefined, Path | undefined]} shown
   */
  refresh(app, { levels, queries }, before, shown) {
    const { state } = app.store;
    const news = queries.has(state.query) && !onlyNumbers(before, app.query());
    if (news || levels.has(app.query()?.level ?? 0))
      keepingPlace(app.list.rows, () => this.refreshQuery(app, shown));
    app.sidebar.refresh();
    app.dirty = true;
  }

  /**
   * @param {App} app
   * @param {[Path | undefined, Path | undefined]} shown
   */
  refreshQuery(app, [chosen, ghost]) {
    const { store, stage } = app;
    if (stage.level !== app.level()) app.glowing = -1; // it refers to a part of the removed level
    app.openQuery();
    const paths = app.query()?.paths ?? [];
    const indexOf = (/** @type {Path | undefined} */ path) => successor(path, paths);
    store.set({ path: indexOf(chosen), ghost: indexOf(ghost), hoverPath: -1 });
    app.filters.refresh();
    app.trajectories.choose();
    app.showSelection();
    stage.pathView?.compare(app.ghost());
    app.applyToggles();
    app.showPart();
    app.timeline.draw();
    app.timeline.showTime();
  }

  /** @param {App} app */
  watchSelection({ store }) {
    this.chosen = /\btraj=/.test(location.hash);
    store.on(['path'], () => {
      this.chosen ||= !this.taking;
    });
    // Registered after the app's listener, which selects a trajectory of the new query.
    store.on(['query'], () => {
      this.chosen = false;
    });
  }

  /**
   * Selects the first solution in place of the page's own selection.
   * @param {App} app
   */
  selectFirst(app) {
    const first = app.firstPath();
    const isSolution = app.query()?.paths[first]?.kind === 'solution';
    if (this.chosen || !isSolution || app.path()?.kind === 'solution') return;
    app.store.set({ path: first, tick: 0 });
  }

  /**
   * @param {App} app
   * @param {Path[]} fresh
   */
  followNewest(app, fresh) {
    const paths = app.query()?.paths ?? [];
    const newest = fresh.filter((path) => path.kind === 'solution' && paths.includes(path)).pop();
    if (!app.store.state.followNewest || !newest) return;
    app.store.set({ path: paths.indexOf(newest), tick: 0 });
  }
}
