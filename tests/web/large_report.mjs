// A synthetic report of any size: a grid of parts, and trajectories that wander over it.
import { report as sample } from './sample_report.mjs';

const encode = (array) => Buffer.from(array.buffer).toString('base64');
const kOutcomes = ['goal', 'fell', 'killed', 'fell', 'timeout'];

function levelOf(count) {
  const column = (Type, width, fill) => {
    const values = new Type(width * count);
    for (let i = 0; i < count; i++) values.set(fill(i), width * i);
    return encode(values);
  };
  return {
    ...sample.levels[0],
    name: `${count} parts`,
    parts: {
      count,
      position: column(Float32Array, 3, (i) => [(i % 50) * 6, (i * 7) % 5, Math.floor(i / 50) * 6]),
      rotation: column(Float32Array, 4, () => [0, 0, 0, 1]),
      size: column(Float32Array, 3, () => [4, 1, 4]),
      shape: column(Uint8Array, 1, (i) => [i % 10 === 3 ? 2 : 0]),
      role: column(Uint8Array, 1, (i) => [i % 50 === 1 ? 3 : 0]),
      look: column(Uint8Array, 4, (i) => [120 + (i % 90), 140, 160, 255]),
      flags: column(Uint8Array, 1, () => [3]),
    },
    names: Array.from({ length: count }, (_, i) => `Workspace/Part ${i}`),
    notes: {},
    hulls: [],
    tracks: [],
    vanish: [],
    conveyors: [],
  };
}

function trajectoryOf(index, ticks) {
  const position = new Float32Array(3 * (ticks + 1));
  const turn = 0.4 + (index % 97) / 97;
  for (let i = 0; i <= ticks; i++) {
    const far = (i * 16) / 60;
    position[3 * i] = 10 + far * Math.cos(turn * 0.9) + 3 * Math.sin(i / 40 + index);
    position[3 * i + 1] = 3 + Math.abs(6 * Math.sin(i / 25 + index));
    position[3 * i + 2] = 10 + far * Math.sin(turn * 0.9);
  }
  const outcome = kOutcomes[index % kOutcomes.length];
  return {
    kind: outcome === 'goal' ? 'solution' : 'attempt',
    index,
    outcome,
    part: outcome === 'killed' ? 1 + 50 * (index % 40) : -1,
    avoid: -1,
    route: [index % 7, index % 3],
    ticks,
    jumps: index % 13,
    startTick: 0,
    stride: 1,
    position: encode(position),
    yaw: encode(new Uint16Array(ticks + 1)),
    state: encode(new Uint8Array(ticks + 1)),
    runs: encode(Uint16Array.from([ticks, 1, 0])),
    jumpTicks: [],
    events: [],
    motions: [],
  };
}

export function largeReport(parts, count, ticks) {
  const trajectories = Array.from({ length: count }, (_, i) => trajectoryOf(i, ticks - (i % 200)));
  return {
    ...sample,
    title: `${parts} parts, ${count} trajectories`,
    levels: [levelOf(parts)],
    queries: [{ ...sample.queries[0], waypoints: [], avoid: [], trajectories }],
  };
}
