// A synthetic report for the page's tests: every shape, role and outcome, and hand-drawn
// trajectories. Nothing in it comes from the simulator.

import { ROLES as roles, SHAPES as shapes } from '../../web/src/data.js';
import { bar, glass, lava, lift, parts } from './sample_parts.mjs';

const encode = (array) => Buffer.from(array.buffer).toString('base64');
const f32 = (values) => encode(Float32Array.from(values));

const corners = [
  [0, 0.5, 0],
  [0, 1.5, -11],
  [0, 2.5, -19],
  [0, 3.5, -27],
  [0, 5, -37],
  [0, 4.5, -44],
  [18, 4.5, -44],
  [26, 6, -52],
  [26, 5.5, -66],
  [26, 5.5, -75],
  [26, 12.5, -84],
  [26, 12.5, -92],
  [26, 14.5, -102],
];

// Returns a trajectory that hops from corner to corner. `stop`: the trajectory ends after this
// share of the corners; `drift`: studs by which it swings sideways.
function trajectory(
  kind,
  index,
  outcome,
  { stop = 1, drift = 0, seed = 0, killer = -1, mismatch, route = [], method = 'auto' } = {},
) {
  const points = [];
  const yaw = [];
  const state = [];
  const runs = [];
  const last = Math.floor((corners.length - 1) * 45 * stop);
  const phase = seed * 1.7;
  for (let i = 0; i <= last; i++) {
    const from = Math.min(corners.length - 2, Math.floor(i / 45));
    const t = i / 45 - from;
    const [a, b] = [corners[from], corners[from + 1]];
    const far = Math.min(1, (i / (last + 1)) ** 2 * 3);
    const side = drift * far * Math.sin(i / 60 + phase);
    let y = a[1] + (b[1] - a[1]) * t + (from === 5 ? 0 : 9 * t * (1 - t));
    if (outcome === 'fell' && i > last - 40) y -= ((i - last + 40) / 40) ** 2 * 22;
    points.push(
      a[0] + (b[0] - a[0]) * t + side,
      y,
      a[2] + (b[2] - a[2]) * t + side * 0.3 * Math.cos(phase),
    );
    const angle = Math.atan2(-(b[0] - a[0]), -(b[2] - a[2])) / (2 * Math.PI);
    yaw.push(((Math.round(angle * 65536) % 65536) + 65536) % 65536);
    state.push(from === 5 ? 0 : 1);
  }
  for (let from = 0; from * 45 < last; from++) {
    const heading = yaw[Math.min(last, from * 45 + 1)];
    runs.push(
      Math.min(12, last - from * 45),
      from === 5 ? 1 : 3,
      heading,
      Math.max(0, Math.min(33, last - from * 45 - 12)),
      1,
      heading,
    );
  }
  return {
    method,
    kind,
    index,
    outcome,
    part: killer,
    avoid: -1,
    route,
    ticks: last,
    jumps: Math.ceil(last / 45),
    waypoints: 0,
    startTick: 0,
    stride: 1,
    position: f32(points),
    yaw: encode(Uint16Array.from(yaw)),
    state: encode(Uint8Array.from(state)),
    jumpTicks: Array.from({ length: Math.ceil(last / 45) }, (_, from) => from * 45),
    runs: encode(Uint16Array.from(runs)),
    motions: [],
    events:
      kind === 'solution'
        ? [
            [470, glass, 0],
            [520, glass, 1],
          ]
        : [],
    mismatch,
  };
}

const attempts = [];
for (let i = 0; i < 60; i++) {
  const outcome = ['fell', 'killed', 'fell', 'running', 'timeout', 'fell', 'avoided', 'jumps'][
    i % 8
  ];
  attempts.push(
    trajectory('attempt', i, outcome, {
      stop: 0.12 + (0.8 * ((i * 37) % 60)) / 60,
      drift: 2 + (i % 7),
      seed: i,
      killer: outcome === 'killed' ? (i % 16 === 1 ? lava : bar) : -1,
    }),
  );
}

const liftTrack = Array.from({ length: 240 }, (_, t) => [
  5 * Math.sin((t / 240) * 2 * Math.PI),
  3,
  -27,
]).flat();
const spin = Array.from({ length: 180 }, (_, t) => {
  const half = (t / 180) * Math.PI;
  return [0, Math.round(Math.sin(half) * 32767), 0, Math.round(Math.cos(half) * 32767)];
}).flat();
const crystal = [-2, -3, -2, 2, -3, -2, 2, -3, 2, -2, -3, 2, 0, 3, 0, -2.4, 0, 0, 2.4, 0, 0];

const materials = [...new Set(['', ...parts.map((p) => p.material)])];

