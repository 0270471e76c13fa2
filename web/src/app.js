// The page: connects state, stage and panels, and runs the frame loop.
import { hasMotion } from './data.js';
import { Film } from './export/film.js';
import { followAddress, readFragment, tickAt, writeFragment } from './fragment.js';
import { Playback } from './playback.js';
import { byId, canvas } from './page.js';
import { OUTCOME_STYLE } from './palette.js';
import { panelsOf } from './panels.js';
import { Pointer } from './pointer.js';
import { Stage } from './scene/stage.js';
import { Views } from './scene/views.js';
import { NO_RULER, Ruler } from './ruler.js';
import { bindKeys } from './shortcuts.js';
import { INITIAL, Store } from './store.js';
import { bindTheme } from './theme.js';
import { freeArea } from './ui/free_area.js';
import { Labels } from './ui/labels.js';
import { Status } from './ui/status.js';
import { Trajectories } from './trajectories.js';

/** @import {Live} from './live.js' */
/** @import {Path} from './path.js' */
/** @import {Level, Query, Report, State} from './types/report.js' */

export class App {
  /**
   * @param {Report} report
   * @param {State} initial
   */
  constructor(report, initial = INITIAL) {
    this.report = report;
    this.store = new Store(initial);
    this.playback = new Playback(
      this.store,
      () => this.length(),
      () => this.level()?.tickRate ?? 60,
    );
    bindTheme(this.store);
    this.stage = new Stage(canvas());
    this.views = new Views(this.stage, () => this.measure());
    this.labels = new Labels(byId('labels'));
    this.pointer = new Pointer(this, canvas(), byId('tip'));
    this.trajectories = new Trajectories(this);
    this.ruler = new Ruler(this);
    this.status = new Status(byId('status'), this.store);
    this.film = new Film(this);
    this.dirty = true;
    this.shift = false; // the Shift key is held
    this.glowing = -1; // part
    /** @type {number | undefined} */
    this.saving = undefined; // timer
    /** @type {number | undefined} */
    this.firstDrawn = undefined; // ms since navigation
    /** @type {Live | undefined} */
    this.live = undefined;
    const found = readFragment(report, location.hash);
    this.store.state.query = found.query;
    this.openQuery();
    this.store.state.path = found.path ?? this.firstPath();
    if (found.time !== undefined)
      this.store.state.tick = Math.min(
        tickAt(found.time, this.playback.rateOf()),
        this.length(),
      );
    // Registered before the panels, which show the colours.
    this.store.on(['colorBy'], () => this.trajectories.color());
    const panels = panelsOf(this);
    this.list = panels.list;
    this.filters = panels.filters;
    this.sidebar = panels.sidebar;
    this.comparison = panels.comparison;
    this.timeline = panels.timeline;
    this.scenePanel = panels.scenePanel;
    this.hud = panels.hud;
    this.help = panels.help;
    this.bind();
    this.filters.fill();
    this.trajectories.choose();
    this.showSelection();
    this.applyToggles();
    this.stage.resize();
    this.views.query(true);
    if (found.camera) this.stage.rig.restore(found.camera);
    this.moved = Boolean(found.camera); // the user has chosen a view
    this.lastFrame = performance.now();
    requestAnimationFrame((now) => this.frame(now));
  }

  /** @returns {Query | undefined} */
  query() {
    return this.report.queries[this.store.state.query];
  }

  /** @returns {Level | undefined} */
  level() {
    return this.report.levels[this.query()?.level ?? 0];
  }

  /** @returns {Path | undefined} */
  path() {
    return this.query()?.paths[this.store.state.path];
  }

  /**
   * Returns the ghost of a comparison.
   * @returns {Path | undefined}
   */
  ghost() {
    const { path, ghost } = this.store.state;
    return path >= 0 && ghost !== path ? this.query()?.paths[ghost] : undefined;
  }

  // Returns the timeline's length in ticks, or 0 if nothing can be played.
  length() {
    const path = this.path();
    if (!this.query()?.paths.length && !hasMotion(this.level())) return 0;
    if (path) return Math.max(path.ticks, this.ghost()?.ticks ?? 0);
    // With a long list, a spread call to Math.max would exceed the limit on arguments.
    const min = Math.max(1, 10 * (this.level()?.tickRate ?? 60));
    return (this.query()?.paths ?? []).reduce((max, { ticks }) => Math.max(max, ticks), min);
  }

  // Returns the initial selection: a solution, or else the closest attempt.
  firstPath() {
    const paths = this.query()?.paths ?? [];
    const solution = paths.findIndex((path) => path.kind === 'solution');
    return solution >= 0 ? solution : paths.findIndex((path) => path.kind === 'closest');
  }

  openQuery() {
    const level = this.level();
    if (level && this.stage.level !== level)
      this.stage.setLevel(level, this.store.state.colors);
    this.trajectories.color();
    const query = this.query();
    if (query) this.stage.setQuery(query);
  }

