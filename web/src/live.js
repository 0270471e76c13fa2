// The page of obby-view --live. It starts the app with the first level and merges later changes.
// Selection, filters, camera and playback stay.
import { LiveFeed } from './live_feed.js';
import { LiveReport } from './live_report.js';
import { keepingPlace } from './ui/dom.js';
import { LiveMark } from './ui/live_mark.js';

// A running search updates its numbers often, which need no new drawing.
function onlyNumbers(before, now) {
  if (before?.paths.length !== now.paths.length || before.result || now.result) return false;
  const rest = ({ paths, progress, running, ...facts }) => JSON.stringify(facts);
  return rest(before) === rest(now) && before.paths.every((path, i) => path === now.paths[i]);
}

export class Live {
  // `begin`: report -> app. `fail`: reports why there is nothing to show.
  constructor(side, begin, fail) {
    Object.assign(this, { side, begin });
    this.live = new LiveReport();
    this.connected = undefined; // unknown
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

  // After the stream has ended, a lost server does not matter.
  tell(connected) {
    this.connected = connected;
    if (!connected && this.live.state !== 'live') this.feed.close();
    this.show();
  }

  show() {
    this.mark.show(this.live.state, this.connected, this.live.report, Boolean(this.app));
  }

  take(raw) {
    const { app, live } = this;
    const chosen = app?.path();
    const ghost = app?.ghost();
    const before = app?.query();
    const changed = live.take(raw, [chosen, ghost]);
    if (app) {
      this.refresh(changed, before, chosen, ghost);
      if (!before && app.query() && !app.moved) app.stage.frameQuery(true);
      this.followNewest(changed.fresh);
    } else if (live.report.levels.length) {
      this.app = this.begin(live.report);
      this.app.live = this;
      this.side.prepend(this.mark.root);
      this.mark.bind(this.app.store);
    }
    this.show();
  }

  refresh({ levels, queries }, before, chosen, ghost) {
    const { app } = this;
    const { state } = app.store;
    const news = queries.has(state.query) && !onlyNumbers(before, app.query());
    if (news || levels.has(app.query()?.level ?? 0))
      keepingPlace(app.list.rows, () => this.refreshQuery(chosen, ghost));
    app.sidebar.refresh();
    app.dirty = true;
  }

  refreshQuery(chosen, ghost) {
    const { app } = this;
    const { store, stage } = app;
    if (stage.level !== app.level()) app.glowing = -1; // it refers to a part of the removed level
    app.openQuery();
    // Indices may have changed, and a trajectory may have come again with fewer samples.
    const indexOf = (path) =>
      path ? app.query().paths.findIndex(({ serial }) => serial === path.serial) : -1;
    store.set({ path: indexOf(chosen), ghost: indexOf(ghost), hoverPath: -1 });
    app.filters.refresh();
    app.ways.choose();
    app.showSelection();
    stage.pathView?.compare(app.ghost());
    app.applyToggles();
    app.showPart();
    app.timeline.draw();
    app.timeline.showTime();
  }

  followNewest(fresh) {
    const { app } = this;
    const paths = app.query()?.paths ?? [];
    const newest = fresh.filter((path) => path.kind === 'solution' && paths.includes(path)).pop();
    if (!app.store.state.followNewest || !newest) return;
    app.store.set({ path: paths.indexOf(newest), tick: 0 });
  }
}
