// The panels around the picture, each bound to the app's state.
import { byId, dialog } from './page.js';
import { nextTheme } from './theme.js';
import { Comparison } from './ui/comparison.js';
import { FilterPanel } from './ui/filter_panel.js';
import { Help } from './ui/help.js';
import { Hud } from './ui/hud.js';
import { PartList } from './ui/part_list.js';
import { PathList } from './ui/path_list.js';
import { ScenePanel } from './ui/scene_panel.js';
import { Sidebar } from './ui/sidebar.js';
import { Timeline } from './ui/timeline.js';
import { toolsOf } from './ui/tools.js';
import { resetSettings } from './view_settings.js';

/** @import {App} from './app.js' */
/** @import {Path} from './path.js' */
/** @import {Source, Tint} from './types/report.js' */

/**
 * Returns the selected trajectory and the ghost, or null without a ghost.
 * @param {App} app
 * @returns {[Path, Path] | null}
 */
function pairOf(app) {
  const [path, ghost] = [app.path(), app.ghost()];
  return path && ghost ? [path, ghost] : null;
}

/** @param {App} app */
export function panelsOf(app) {
  const { store, playback, report, trajectories } = app;
  /** @returns {Source} */
  const source = () => ({ query: app.query(), level: app.level() });
  /** @type {Tint} */
  const tint = (path) => trajectories.coloring.of(path);
  const list = new PathList(store, source, tint);
  const filters = new FilterPanel(store, source, () => trajectories.addBox());
  const sidebar = new Sidebar(byId('side'), report, store, [filters.root, list.root]);
  const comparison = new Comparison(byId('comparison'), store, () => pairOf(app), source, tint);
  const timeline = new Timeline(byId('timeline'), store, playback, () => app.path());
  const scenePanel = new ScenePanel(byId('scene-panel'), store, {
    queryOf: () => app.query(),
    levelOf: () => app.level(),
    coloringOf: () => trajectories.coloring,
    parts: new PartList(store, () => app.level()),
    tools: toolsOf(app),
  });
  const hud = new Hud(byId('hud'));
  const help = new Help(dialog(), () => resetSettings(app));
  timeline.addButton('◐', 'Switch between light and dark (Y)', () => nextTheme(store));
  timeline.addButton('?', 'Shortcuts (?)', () => help.toggle());
  return { list, filters, sidebar, comparison, timeline, scenePanel, hud, help };
}