  bind() {
    const { store } = this;
    this.trajectories.bind();
    store.on(['query'], () => {
      this.openQuery();
      const none = { part: -1, hoverPath: -1, ghost: -1, route: '', killer: -1, drawing: false };
      const still = { loopFrom: 0, loopTo: 0 };
      store.set({ path: this.firstPath(), tick: 0, playing: false, ...none, ...still });
      this.filters.fill();
      this.trajectories.choose();
      this.showSelection();
      this.applyToggles();
      store.set({ follow: false, measuring: false, ruler: NO_RULER });
      this.views.query(false);
    });
    store.on(['follow'], ({ follow }) => {
      if (!follow) this.stage.rig.unfollow();
    });
    store.on(['path'], () => this.showSelection());
    store.on(['hoverPath'], (state) =>
      this.stage.pathView?.hover(this.query()?.paths[state.hoverPath]),
    );
    store.on(
      ['solutions', 'attempts', 'markers', 'runners', 'regions', 'grid', 'motionPaths', 'path'],
      () => this.applyToggles(),
    );
    store.on(['colors'], (state) => this.stage.levelView?.setColors(state.colors));
    store.on(['part'], () => this.showPart());
    store.on(/** @type {(keyof State)[]} */ (Object.keys(INITIAL)), () => {
      this.dirty = true;
    });
    // Once the GPU context is restored, the whole picture is redrawn with its shadows.
    this.stage.canvas.addEventListener('webglcontextrestored', () => {
      this.stage.cast = undefined;
      this.dirty = true;
    });
    bindKeys(this);
    followAddress(this);
    this.stage.rig.onUserMove = () => {
      this.moved = true;
      store.set({ follow: false });
    };
  }

  showSelection() {
    const path = this.path();
    this.stage.pathView?.select(path);
    this.stage.marks.set(path);
    this.hud.root.hidden = !path;
    if (this.store.state.tick > this.length()) this.store.set({ tick: this.length() });
    document.title = path
      ? `${this.report.title}: ${OUTCOME_STYLE[path.outcome].label}`
      : this.report.title;
    this.dirty = true;
  }

  showPart() {
    const { part } = this.store.state;
    const view = this.stage.levelView; // null if the stream has no level
    if (this.glowing >= 0) view?.glow(this.glowing, false);
    this.glowing = part;
    view?.glow(part, true);
  }

  applyToggles() {
    const state = this.store.state;
    this.stage.pathView?.show(state, state.path >= 0);
    // Without trajectories the filter that removes boxes is hidden, so they are hidden, too.
    this.stage.filterBoxes.group.visible = Boolean(this.query()?.paths.length);
    if (this.stage.markers) {
      this.stage.markers.ends.visible = state.markers && state.attempts;
      this.stage.markers.runners.visible = state.runners;
    }
    if (this.stage.regionView) this.stage.regionView.group.visible = state.regions;
    if (this.stage.grid) this.stage.grid.visible = state.grid;
    if (this.stage.motionPaths) this.stage.motionPaths.visible = state.motionPaths;
    this.dirty = true;
  }

  focusSelection() {
    const { part } = this.store.state;
    const path = this.path();
    this.store.set({ follow: false });
    if (part >= 0) this.views.part(part);
    else if (path) this.views.path(path);
    else this.views.query(false);
  }

  // Updates the area of the picture that no panel covers.
  measure() {
    /** @type {NodeListOf<HTMLElement>} */
    const panels = document.querySelectorAll('#scene-panel > *, #hud, #comparison');
    this.stage.rig.free = freeArea(this.stage.canvas, this.film.running ? [] : [...panels]);
  }

  /** @param {number} now */
  frame(now) {
    if (!this.stage.canvas.isConnected) return; // the page has shown an error
    if (this.film.busy) {
      requestAnimationFrame((next) => this.frame(next));
      return;
    }
    const since = Math.min((now - this.lastFrame) / 1000, 0.25);
    const passed = this.film.running ? this.film.step : since; // a film has its own clock
    this.lastFrame = now;
    if (this.film.running) this.dirty = true;
    this.playback.advance(passed);
    this.pointer.hover(now);
    const { state } = this.store;
    const tick = Math.min(state.tick, this.length());
    const path = this.path();
    const level = this.level();
    if (state.follow && path && level) this.views.follow(path, tick, level);
    this.stage.resize();
    const before = this.views.stamp();
    this.stage.rig.update(passed, this.shift);
    if (this.dirty || before !== this.views.stamp()) this.draw(tick, path);
    requestAnimationFrame((next) => this.frame(next));
  }

  // Clears the picture of a query whose level is missing, so that the previous one does not remain.
  blank() {
    this.stage.blank();
    this.labels.hide();
    this.hud.hide();
  }

  /**
   * @param {number} tick
   * @param {Path | undefined} path
   */
  draw(tick, path) {
    this.dirty = false;
    if (!this.level()) {
      this.blank();
      return;
    }
    this.stage.showTick(path, tick, this.ghost());
    this.comparison.update(tick);
    this.stage.render();
    this.firstDrawn ??= performance.now();
    this.labels.update(
      this.stage.rig.camera,
      this.stage.width,
      this.stage.height,
      this.store.state.labels && this.store.state.regions,
    );
    this.hud.show(path, tick, this.playback.rateOf(), this.stage.rig.now.yaw);
    this.film.drawn();
    clearTimeout(this.saving);
    this.saving = setTimeout(
      () =>
        writeFragment(this.report, this.store.state, this.playback.rateOf(), this.stage.rig.save()),
      300,
    );
  }
}
