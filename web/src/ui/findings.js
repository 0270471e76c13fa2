// What an answer says beyond its verdict: what would have to change, by which routes it goes, how far to trust it.
import { el, plural, seconds } from './dom.js';

const SATURATION = {
  saturated: 'The search found nearly all there is to find at this resolution.',
  growing: 'The search was still finding new places: more time may solve it.',
};

function help(result) {
  if (!result.relaxations?.length) return [];
  return [
    el('h3', { text: 'What would help' }),
    el('ul', {}, ...result.relaxations.map((text) => el('li', { text }))),
  ];
}

function routes(result, level) {
  if (!(result.routes?.length > 1)) return [];
  const rate = level?.tickRate ?? 60;
  const name = (part) => level?.names[part] || `part ${part}`;
  const line = ({ route, count, ticks }) =>
    el(
      'li',
      { title: route.map(name).join(' → ') },
      el('span', { class: 'way', text: route.map(name).join(' → ') }),
      el('small', {
        text: `${plural(Number(count), 'solution')}, shortest ${seconds(ticks / rate)} s`,
      }),
    );
  return [el('h3', { text: 'Routes' }), el('ul', {}, ...result.routes.map(line))];
}

function trust(result) {
  const text = SATURATION[result.evidence?.saturation];
  if (result.verdict !== 'unknown' || !text) return [];
  return [el('p', { class: 'quiet', text })];
}

// Nothing where the stream says nothing of the kind.
export function findings(query, level) {
  const result = query.result;
  if (!result) return el('div', { hidden: true });
  const parts = [...help(result), ...routes(result, level), ...trust(result)];
  return el('div', { class: 'findings', hidden: parts.length === 0 }, ...parts);
}
