// Two trajectories side by side: their numbers, and how far apart they are now.
import { causeOf, GHOST_COLOR } from '../palette.js';
import { el, seconds } from './dom.js';

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

export class Comparison {
  // `pairOf`: [chosen, the other] or null; `tintOf`: path -> colour.
  constructor(root, store, pairOf, levelOf, tintOf) {
    Object.assign(this, { root, store, pairOf, levelOf, tintOf });
    store.on(['path', 'ghost', 'colorBy', 'order'], () => this.fill());
    this.fill();
  }

  fill() {
    const pair = this.pairOf();
    this.root.hidden = !pair;
    this.root.replaceChildren();
    if (!pair) return;
    const level = this.levelOf();
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
          el('th', { scope: 'col' }, el('i', { class: `swatch ${i ? 'closest' : 'solution'}`, style: { '--tint': tints[i] } }), text),
        ),
      ),
    );
    row('Ends', (path) => causeOf(path, level).split('/').pop());
    row('Time', (path) => `${seconds(path.ticks / rate)} s`);
    row('Jumps', (path) => String(path.jumps));
    row('Way', (path) => `${lengthOf(path).toFixed(0)} studs`);
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
          on: { click: () => this.swap() },
        }),
        el('button', {
          class: 'plain close',
          type: 'button',
          'aria-label': 'End the comparison',
          text: '×',
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
