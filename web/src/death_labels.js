// Labels for the places where the shown trajectories were killed.
import { OUTCOME_STYLE } from './palette.js';
import { partName } from './part_name.js';

// Returns the place nearest to the centroid of all.
function middlemost(places) {
  const sum = [0, 1, 2].map((k) => places.reduce((all, place) => all + place[k], 0));
  const far = (place) => Math.hypot(...place.map((value, k) => value - sum[k] / places.length));
  return places.reduce((best, place) => (far(place) < far(best) ? place : best));
}

// Returns [{text, at, color}], the most frequent killers first.
export function deathLabels(paths, level, most) {
  const killers = new Map();
  for (const path of paths) {
    if (path.outcome !== 'killed' || path.part < 0) continue;
    if (!killers.has(path.part)) killers.set(path.part, []);
    killers.get(path.part).push(path.end());
  }
  return [...killers]
    .sort((a, b) => b[1].length - a[1].length)
    .slice(0, most)
    .map(([part, places]) => ({
      text: `✕ ${places.length} killed by ${partName(level, part)}`,
      at: middlemost(places),
      color: OUTCOME_STYLE.killed.color,
    }));
}
