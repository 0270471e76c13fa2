// Parses the report inside the page. Base64 blocks become typed arrays, and runs of actions are
// looked up by tick. docs/viewer.md describes the format.

function bytesOf(text) {
  // Newer browsers have a much faster native function.
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text || '');
  const binary = atob(text || '');
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}
const floats = (text) => new Float32Array(bytesOf(text).buffer);
const shorts = (text) => new Int16Array(bytesOf(text).buffer);
const longs = (text) => new Uint32Array(bytesOf(text).buffer);
const words = (text) => new Uint16Array(bytesOf(text).buffer);

export const SHAPES = ['block', 'ball', 'cylinder', 'wedge', 'cornerWedge', 'truss', 'hull'];
export const ROLES = [
  'plain',
  'start',
  'goal',
  'kill',
  'moving',
  'vanish',
  'conveyor',
  'pad',
  'checkpoint',
  'ghost',
  'loose',
];

// Poses of a moving part, one sample every `stride` ticks from tick 0 on. From `loopFrom` on they
// repeat (-1: the last one stays).
class Track {
  constructor(raw) {
    this.part = raw.part;
    this.stride = raw.stride;
    this.count = raw.count;
    this.loopFrom = raw.loopFrom;
    this.triggered = Boolean(raw.triggered); // ticks count from its start, which a path's motion
                                             // events tell
    this.position = raw.position ? floats(raw.position) : null;
    this.rotation = raw.rotation ? shorts(raw.rotation) : null;
  }

  // Returns the two samples around a tick, and the weight of the second.
  at(tick) {
    const s = Math.max(0, tick / this.stride);
    let i = Math.floor(s);
    const share = s - i;
    const wrap = (k) => {
      if (k < this.count) return k;
      if (this.loopFrom < 0) return this.count - 1;
      return this.loopFrom + ((k - this.loopFrom) % (this.count - this.loopFrom));
    };
    const next = wrap(i + 1);
    i = wrap(i);
    // A jump back to the first key must not be interpolated across the level.
    return { i, next: this.jumps(i, next) ? i : next, share };
  }

  jumps(i, next) {
    if (next >= i || !this.position) return false;
    const p = this.position;
    return (
      Math.hypot(
        p[3 * i] - p[3 * next],
        p[3 * i + 1] - p[3 * next + 1],
        p[3 * i + 2] - p[3 * next + 2],
      ) > 4
    );
  }
}

// Poses of a dynamic part at some ticks of a trajectory, interpolated linearly.
class LooseTrack {
  constructor(raw) {
    this.part = raw.part;
    this.ticks = longs(raw.ticks);
    this.position = floats(raw.position);
    this.rotation = shorts(raw.rotation);
  }

  // Like Track.at().
  at(tick) {
    const { ticks } = this;
    let [i, end] = [0, ticks.length - 1];
    while (end - i > 1) {
      const middle = (i + end) >> 1;
      if (ticks[middle] <= tick) i = middle;
      else end = middle;
    }
    const share = (tick - ticks[i]) / (ticks[end] - ticks[i] || 1);
    return { i, next: end, share: Math.min(1, Math.max(0, share)) };
  }
}

// Here and below, base64 texts are dropped once typed arrays replace them.
export function levelOf({ parts, tracks, hulls, ...rest }) {
  return {
    ...rest,
    count: parts.count,
    position: floats(parts.position),
    rotation: floats(parts.rotation),
    size: floats(parts.size),
    shape: bytesOf(parts.shape),
    role: bytesOf(parts.role),
    look: bytesOf(parts.look),
    flags: bytesOf(parts.flags),
    material: bytesOf(parts.material),
    materials: parts.materials ?? [''],
    tracks: tracks.map((track) => new Track(track)),
    hulls: hulls.map((hull) => ({ part: hull.part, pieces: hull.pieces.map(floats) })),
  };
}

// Returns true if parts of the level act by the level clock.
export const hasMotion = (level) =>
  Boolean(level?.tracks.length || level?.vanish.length || level?.conveyors.length);

// Returns the player's input during a tick, or nothing before the first.
function actionAt(runs, tick) {
  let end = 0;
  for (let i = 0; tick >= 0 && i + 2 < runs.length; i += 3) {
    end += runs[i];
    if (tick < end)
      return { walk: (runs[i + 1] & 1) !== 0, jump: (runs[i + 1] & 2) !== 0, heading: runs[i + 2] };
  }
  return { walk: false, jump: false, heading: 0 };
}

