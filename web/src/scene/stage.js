// The 3D stage with level, regions, trajectories, player, light and ground. It is redrawn on
// changes only.
import {
  Box3,
  DirectionalLight,
  Fog,
  GridHelper,
  HemisphereLight,
  PCFShadowMap,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { ActionMarks } from './action_marks.js';
import { Avatar } from './avatar.js';
import { CameraRig } from './camera_rig.js';
import { CutView } from './cut_view.js';
import { dispose, Leaving } from './dispose.js';
import { FilterBoxes } from './filter_boxes.js';
import { HeatView } from './heat_view.js';
import { Latest } from './latest.js';
import { LevelView } from './level_view.js';
import { Markers } from './markers.js';
import { pathsOfMotion } from './motion_paths.js';
import { noPicture } from './no_picture.js';
import { PathView } from './path_view.js';
import { pickPart, pickPath, pointAtHeight, pointOnParts } from './picking.js';
import { RegionView } from './regions.js';

const kHaze = '#141821';
const kPanelWidth = 210; // pixels on the right that the legend covers
const kAirborne = 1; // bit of a sample's state
const kMostShadowed = 4000; // parts; larger levels have no shadows
const kSun = new Vector3(0.42, 1, 0.28);

// The renderer logs missing features to the console itself.
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
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = rendererOf(canvas);
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene = new Scene();
    this.renderer.setClearAlpha(0); // the page's gradient shows through
    this.rig = new CameraRig(canvas);
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false; // a camera move does not change shadows
    this.sun = new DirectionalLight('#fff4e0', 2.2);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.bias = -0.0006;
    this.sun.shadow.normalBias = 0.06;
    const rim = new DirectionalLight('#8fb0ff', 0.7);
    rim.position.set(-0.6, 0.35, -0.7);
    this.scene.add(new HemisphereLight('#dfe8ff', '#2a2c36', 1.15), this.sun, this.sun.target, rim);
    // Bounds of the level. The initial box is not empty, or the camera's position would become NaN.
    this.bounds = new Box3(new Vector3(-4, -4, -4), new Vector3(4, 4, 4));
    this.filterBoxes = new FilterBoxes();
    this.heat = new HeatView();
    this.marks = new ActionMarks();
    this.gone = new Latest((solid) => solid);
    this.starts = new Latest((start) => start < 0);
    this.scene.add(this.filterBoxes.group, this.heat.group, this.marks.group);
    this.leaving = new Leaving(this.scene);
  }

  // The nodes that are replaced with the level.
  ofLevel() {
    const { levelView, avatar, ghost, grid, motionPaths } = this;
    return levelView ? [levelView.group, avatar.group, ghost.group, grid, motionPaths] : [];
  }

  // `colors`: as in LevelView.
  setLevel(level, colors) {
    for (const node of this.ofLevel()) this.leaving.take(node, () => dispose(node));
    this.level = level;
    this.levelView = new LevelView(level, colors);
    this.avatar = new Avatar(level.body);
    this.avatar.group.visible = false;
    this.ghost = new Avatar(level.body, true);
    this.ghost.group.visible = false;
    this.renderer.shadowMap.enabled = level.count <= kMostShadowed;
    this.avatar.group.traverse((node) => {
      node.castShadow = true;
    });
    this.measure(level);
    const size = Math.max(64, Math.ceil(this.radius / 32) * 128);
    this.grid = new GridHelper(size, Math.min(200, size / 8), '#262c38', '#1a1f28');
    this.grid.position.set(this.centre.x, this.bounds.min.y - 4, this.centre.z);
    this.scene.fog = new Fog(kHaze, this.radius * 4, this.radius * 14);
    this.motionPaths = pathsOfMotion(level);
    this.scene.add(...this.ofLevel());
  }

  // Returns a sphere around the level that ignores a few outliers.
  measure(level) {
    const axis = (k) =>
      Float32Array.from({ length: level.count }, (_, i) => level.position[3 * i + k]).sort();
    const at = (values, share) =>
      values[Math.min(values.length - 1, Math.floor(share * values.length))] ?? 0;
    this.bounds = new Box3();
    const sorted = [0, 1, 2].map(axis);
    this.bounds.min.set(...sorted.map((values) => at(values, 0.02)));
    this.bounds.max.set(...sorted.map((values) => at(values, 0.98)));
    this.bounds.expandByScalar(4);
    this.centre = this.bounds.getCenter(new Vector3());
    this.radius = Math.max(10, this.bounds.getSize(new Vector3()).length() / 2);
  }

  setQuery(query) {
    for (const view of [this.regionView, this.cutView, this.pathView, this.markers])
      if (view) this.leaving.take(view.group, () => view.dispose());
    this.query = query;
    this.tint = null; // for new lines
    this.regionView = new RegionView(query);
    this.cutView = new CutView(query, this.level);
    this.pathView = new PathView(query);
    this.markers = new Markers(query, this.renderer.getPixelRatio());
    for (const view of [this.regionView, this.cutView, this.pathView, this.markers])
      this.scene.add(view.group);
  }

  // Returns the box of the query's regions and solutions, or else of the level.
  queryBox() {
    const box = new Box3();
    if (this.regionView) box.expandByObject(this.regionView.group);
    for (const path of this.query?.paths ?? []) {
      if (path.kind !== 'solution') continue;
      for (let i = 0; i < path.samples; i += 8)
        box.expandByPoint(new Vector3().fromArray(path.points, 3 * i));
    }
    return box.isEmpty() ? this.bounds.clone() : box.expandByScalar(3);
  }

  frameQuery(atOnce) {
    const box = this.queryBox();
    this.light(box);
    const size = box.getSize(new Vector3());
    // Looks along the shorter side, so that the level runs across the screen.
    const yaw = size.x >= size.z ? 0.55 : Math.PI / 2 - 0.55;
    this.rig.frameBox(box, { yaw, pitch: -0.52 }, atOnce);
  }

  frameTop() {
    const box = this.queryBox();
    const size = box.getSize(new Vector3());
    this.rig.frameBox(box, { yaw: size.x >= size.z ? 0 : Math.PI / 2, pitch: -1.549 });
  }

  // The shadow map covers the query's box instead of the whole level, so that it stays sharp.
  light(box) {
    const centre = box.getCenter(new Vector3());
    const reach = Math.max(20, (box.getSize(new Vector3()).length() / 2) * 1.25);
    this.sun.target.position.copy(centre);
    this.sun.position.copy(centre).addScaledVector(kSun, reach * 2);
    const eye = this.sun.shadow.camera;
    [eye.left, eye.right, eye.bottom, eye.top, eye.near, eye.far] = [
      -reach,
      reach,
      -reach,
      reach,
      0.1,
      reach * 5,
    ];
    eye.updateProjectionMatrix();
  }

  // `shown`: set of indices; `tint`: path -> colour.
  showPaths(shown, tint) {
    this.shown = shown;
    const views = [this.pathView, this.markers].filter(Boolean);
    for (const view of views) {
      if (tint !== this.tint) view.setColors(tint); // otherwise already set
      view.setShown(shown);
    }
    this.tint = tint;
  }

  visibleOf(state) {
    return (path, index) =>
      index === state.path ||
      index === state.ghost ||
      (this.shown.has(index) && (path.kind === 'solution' ? state.solutions : state.attempts));
  }

  // Returns the point under the pointer, on a part or at the height of the camera's target.
  pointAt(x, y) {
    const { camera, goal } = this.rig;
    const size = [this.width, this.height];
    return pointOnParts(this.levelView.group, camera, ...size, [x, y], goal.target.y);
  }

  pointAtHeight(x, y, height) {
    return pointAtHeight(this.rig.camera, this.width, this.height, [x, y], height);
  }

  pick(state, x, y) {
    return pickPath(
      this.query?.paths ?? [],
      this.rig.camera,
      this.width,
      this.height,
      x,
      y,
      this.visibleOf(state),
    );
  }

  pickPart(x, y) {
    return pickPart(this.levelView.group, this.rig.camera, this.width, this.height, x, y);
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    // The size is 0 while the page is hidden, as in a frame that opens later. Framing would fail
    // then.
    if (!clientWidth || !clientHeight) return;
    if (this.width === clientWidth && this.height === clientHeight) return;
    [this.width, this.height] = [clientWidth, clientHeight];
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.rig.camera.aspect = clientWidth / Math.max(1, clientHeight);
    // The picture is centred in the area that the legend leaves free.
    const covered = clientWidth > 900 ? kPanelWidth : 0;
    this.rig.free = 1 - covered / clientWidth;
    this.rig.camera.setViewOffset(
      clientWidth,
      clientHeight,
      covered / 2,
      0,
      clientWidth,
      clientHeight,
    );
  }

  // Updates the shadows if anything that casts them may have moved.
  castShadows(...posed) {
    if (this.cast?.every((value, i) => value === posed[i])) return;
    this.cast = posed;
    this.renderer.shadowMap.needsUpdate = true;
  }

  // `other`: the ghost of a comparison. It runs from its own start and stays at its end.
  showTick(path, tick, other) {
    this.castShadows(path, tick, other, this.level, this.query);
    const clock = (path?.startTick ?? this.query?.startTick ?? 0) + tick;
    const moved = path ? this.movedAt(path, tick) : new Map();
    const gone = path ? this.gone.at(path.events, tick) : this.levelView.goneAtRest();
    this.levelView.update(clock, gone, moved);
    this.levelView.updateLoose(path?.loose ?? [], tick);
    this.markers?.update(tick);
    this.poseAvatar(this.avatar, path, tick);
    this.poseAvatar(this.ghost, other, Math.min(tick, other?.ticks ?? 0));
    if (path) this.pathView.play(path, tick);
  }

  poseAvatar(avatar, path, tick) {
    avatar.group.visible = Boolean(path);
    if (!path) return;
    const pose = path.poseAt(tick);
    const speed = Math.hypot(pose.perTick[0], pose.perTick[2]) * this.level.tickRate;
    avatar.pose(pose, speed, (pose.state & kAirborne) !== 0, path.travelled(tick));
  }

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
