// Colours along a solution by how close each of its steps is to failing: by the margin in studs, or
// by the time in which its jump can be pressed. `obby-solve --difficulty` measures both.
import { NO_VALUE_COLOR, rampColor } from './color_ramps.js';

/** @import {Path} from './path.js' */
/** @import {DifficultyStep} from './types/page_data.js' */
/** @import {Coloring, Query} from './types/report.js' */

const kSteps = 32; // distinct colours, so that lines need few

/**
 * Returns the smallest distance of a step to failing, in studs: from the edge of the part that the
 * player lands on, or from a part that kills.
 * @param {DifficultyStep} step
 */
function marginOf({ margin, clearance }) {
  const known = [margin, clearance].filter((value) => value !== undefined);
  return known.length ? Math.min(...known) : undefined;
}

/** @typedef {(step: DifficultyStep) => number | undefined} Closeness */

/**
 * A step whose closeness is `high` or more is as safe as the scale shows.
 * @type {Record<'margin' | 'window', {of: Closeness, high: number, labels: string[]}>}
 */
const kCloseness = {
  margin: { of: marginOf, high: 2, labels: ['0 studs or less', '1 stud', '2 studs or more'] },
  window: {
    of: ({ window }) => (window === undefined ? undefined : window / 1000),
    high: 0.4,
    labels: ['0 s to press', '0.2 s', '0.4 s or more'],
  },
};

/**
 * Returns the step that a tick belongs to.
 * @param {DifficultyStep[]} steps
 * @param {number} tick
 */
function stepAt(steps, tick) {
  return steps.find(({ startTick, ticks }) => tick < startTick + ticks) ?? steps.at(-1);
}

/**
 * The closest steps are the lightest. A trajectory has the colour of its closest step.
 * @param {Query} query
 * @param {'margin' | 'window'} quantity
 * @returns {Coloring}
 */
export function byStep(query, quantity) {
  const { of, high, labels } = kCloseness[quantity];
  const share = (/** @type {number} */ v) => 1 - Math.min(Math.max(v / high, 0), 1);
  const color = (/** @type {number | undefined} */ v) =>
    (v === undefined ? NO_VALUE_COLOR : rampColor(Math.round(share(v) * kSteps) / kSteps));
  const valuesOf = (/** @type {Path} */ { difficulty }) =>
    (difficulty?.steps ?? []).map(of).filter((v) => v !== undefined);
  const closest = (/** @type {Path} */ path) =>
    valuesOf(path).reduce((/** @type {number | undefined} */ a, b) => Math.min(a ?? b, b), undefined);
  const along = (/** @type {Path} */ path, /** @type {number} */ sample) => {
    const step = stepAt(path.difficulty?.steps ?? [], path.tickOf(sample));
    return color(step && of(step));
  };
  /** @type {Coloring['legend']} */
  const legend = labels.map((label, i) => [label, rampColor(1 - i / 2), 'solution']);
  const measured = query.paths.some((path) => valuesOf(path).length);
  /** @type {Coloring['legend']} */
  const none = [['Not measured', NO_VALUE_COLOR, 'attempt']];
  return { of: (path) => color(closest(path)), along, legend: measured ? [...legend, ...none] : none };
}
