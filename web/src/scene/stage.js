// The 3D stage with level, regions, trajectories, player, light and ground. It is redrawn on
// changes only.
import { Box3, Fog, GridHelper, PCFShadowMap, Scene, Vector3, WebGLRenderer } from 'three';
import { ActionMarks } from './action_marks.js';
import { Avatar } from './avatar.js';
import { CameraRig } from './camera_rig.js';
import { CutView } from './cut_view.js';
import { dispose, Leaving } from './dispose.js';
import { extentOf } from './extent.js';
import { FilterBoxes } from './filter_boxes.js';
import { HeatView } from './heat_view.js';
import { Latest } from './latest.js';
import { LevelView } from './level_view.js';
import { Markers } from './markers.js';
import { pathsOfMotion } from './motion_paths.js';
import { noPicture } from './no_picture.js';
import { PathView } from './path_view.js';
import { RegionView } from './regions.js';
import { RulerView } from './ruler_view.js';
import { Solids } from './solids.js';
import { Sun } from './sun.js';
import { goneAtRest } from './vanishing.js';

/** @import {Group} from 'three' */
/** @import {Path} from '../path.js' */
/** @import {ColorMode, Coloring, Level, Query, Tint} from '../types/report.js' */
/** @import {Renderer} from './no_picture.js' */

const kHaze = '#141821';
const kAirborne = 1; // bit of a sample's state
const kMaxShadowed = 4000; // max parts of a level with shadows

/**
 * The renderer logs missing features to the console itself.
 * @param {HTMLCanvasElement} canvas
 * @returns {WebGLRenderer | Renderer}
 */
function rendererOf(canvas) {
  try {
    return new WebGLRenderer({
      canvas,
      antialias: true,
      alpha: true,
      preserveDrawingBuffer: true,
    });
  } catch {
    return noPicture(canvas);
  }
}

