// The report as the page uses it, the page's state, and types that several files share. data.js
// makes the report, with typed arrays in place of base64.
import type { Vector3 } from 'three';
import type { Path } from '../path.js';
import type { Track } from '../tracks.js';
import type { LevelFacts, Outcome, QueryBase, ResultFacts, Triple } from './page_data.js';

export interface Level extends LevelFacts {
  count: number; // number of parts
  position: Float32Array;
  rotation: Float32Array;
  size: Float32Array;
  shape: Uint8Array;
  role: Uint8Array;
  look: Uint8Array;
  flags: Uint8Array;
  material: Uint8Array;
  materials: string[];
  tracks: Track[];
  hulls: { part: number; pieces: Float32Array[] }[];
}

export interface HeatMap {
  size: number;
  feet: Float32Array;
  counts: Uint32Array;
}

export interface Result extends ResultFacts {
  heatMap?: HeatMap;
}

export interface Query extends QueryBase {
  index: number;
  result: Result | null;
  paths: Path[];
  running?: boolean; // live: the stream is still open
}

export interface Report {
  title: string;
  notes: string[];
  levels: Level[]; // live: levels that have not arrived are undefined
  queries: Query[];
}

// The current query and level, for panels.
export interface Source {
  query: Query | undefined;
  level: Level | undefined;
}

// An axis-aligned box, studs.
export interface Box {
  min: number[];
  max: number[];
}
export interface FilterBox extends Box {
  keep: boolean; // show only trajectories that pass through the box; false: hide them
}

export interface Filters {
  outcome: Outcome | '';
  route: string;
  killer: number; // part, -1 for any
  maxJumps: number;
  maxSeconds: number;
  boxes: readonly FilterBox[];
}

export type Sort = 'found' | 'time' | 'jumps' | 'outcome' | 'difficulty' | 'route';
export type ColorBy =
  | 'outcome'
  | 'route'
  | 'method'
  | 'time'
  | 'jumps'
  | 'difficulty'
  | 'speed'
  | 'height'
  | 'margin'
  | 'window';
export type ColorMode = 'roles' | 'level';

export interface State extends Filters {
  sort: Sort;
  descending: boolean;
  order: number[]; // indices of the listed trajectories, set by trajectories.js
  colorBy: ColorBy;
  isolate: boolean; // draw only the selected trajectory
  ghost: number; // trajectory that runs next to the selected one
  frame: number; // part for the camera to frame; trajectories.js resets it
  drawing: boolean; // the next drag draws a box
  measuring: boolean; // clicks place the ruler
  ruler: readonly Triple[]; // its ends, at most two
  status: string; // a message about what the reader just did
  theme: 'auto' | 'light' | 'dark';
  heat: boolean;
  heatMax: number; // max count of a tile
  heatTrajectories: boolean; // the heat map counts trajectories even if the search has its own map
  cut: boolean;
  query: number;
  path: number;
  tick: number;
  playing: boolean;
  speed: number;
  loop: boolean;
  loopFrom: number; // range of the loop in ticks; empty: everything
  loopTo: number;
  follow: boolean;
  followNewest: boolean; // live: select each new solution
  hoverPath: number;
  part: number;
  colors: ColorMode;
  solutions: boolean;
  attempts: boolean;
  markers: boolean;
  runners: boolean;
  regions: boolean;
  labels: boolean;
  grid: boolean;
  motionPaths: boolean;
}

// Names of the state's properties whose value is a T.
export type NamesOf<T> = { [K in keyof State]: State[K] extends T ? K : never }[keyof State];

export type Tint = (path: Path) => string;

// The colour of a trajectory at a sample.
export type Along = (path: Path, sample: number) => string;

export interface Coloring {
  of: Tint;
  along?: Along; // if the colour changes along a trajectory
  legend: [label: string, color: string, swatch: 'solution' | 'attempt'][];
}

// A text over a place of the picture.
export interface Label {
  text: string;
  at: Vector3;
  color: string;
}

// [x, y, z, yaw, pitch, distance]
export type Camera = [...Triple, number, number, number];

// A moment between two samples.
export interface Between {
  i: number;
  next: number;
  share: number;
}

export interface Pose {
  x: number;
  y: number;
  z: number;
  yaw: number; // radians
  state: number;
  perTick: Triple; // studs a tick, by axis
}
