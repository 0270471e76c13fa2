// Applies filters, sorting and colours to the list and the picture of trajectories.
import { Vector3 } from 'three';
import { boxOf, isAttempt, listed, UNFILTERED } from './choice.js';
import { coloring } from './coloring.js';
import { deathLabels } from './death_labels.js';
import { searched, visits } from './scene/heat_view.js';
import { RULER_COLOR } from './scene/ruler_view.js';

/** @import {App} from './app.js' */
/** @import {Coloring, Filters} from './types/report.js' */

const kMaxDeaths = 6; // max labels of deaths
const kBox = [10, 10, 10]; // studs; default size of a box
/** @type {Coloring} */
const kNoColoring = { of: () => '', legend: [] };

export class Trajectories {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.store = app.store;
    this.coloring = kNoColoring;
  }

  color() {
    const query = this.app.query();
    this.coloring = query
      ? coloring(query, this.app.level(), this.store.state.colorBy)
      : kNoColoring;
  }

  choose() {
    const { app, store } = this;
    const query = app.query();
    store.set({ order: query ? listed(query, store.state, app.playback.rateOf()) : [] });
  }

  show() {
    const { order, isolate, attempts } = this.store.state;
    const query = this.app.query();
    if (!query) return;
    const drawn = order.filter((index) => attempts || !isAttempt(query.paths[index]));
    this.app.stage.showPaths(new Set(isolate ? [] : drawn), this.coloring);
  }

  // Sets the labels: regions, the proof's step, and the killers of the shown trajectories.
  label() {
    const { stage, labels } = this.app;
    const measure = this.app.ruler?.label();
    const ofRuler = measure
      ? [{ ...measure, at: new Vector3(...measure.at), color: RULER_COLOR }]
      : [];
    const query = this.app.query();
    if (!query) {
      labels.set(ofRuler);
      return;
    }
    const { order, attempts, markers, cut, isolate } = this.store.state;
    const isShown = attempts && markers && !isolate;
    const shown = isShown ? order.map((index) => query.paths[index]) : [];
    const deaths = deathLabels(shown, this.app.level(), kMaxDeaths).map((label) => ({
      ...label,
      at: new Vector3(...label.at),
    }));
    const { regionView, cutView } = stage;
    if (cutView) cutView.group.visible = cut;
    const ofCut = (cut && cutView?.labels) || [];
    labels.set([...(regionView?.labels ?? []), ...ofCut, ...deaths, ...ofRuler]);
  }

  // Updates the heat map. Counting takes a while, so it runs only while the map is shown.
  warm() {
    const { heat, heatTrajectories, order } = this.store.state;
    const query = this.app.query();
    if (!query) return;
    const { paths, result } = query;
    const map = heatTrajectories ? null : result?.heatMap;
    const view = this.app.stage.heat;
    if (!heat) view.clear();
    else view.set(map ? searched(map) : visits(order.map((i) => paths[i])));
    this.store.set({ heatMax: view.max });
  }

  // Adds a box around the player, or else around the camera's target.
  addBox() {
    const path = this.app.path();
    const { target } = this.app.stage.rig.goal;
    const { x, y, z } = path ? path.poseAt(this.store.state.tick) : target;
    const low = [x - kBox[0] / 2, y - 2, z - kBox[2] / 2];
    const box = boxOf(
      low,
      low.map((v, k) => v + kBox[k]),
    );
    this.store.set({ boxes: [...this.store.state.boxes, box] });
  }

  bind() {
    const { app, store } = this;
    const filters = /** @type {(keyof Filters)[]} */ (Object.keys(UNFILTERED));
    store.on([...filters, 'sort', 'descending'], () => this.choose());
    store.on(['order', 'isolate', 'colorBy', 'attempts'], () => this.show());
    // A filter for failures asks for them.
    store.on(['outcome', 'killer'], ({ outcome, killer }) => {
      if (killer >= 0 || (outcome && outcome !== 'goal')) store.set({ attempts: true });
    });
    store.on(['order', 'isolate', 'cut', 'attempts', 'markers'], () => this.label());
    store.on(['order', 'heat', 'heatTrajectories'], () => this.warm());
    store.on(['path', 'ghost'], () => app.stage.pathView?.compare(app.ghost()));
    store.on(['colorBy'], () => app.stage.pathView?.select(app.path()));
    store.on(['boxes'], ({ boxes }) => app.stage.filterBoxes.set(boxes));
    store.on(['frame'], ({ frame }) => {
      if (frame < 0) return;
      app.views.part(frame);
      store.set({ frame: -1, follow: false });
    });
  }
}