export class Stage {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = rendererOf(canvas);
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene = new Scene();
    this.renderer.setClearAlpha(0); // the page's gradient shows through
    this.rig = new CameraRig(canvas);
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false; // a camera move does not change shadows
    this.sun = new Sun(this.scene);
    // Bounds of the level. The initial box must not be empty: the camera's position would become
    // NaN.
    this.bounds = new Box3(new Vector3(-4, -4, -4), new Vector3(4, 4, 4));
    this.filterBoxes = new FilterBoxes();
    this.heat = new HeatView();
    this.marks = new ActionMarks();
    this.rulerView = new RulerView();
    this.gone = new Latest((solid) => solid !== 0);
    this.starts = new Latest((start) => start < 0);
    this.scene.add(this.filterBoxes.group, this.heat.group, this.marks.group, this.rulerView.group);
    this.leaving = new Leaving(this.scene);
    this.width = 0; // pixels
    this.height = 0;
    /** @type {Set<number>} */
    this.shown = new Set(); // indices of the drawn trajectories
    /** @type {Level | undefined} */
    this.level = undefined;
    /** @type {LevelView | undefined} */
    this.levelView = undefined;
    /** @type {Solids | undefined} */
    this.solids = undefined;
    /** @type {Avatar | undefined} */
    this.avatar = undefined;
    /** @type {Avatar | undefined} */
    this.ghost = undefined;
    /** @type {GridHelper | undefined} */
    this.grid = undefined;
    /** @type {Group | undefined} */
    this.motionPaths = undefined;
    /** @type {Query | undefined} */
    this.query = undefined;
    /** @type {Tint | undefined} */
    this.tint = undefined;
    /** @type {RegionView | undefined} */
    this.regionView = undefined;
    /** @type {CutView | undefined} */
    this.cutView = undefined;
    /** @type {PathView | undefined} */
    this.pathView = undefined;
    /** @type {Markers | undefined} */
    this.markers = undefined;
    /** @type {unknown[] | undefined} */
    this.cast = undefined; // the state that the shadows show
  }

  // Returns the nodes that are replaced with the level.
  ofLevel() {
    const { levelView, avatar, ghost, grid, motionPaths } = this;
    return [levelView?.group, avatar?.group, ghost?.group, grid, motionPaths].filter(
      (node) => node !== undefined,
    );
  }

  // Returns the views that are replaced with the query.
  ofQuery() {
    const { regionView, cutView, pathView, markers } = this;
    return [regionView, cutView, pathView, markers].filter((view) => view !== undefined);
  }

  /**
   * `colors`: as in LevelView.
   * @param {Level} level
   * @param {ColorMode} colors
   */
  setLevel(level, colors) {
    for (const node of this.ofLevel()) this.leaving.take(node, () => dispose(node));
    this.level = level;
    this.solids = new Solids(level);
    this.levelView = new LevelView(level, colors, this.solids);
    this.avatar = new Avatar(level.body);
    this.avatar.group.visible = false;
    this.ghost = new Avatar(level.body, true);
    this.ghost.group.visible = false;
    this.renderer.shadowMap.enabled = level.count <= kMaxShadowed;
    this.avatar.group.traverse((node) => {
      node.castShadow = true;
    });
    const { bounds, centre, radius } = extentOf(level);
    this.bounds = bounds;
    const size = Math.max(64, Math.ceil(radius / 32) * 128);
    this.grid = new GridHelper(size, Math.min(200, size / 8), '#262c38', '#1a1f28');
    this.grid.position.set(centre.x, bounds.min.y - 4, centre.z);
    this.scene.fog = new Fog(kHaze, radius * 4, radius * 14);
    this.motionPaths = pathsOfMotion(level);
    this.scene.add(...this.ofLevel());
  }

  /** @param {Query} query */
  setQuery(query) {
    for (const view of this.ofQuery()) this.leaving.take(view.group, () => view.dispose());
    this.query = query;
    this.tint = undefined; // for new lines
    this.regionView = new RegionView(query);
    this.cutView = new CutView(query, this.level);
    this.pathView = new PathView(query);
    this.markers = new Markers(query, this.renderer.getPixelRatio());
    for (const view of this.ofQuery()) this.scene.add(view.group);
  }

  /**
   * `shown`: set of indices.
   * @param {Set<number>} shown
   * @param {Coloring} coloring
   */
  showPaths(shown, { of: tint, along }) {
    this.shown = shown;
    for (const view of [this.pathView, this.markers]) {
      if (tint !== this.tint) view?.setColors(tint, along); // otherwise already set
      view?.setShown(shown);
    }
    this.tint = tint;
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement ?? this.canvas;
    // The size is 0 while the page is hidden, for example in a frame that opens later, and
    // framing would fail.
    if (!clientWidth || !clientHeight) return;
    if (this.width === clientWidth && this.height === clientHeight) return;
    [this.width, this.height] = [clientWidth, clientHeight];
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.rig.resize(clientWidth, clientHeight);
  }

  /**
   * Updates the shadows if anything that casts them may have moved.
   * @param {unknown[]} posed
   */
  castShadows(...posed) {
    if (this.cast?.every((value, i) => value === posed[i])) return;
    this.cast = posed;
    this.renderer.shadowMap.needsUpdate = true;
  }

  /**
   * `other`: the ghost of a comparison. It runs from its own start and stays at its end.
   * @param {Path | undefined} path
   * @param {number} tick
   * @param {Path | undefined} other
   */
  showTick(path, tick, other) {
    this.castShadows(path, tick, other, this.level, this.query);
    const clock = (path?.startTick ?? this.query?.startTick ?? 0) + tick;
    const moved = path ? this.movedAt(path, tick) : new Map();
    const { levelView } = this;
    if (levelView) {
      const gone = path ? this.gone.at(path.events, tick) : goneAtRest(levelView.level);
      levelView.update(clock, gone, moved);
      levelView.updateBodies(path?.bodies ?? [], tick);
    }
    this.markers?.update(tick);
    this.poseAvatar(this.avatar, path, tick);
    this.poseAvatar(this.ghost, other, Math.min(tick, other?.ticks ?? 0));
    if (path) this.pathView?.play(path, tick);
  }

  /**
   * @param {Avatar | undefined} avatar
   * @param {Path | undefined} path
   * @param {number} tick
   */
  poseAvatar(avatar, path, tick) {
    if (!avatar || !this.level) return;
    avatar.group.visible = Boolean(path) && !(avatar === this.avatar && this.rig.inside);
    if (!path) return;
    const pose = path.poseAt(tick);
    const speed = Math.hypot(pose.perTick[0], pose.perTick[2]) * this.level.tickRate;
    avatar.pose(pose, speed, (pose.state & kAirborne) !== 0, path.travelled(tick));
  }

  /**
   * @param {Path} path
   * @param {number} tick
   */
  movedAt(path, tick) {
    const starts = this.starts.at(path.motions, tick);
    return new Map([...starts].map(([part, start]) => [part, tick - start]));
  }

  blank() {
    this.renderer.clear();
    this.leaving.free();
    this.pathView?.sweep();
  }

  render() {
    this.renderer.render(this.scene, this.rig.camera);
    this.leaving.drawn();
    this.pathView?.sweep();
  }
}