const looseTracks = (raw) => (raw ?? []).map((track) => new LooseTrack(track));

export class Path {
  constructor({ position, yaw, state, runs, loose, ...rest }, query) {
    Object.assign(this, rest);
    this.query = query;
    this.points = floats(position);
    this.samples = this.points.length / 3;
    this.unread = { yaw, state, runs, loose };
    this.known = {};
  }

  get yaw() {
    return this.read('yaw', words);
  }

  get state() {
    return this.read('state', bytesOf);
  }

  get runs() {
    return this.read('runs', words);
  }

  get loose() {
    return this.read('loose', looseTracks);
  }

  // The points are needed to draw all trajectories. The rest is decoded on demand, since a user
  // opens only a few of thousands.
  read(name, as) {
    const { known, unread } = this;
    if (!known[name]) {
      known[name] = as(unread[name]);
      unread[name] = null;
    }
    return known[name];
  }

  // Returns the tick of a sample: every `stride`-th, and the last one at any distance.
  tickOf(sample) {
    return Math.min(sample * this.stride, this.ticks);
  }

  // Returns the two samples around a tick, and the weight of the second.
  at(tick) {
    const last = this.samples - 1;
    const now = Math.min(Math.max(0, tick), this.ticks);
    const i = now < this.ticks ? Math.floor(now / this.stride) : last;
    const j = Math.min(i + 1, last);
    const gap = this.tickOf(j) - this.tickOf(i) || 1;
    return { i, j, share: (now - this.tickOf(i)) / gap };
  }

  // Returns the velocity before a sample, studs a tick on each axis; zero at the start.
  speedBefore(sample) {
    const from = Math.max(0, sample - 1);
    const gap = this.tickOf(sample) - this.tickOf(from) || 1;
    const p = this.points;
    return [0, 1, 2].map((k) => (p[3 * sample + k] - p[3 * from + k]) / gap);
  }

  // Returns the interpolated pose at a tick.
  poseAt(tick) {
    const { i, j, share } = this.at(tick);
    const p = this.points;
    const mix = (k) => p[3 * i + k] + (p[3 * j + k] - p[3 * i + k]) * share;
    let turn = this.yaw[j] - this.yaw[i];
    if (turn > 32768) turn -= 65536;
    if (turn < -32768) turn += 65536;
    const yaw = ((this.yaw[i] + turn * share) / 65536) * 2 * Math.PI;
    const speed = this.speedBefore(share > 1e-6 ? j : i);
    return { x: mix(0), y: mix(1), z: mix(2), yaw, state: this.state[i], perTick: speed };
  }

  // Returns the input of the tick that ends at or contains `tick`, or nothing at the start.
  actionBefore(tick) {
    return actionAt(this.runs, Math.ceil(tick - 1e-6) - 1);
  }

  // Returns the horizontal distance walked so far, studs; sums are cached.
  travelled(tick) {
    if (!this.sums) {
      this.sums = new Float32Array(this.samples);
      for (let i = 1; i < this.samples; i++) {
        const p = this.points;
        this.sums[i] =
          this.sums[i - 1] + Math.hypot(p[3 * i] - p[3 * i - 3], p[3 * i + 2] - p[3 * i - 1]);
      }
    }
    const { i, j, share } = this.at(tick);
    return this.sums[i] + (this.sums[j] - this.sums[i]) * share;
  }

  end() {
    const k = 3 * (this.samples - 1);
    return [this.points[k], this.points[k + 1], this.points[k + 2]];
  }
}

function resultOf(raw) {
  if (!raw?.heatMap) return raw;
  const { size, feet, counts } = raw.heatMap;
  return { ...raw, heatMap: { size, feet: floats(feet), counts: longs(counts) } };
}

// A query without its trajectories.
export const queryOf = (facts, index) => ({ ...facts, index, result: resultOf(facts.result) });

export function readReport(raw) {
  const levels = raw.levels.map(levelOf);
  const queries = raw.queries.map(({ trajectories, ...facts }, index) => {
    const own = queryOf(facts, index);
    own.paths = trajectories.map((path) => new Path(path, own));
    return own;
  });
  return { ...raw, levels, queries };
}
