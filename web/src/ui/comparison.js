// Compares two trajectories: their figures, when each passed the query's places, and the current
// distance between the players.
import { Quaternion, Vector3 } from 'three';
import { segmentMeets } from '../choice.js';
import { causeOf, GHOST_COLOR } from '../palette.js';
import { partName } from '../part_name.js';
import { el, keepingFocus, seconds } from './dom.js';

/** @import {Path} from '../path.js' */
/** @import {Store} from '../store.js' */
/** @import {Region} from '../types/page_data.js' */
/** @import {Query, Source, Tint} from '../types/report.js' */

/**
 * Returns the length of the trajectory in studs, including flight and falls.
 * @param {Path} path
 */
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

/**
 * Returns the first sample from `from` on in which the player, a vertical line from the feet up,
 * meets an oriented box, as in the simulator; -1 for never.
 * @param {Path} path
 * @param {Region} region
 * @param {number} height
 * @param {number} from
 */
function sampleIn(path, region, height, from) {
  const turn = new Quaternion().fromArray(region.rotation).normalize().invert();
  const middle = new Vector3().fromArray(region.position);
  const max = region.size.map((size) => size / 2);
  const box = { min: max.map((half) => -half), max };
  const local = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) =>
    new Vector3(x, y, z).sub(middle).applyQuaternion(turn).toArray();
  for (let i = from; i < path.samples; i++) {
    const [x, y, z] = path.points.subarray(3 * i, 3 * i + 3);
    if (segmentMeets(box, [...local(x, y, z), ...local(x, y + height, z)], 0, 1)) return i;
  }
  return -1;
}

/**
 * Returns [name, ticks of each of `paths` (-1 for never)] for the places that a query requires:
 * waypoints in order, visits in any order.
 * @param {Query | undefined} query
 * @param {Path[]} paths
 * @param {number} height
 * @returns {[name: string, ticks: number[]][]}
 */
function passings(query, paths, height) {
  const rows = (query?.waypoints ?? []).map(({ region }) => ({ region, inOrder: true }));
  rows.push(...(query?.visits ?? []).map((region) => ({ region, inOrder: false })));
  const reached = paths.map(() => 0); // sample of the previous waypoint
  return rows.map(({ region, inOrder }, row) => {
    const ticks = paths.map((path, i) => {
      const from = inOrder ? reached[i] : 0;
      const sample = from < 0 ? -1 : sampleIn(path, region, height, from);
      if (inOrder) reached[i] = sample;
      return sample < 0 ? -1 : path.tickOf(sample);
    });
    return [region.name || `Waypoint ${row + 1}`, ticks];
  });
}

export class Comparison {
  /**
   * `pairOf`: returns [selected, ghost] or null; `sourceOf`: returns the current {query, level};
   * `tintOf`: path -> colour.
   * @param {HTMLElement} root
   * @param {Store} store
   * @param {() => [Path, Path] | null} pairOf
   * @param {() => Source} sourceOf
   * @param {Tint} tintOf
   */
  constructor(root, store, pairOf, sourceOf, tintOf) {
    this.root = root;
    this.store = store;
    this.pairOf = pairOf;
    this.sourceOf = sourceOf;
    this.tintOf = tintOf;
    // Screen readers must not announce this distance each tick.
    this.gap = el('output', { class: 'quiet', 'aria-live': 'off' });
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
    const row = (/** @type {string} */ label, /** @type {(path: Path) => string} */ valueOf) =>
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
        ...['Selected', 'Ghost'].map((text, i) =>
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
    row('Outcome', (path) => causeOf(path, level, partName));
    row('Time', (path) => `${seconds(path.ticks / rate)} s`);
    row('Jumps', (path) => String(path.jumps));
    row('Length', (path) => `${lengthOf(path).toFixed(0)} studs`);
    for (const [name, ticks] of passings(query, pair, level?.body.top ?? 0))
      row(name, (path) => {
        const tick = ticks[pair.indexOf(path)];
        return tick < 0 ? 'never' : `${seconds(tick / rate)} s`;
      });
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

  /** @param {number} tick */
  update(tick) {
    const pair = this.pairOf();
    if (!pair) return;
    const [a, b] = pair.map((path) => path.poseAt(Math.min(tick, path.ticks)));
    const apart = Math.hypot(a.x - b.x, a.y - b.y, a.z - b.z);
    this.gap.textContent = `${apart.toFixed(1)} studs apart now`;
  }
}
