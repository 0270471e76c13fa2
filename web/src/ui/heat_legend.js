// The legend of the heat map: a logarithmic scale from 1 to the max count of a tile.
import { heatColor } from '../color_ramps.js';
import { count, el } from './dom.js';

/** @import {Query, State} from '../types/report.js' */

const kStops = 9;

/**
 * Returns no elements if no heat map is shown. `query`: the current query.
 * @param {State} state
 * @param {Query | undefined} query
 */
export function heatLegend({ heat, heatTrajectories, heatMax }, query) {
  if (!heat || !heatMax) return [];
  const ofSearch = !heatTrajectories && query?.result?.heatMap;
  const colors = Array.from({ length: kStops }, (_, i) => heatColor(i / (kStops - 1)));
  const counts = [1, Math.round(Math.sqrt(heatMax)), heatMax];
  const ticks = [...new Set(counts)].map((n) => el('small', { text: count(n) }));
  const caption = `Heat map: ${ofSearch ? 'places explored' : 'trajectories'} per tile`;
  return [
    el(
      'section',
      { class: 'heat' },
      el('p', { text: caption }),
      el('i', {
        class: 'ramp',
        style: { background: `linear-gradient(90deg, ${colors.join(', ')})` },
      }),
      el('div', { class: 'scale' }, ...ticks),
    ),
    el('hr'),
  ];
}
