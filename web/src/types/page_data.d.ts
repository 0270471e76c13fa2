// The JSON of the page and of the live page's responses (lib/view/page_*.cpp, live_data.cpp).
// docs/page-data.md describes each field. `Base64<T>`: the values of a T, little-endian.
import type { ROLE_STYLE } from '../palette.js';

export type Base64<T> = string & { readonly of?: T };
export type Triple = [number, number, number];
export type Quadruple = [number, number, number, number];
export type Count = string; // 64 bits

export type Shape = 'block' | 'ball' | 'cylinder' | 'wedge' | 'cornerWedge' | 'truss' | 'hull';
export type Role = keyof typeof ROLE_STYLE;
export type Outcome =
  | 'goal'
  | 'killed'
  | 'fell'
  | 'avoided'
  | 'jumps'
  | 'timeout'
  | 'hurt'
  | 'forbidden'
  | 'running';
export type Verdict = 'solved' | 'unreachable' | 'unknown';
export type Band = 'trivial' | 'easy' | 'medium' | 'hard' | 'extreme' | 'unknown';
export type Kind = 'solution' | 'attempt' | 'closest' | 'newest';

export interface Region {
  name: string;
  position: Triple;
  rotation: Quadruple;
  size: Triple;
}

export interface Body {
  width: number;
  depth: number;
  hip: number;
  neck: number;
  top: number;
  span: number;
}

export interface PartColumns {
  count: number;
  position: Base64<Float32Array>;
  rotation: Base64<Float32Array>;
  size: Base64<Float32Array>;
  shape: Base64<Uint8Array>;
  role: Base64<Uint8Array>;
  look: Base64<Uint8Array>;
  flags: Base64<Uint8Array>;
  material: Base64<Uint8Array>;
  materials?: string[];
}

export interface TrackData {
  part: number;
  stride: number;
  count: number;
  loopFrom: number;
  triggered?: 1;
  position?: Base64<Float32Array>;
  rotation?: Base64<Int16Array>;
}

export interface BodyTrackData {
  part: number;
  ticks: Base64<Uint32Array>;
  position: Base64<Float32Array>;
  rotation: Base64<Int16Array>;
}

export interface HullData {
  part: number;
  pieces: Base64<Float32Array>[];
}

interface VanishBase {
  part: number;
  inverted?: 1;
}
export interface TimedVanish extends VanishBase {
  trigger: 'timer';
  delay: number;
  away: number;
  phase: number;
}
export interface TouchVanish extends VanishBase {
  trigger: 'touch';
}
export type Vanish = TimedVanish | TouchVanish;

export interface LevelFacts {
  name: string;
  file: string;
  tickRate: number;
  fallHeight: number;
  body: Body;
  names: string[];
  notes: Record<number, string[] | undefined>; // by part
  tags?: Record<number, string[] | undefined>; // by part
  vanish: Vanish[];
  conveyors: { part: number; velocity: Triple }[];
  bodies: number[];
}

export interface LevelData extends LevelFacts {
  parts: PartColumns;
  tracks: TrackData[];
  hulls: HullData[];
}

export interface Cut {
  reached: number[];
  from: number;
  to: number;
  rise: number;
  gap: number;
  jumps: number;
  seconds: number;
}

export interface HeatMapData {
  size: number;
  feet: Base64<Float32Array>;
  counts: Base64<Uint32Array>;
}

export interface End {
  outcome: Outcome;
  part: number;
  avoid: number;
  count: Count;
}

export interface ResultRoute {
  route: number[];
  count: Count;
  ticks: number;
}

// The effort of a search.
export interface Effort {
  seconds: number;
  steps: Count;
  cells: Count;
  rounds: Count;
  closest: number;
}

export interface Progress extends Effort {
  waypoints: number;
}

export interface ResultFacts extends Effort {
  verdict: Verdict;
  holds?: boolean;
  reason: string;
  solutions: number;
  ticks: number;
  jumps: number;
  firstSolution: number;
  stepsPerSecond: number;
  method: string;
  seed: Count;
  ends: End[];
  relaxations?: { text: string; part: number; avoid: number }[];
  routes?: ResultRoute[];
  cut?: Cut;
  evidence?: { saturation: string; newCellChance: number };
}

export interface ResultData extends ResultFacts {
  heatMap?: HeatMapData;
}

// A query without its answer and trajectories.
export interface QueryBase {
  id: string;
  title?: string;
  level: number;
  start: Region | null;
  startPosition: Triple | null;
  startTick: number;
  goal: Region | null;
  goals: Region[];
  visits: Region[];
  waypoints: { region: Region; maxJumps: number }[];
  avoid: Region[];
  maxJumps: number;
  minJumps: number;
  timeLimit: number;
  maxDamage: number;
  forbid: string[];
  progress?: Progress;
}

export interface QueryFacts extends QueryBase {
  result: ResultData | null;
}

export interface QueryData extends QueryFacts {
  trajectories: PathData[];
}

export interface HardestStep {
  startTick: number;
  ticks: number;
  from: number;
  to: number;
  jumps: number;
  band: Band;
  window: number;
}

// What a step does not have is left out: a jump, a landing, a part that kills nearby.
export interface DifficultyStep {
  startTick: number;
  ticks: number;
  window?: number;
  margin?: number;
  clearance?: number;
}

export interface Difficulty {
  band: Band;
  success: number;
  expectedAttempts: number;
  noise: string;
  steps: DifficultyStep[];
  hardest: HardestStep;
}

// [tick, part, new value]
export type PartEvent = Triple;

export interface PathFacts {
  kind: Kind;
  provisional?: boolean; // a first solution that the search still improves
  index: number;
  method: string;
  body?: string;
  frameRate?: number;
  outcome: Outcome;
  part: number;
  avoid: number;
  route: number[];
  ticks: number;
  jumps: number;
  startTick: number;
  stride: number;
  mismatch?: string;
  difficulty?: Difficulty;
  jumpTicks: number[];
  events: PartEvent[];
  motions: PartEvent[];
}

export interface PathData extends PathFacts {
  position: Base64<Float32Array>;
  yaw: Base64<Uint16Array>;
  state: Base64<Uint8Array>;
  runs: Base64<Uint16Array>;
  bodies?: BodyTrackData[];
}

export interface PageData {
  format: number;
  generator: string;
  title: string;
  notes: string[];
  levels: LevelData[];
  queries: QueryData[];
}

// Stands in for PageData in a live page, which fetches its data from the server.
export interface LiveData {
  format: number;
  live: true;
}

export type StreamState = 'live' | 'ended' | 'broken';

// New trajectories of a query. `serials`: ranges [first, last] of all its current trajectories.
export interface LiveQuery {
  index: number;
  facts: QueryFacts;
  serials: [number, number][];
  trajectories: { serial: number; data: PathData }[];
}

// A response of /data.
export interface LivePiece {
  format: number;
  revision: number;
  generator: string;
  head: { state: StreamState; title: string; notes: string[] };
  levels: { index: number; data: LevelData }[];
  queries: LiveQuery[];
}
