// Two trajectories side by side: their numbers, when they passed what the query names, and how far apart they are now.
import { Quaternion, Vector3 } from 'three';
import { causeOf, GHOST_COLOR } from '../palette.js';
import { el, keepingFocus, seconds } from './dom.js';

// Studs walked, flown and fallen.
function lengthOf({ points, samples }) {
  let sum = 0;
  for (let i = 3; i < 3 * samples; i += 3)
    sum += Math.hypot(
      points[i] - points[i - 3],
      points[i + 1] - points[i - 2],
      points[i + 2] - points[i - 1],
    );
  return sum;
}

// [name, region] of the places that a query wants passed, in order.
function placesOf(query) {
  const waypoints = (query?.waypoints ?? []).map(({ region }) => region);
  return [...waypoints, ...(query?.visits ?? [])].map((region, i) => [
    region.name || `Waypoint ${i + 1}`,
    region,
  ]);
}

// First tick at which the middle of the player is in an oriented box; -1 for never.
function tickAt(path, region, height) {
  const turn = new Quaternion().fromArray(region.rotation).normalize().invert();
  const middle = new Vector3().fromArray(region.position);
  const at = new Vector3();
  for (let i = 0; i < path.samples; i++) {
    at.fromArray(path.points, 3 * i).setY(path.points[3 * i + 1] + height / 2);
    const local = at.sub(middle).applyQuaternion(turn).toArray();
    if (local.every((value, k) => Math.abs(value) <= region.size[k] / 2)) return path.tickOf(i);
  }
  return -1;
}

export class Comparison {
  // `pairOf`: [chosen, the other] or null; `sourceOf`: {query, level} of now; `tintOf`: path -> colour.
  constructor(root, store, pairOf, sourceOf, tintOf) {
    Object.assign(this, { root, store, pairOf, sourceOf, tintOf });
    store.on(['path', 'ghost', 'colorBy', 'order'], () => keepingFocus(root, () => this.fill()));
    this.fill();
  }

  fill() {
    const pair = this.pairOf();
    this.root.hidden = !pair;
    this.root.replaceChildren();
    if (!pair) return;
    const { query, level } = this.sourceOf();
    const rate = level?.tickRate ?? 60;
    const table = el('table', {});
    const row = (label, valueOf) =>
      table.append(
        el(
          'tr',
          {},
          el('th', { scope: 'row', text: label }),
          ...pair.map((path) => el('td', { text: valueOf(path) })),
        ),
      );
    const tints = [this.tintOf(pair[0]), GHOST_COLOR];
    table.append(
      el(
        'tr',
        {},
        el('td'),
        ...['Chosen', 'Ghost'].map((text, i) =>
          el(
            'th',
            { scope: 'col' },
            el('i', {
              class: `swatch ${i ? 'closest' : 'solution'}`,
              style: { '--tint': tints[i] },
            }),
            text,
          ),
        ),
      ),
    );
    row('Ends', (path) => causeOf(path, level).split('/').pop());
    row('Time', (path) => `${seconds(path.ticks / rate)} s`);
    row('Jumps', (path) => String(path.jumps));
    row('Way', (path) => `${lengthOf(path).toFixed(0)} studs`);
    for (const [name, region] of placesOf(query))
      row(name, (path) => {
        const tick = tickAt(path, region, level?.body.top ?? 0);
        return tick < 0 ? 'not passed' : `${seconds(tick / rate)} s`;
      });
    this.gap = el('output', { class: 'quiet' });
    this.root.append(
      el(
        'header',
        {},
        el('strong', { text: 'Comparison' }),
        el('button', {
          class: 'plain text',
          type: 'button',
          text: 'Swap',
          data: { key: 'swap' },
          on: { click: () => this.swap() },
        }),
        el('button', {
          class: 'plain close',
          type: 'button',
          'aria-label': 'End the comparison',
          text: '×',
          data: { key: 'end' },
          on: { click: () => this.store.set({ ghost: -1 }) },
        }),
      ),
      table,
      this.gap,
    );
  }

  swap() {
    const { path, ghost } = this.store.state;
    this.store.set({ path: ghost, ghost: path });
  }

  update(tick) {
    const pair = this.pairOf();
    if (!pair || !this.gap) return;
    const [a, b] = pair.map((path) => path.poseAt(Math.min(tick, path.ticks)));
    const apart = Math.hypot(a.x - b.x, a.y - b.y, a.z - b.z);
    this.gap.textContent = `${apart.toFixed(1)} studs apart now`;
  }
}