const level = {
  name: 'Sample',
  file: 'sample.rbxlx',
  tickRate: 60,
  gravity: 196.2,
  walkSpeed: 16,
  fallHeight: -500,
  body: { width: 2, depth: 1, hip: 2, neck: 4, top: 5, span: 4 },
  parts: {
    count: parts.length,
    position: f32(parts.flatMap((p) => p.position)),
    rotation: f32(parts.flatMap((p) => p.rotation)),
    size: f32(parts.flatMap((p) => p.size)),
    shape: encode(Uint8Array.from(parts, (p) => shapes.indexOf(p.shape))),
    role: encode(Uint8Array.from(parts, (p) => roles.indexOf(p.role))),
    look: encode(Uint8Array.from(parts.flatMap((p) => [...p.color, p.alpha]))),
    flags: encode(Uint8Array.from(parts, (p) => (p.role === 'ghost' ? 2 : 3))),
    material: encode(Uint8Array.from(parts, (p) => materials.indexOf(p.material))),
    materials,
  },
  names: parts.map((p) => `Workspace/Course/${p.name}`),
  notes: {
    [lava]: ['kill: script KillScript line 3: Health = 0'],
    [glass]: ['vanish: name (guessed)'],
  },
  hulls: [{ part: parts.findIndex((p) => p.shape === 'hull'), pieces: [f32(crystal)] }],
  tracks: [
    { part: lift, stride: 1, count: 240, loopFrom: 0, position: f32(liftTrack) },
    { part: bar, stride: 1, count: 180, loopFrom: 0, rotation: encode(Int16Array.from(spin)) },
  ],
  vanish: [{ part: glass, trigger: 'touch' }],
  conveyors: [{ part: parts.findIndex((p) => p.role === 'conveyor'), velocity: [12, 0, 0] }],
};

const region = (name, position, size) => ({ name, position, rotation: [0, 0, 0, 1], size });
const base = {
  level: 0,
  start: null,
  startPosition: [0, 0.5, 0],
  goal: region('Goal', [26, 17, -102], [8, 5, 8]),
  goals: [],
  visits: [],
  waypoints: [],
  avoid: [],
  minJumps: 0,
  maxJumps: -1,
  timeLimit: 0,
  maxDamage: -1,
  forbid: [],
};
const result = {
  verdict: 'solved',
  reason: 'A playthrough was found and replayed.',
  solutions: 2,
  ticks: 540,
  jumps: 12,
  steps: '8412334',
  cells: '19321',
  rounds: '210',
  closest: 0,
  seconds: 1.92,
  firstSolution: 0.41,
  stepsPerSecond: 4381423,
  method: 'go-explore',
  seed: '1',
  routes: [
    { route: [0, 1, 2, 6], count: '3', ticks: 540 },
    { route: [0, 6], count: '1', ticks: 544 },
  ],
  heatMap: {
    size: 4,
    feet: encode(new Float32Array([1, 2, 3, -3, 2, 3, 1, 2, -9])),
    counts: encode(new Uint32Array([7, 90, 1])),
  },
  ends: [
    { outcome: 'fell', part: -1, count: '61234' },
    { outcome: 'killed', part: lava, count: '20311' },
    { outcome: 'killed', part: bar, count: '912' },
    { outcome: 'running', part: -1, count: '15002' },
    { outcome: 'timeout', part: -1, count: '310' },
  ],
};

const difficulty = {
  band: 'hard',
  success: 0.42,
  expectedAttempts: 2.4,
  noise: 'average player',
  steps: [
    { startTick: 0, ticks: 60, margin: 1.5 },
    { startTick: 60, ticks: 30, clearance: 0.25, margin: 2.5 },
    { startTick: 90, ticks: 45, window: 83.3, margin: -0.2 },
    { startTick: 135, ticks: 1000 },
  ],
  hardest: { startTick: 90, ticks: 45, from: 2, to: 4, jumps: 1, band: 'hard', window: 83.3 },
};

export const report = {
  format: 4,
  generator: 'sample',
  title: 'Sample course',
  notes: [],
  levels: [level],
  queries: [
    {
      ...base,
      id: 'whole course',
      waypoints: [{ region: region('Belt', [12, 7, -44], [12, 5, 5]), maxJumps: 6 }],
      avoid: [region('No shortcut', [6, 8, -60], [8, 8, 20])],
      result,
      trajectories: [
        { ...trajectory('solution', 0, 'goal', { route: [0, 1, 2, 6] }), difficulty },
        trajectory('solution', 1, 'goal', { drift: 1.2, seed: 5, route: [0, 6], method: 'ge' }),
        ...attempts,
      ],
    },
    {
      ...base,
      id: 'without jumping',
      maxJumps: 0,
      result: {
        ...result,
        verdict: 'unreachable',
        reason: 'The goal is 14 studs up and no jump is allowed.',
        closest: 96.2,
        solutions: 0,
        cut: { reached: [0, 1, 2], from: 2, to: 6, rise: 1.5, gap: 0, jumps: 0, seconds: 0 },
        relaxations: [
          { text: 'solvable with 12 jumps instead of 0', part: -1, avoid: -1 },
          { text: 'solvable without Lava', part: lava, avoid: -1 },
        ],
      },
      trajectories: attempts.slice(0, 6),
    },
    {
      ...base,
      id: 'in eight seconds',
      timeLimit: 8,
      result: {
        ...result,
        verdict: 'unknown',
        reason: 'The time budget was spent.',
        closest: 21.4,
        solutions: 0,
      },
      trajectories: attempts.slice(6, 30),
    },
    {
      ...base,
      id: 'old recording',
      result,
      trajectories: [trajectory('solution', 0, 'goal', { mismatch: 'the last state differs' })],
    },
  ],
};
