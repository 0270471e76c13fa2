// The meaning of the page's colours. Accents differ in lightness as well as hue, for colour-blind
// readers, and some roles also have a pattern (scene/part_material.js).
import { fullName } from './part_name.js';

/** @import {Path} from './path.js' */
/** @import {Band, Outcome, Verdict} from './types/page_data.js' */
/** @import {Level, Query, Result} from './types/report.js' */
/** @import {Glyph} from './scene/markers.js' */

/**
 * Styles in the order of view::Role (lib/view/roles.h), whose values are the page's codes.
 * @satisfies {Record<string, {label: string, color: string}>}
 */
export const ROLE_STYLE = {
  plain: { label: 'Part', color: '#77808f' },
  start: { label: 'Start', color: '#35c48d' },
  goal: { label: 'Goal', color: '#3f8cff' },
  kill: { label: 'Kills', color: '#dd4149' },
  moving: { label: 'Moves', color: '#a48bfa' },
  vanish: { label: 'Vanishes', color: '#e6c85a' },
  conveyor: { label: 'Conveyor', color: '#4cc3dd' },
  pad: { label: 'Jump pad', color: '#f59a4c' },
  checkpoint: { label: 'Checkpoint', color: '#8fe3c4' },
  ghost: { label: 'Not solid', color: '#5b6472' },
  dynamic: { label: 'Dynamic', color: '#b98f6f' },
};

/** @type {Record<Outcome, {label: string, short: string, color: string, glyph: Glyph}>} */
export const OUTCOME_STYLE = {
  goal: { label: 'Reached the goal', short: 'Goal', color: '#7fe3b5', glyph: 'ring' },
  killed: { label: 'Killed', short: 'Killed', color: '#f0484e', glyph: 'cross' },
  fell: { label: 'Fell', short: 'Fell', color: '#e29a5b', glyph: 'down' },
  avoided: { label: 'Entered a region to avoid', short: 'Avoid region', color: '#d873c4', glyph: 'bar' },
  jumps: { label: 'Too many jumps', short: 'Jump limit', color: '#c9b458', glyph: 'up' },
  timeout: { label: 'Out of time', short: 'Time limit', color: '#9aa4b5', glyph: 'clock' },
  hurt: { label: 'Lost too much health', short: 'Hurt', color: '#e07a8b', glyph: 'cross' },
  forbidden: { label: 'In a forbidden state', short: 'Forbidden state', color: '#a98ad8', glyph: 'bar' },
  running: { label: 'Unfinished', short: 'Unfinished', color: '#8190a8', glyph: 'dot' },
};

export const OUTCOMES = /** @type {Outcome[]} */ (Object.keys(OUTCOME_STYLE));

/**
 * The verdict that a query shows, or its state without one.
 * @typedef {Verdict | 'doubtful' | 'improving' | 'found' | 'mismatch' | 'running' | 'waiting' | 'none'} ShownVerdict
 */

/** @type {Record<ShownVerdict, {label: string, short?: string, color: string, mark: string}>} */
export const VERDICT_STYLE = {
  solved: { label: 'Solved', color: '#5fd6a2', mark: '✓' },
  doubtful: { label: 'Solved, in doubt', color: '#c9d66a', mark: '✓' },
  improving: { label: 'Solved, being improved', short: 'Improving', color: '#5fd6a2', mark: '✓' },
  found: { label: 'Solved, but the final answer is missing', short: 'Cut short', color: '#c9d66a', mark: '✓' },
  unreachable: { label: 'Unreachable', color: '#f0484e', mark: '✕' },
  unknown: { label: 'Unknown', color: '#e6c85a', mark: '?' },
  mismatch: { label: 'Replay mismatch', color: '#ff7ad9', mark: '≠' },
  running: { label: 'Searching', color: '#7fd4ff', mark: '…' },
  waiting: { label: 'Waiting', color: '#8190a8', mark: '…' },
  none: { label: 'Not asked in this run', short: 'Not asked', color: '#8190a8', mark: '–' },
};

/**
 * The difficulty of a step, in the order of the schema's bands.
 * @type {Record<Band, {label: string, color: string}>}
 */
export const BAND_STYLE = {
  trivial: { label: 'Trivial', color: '#7fe3b5' },
  easy: { label: 'Easy', color: '#9ad85f' },
  medium: { label: 'Medium', color: '#f2c14e' },
  hard: { label: 'Hard', color: '#f58b45' },
  extreme: { label: 'Extreme', color: '#f0484e' },
  unknown: { label: 'Unknown', color: '#8190a8' }, // from a stream of a later version
};

export const BANDS = /** @type {Band[]} */ (Object.keys(BAND_STYLE));

/**
 * Returns the rank of the band; unmeasured paths come last.
 * @param {Path} path
 */
export function bandRank(path) {
  return path.difficulty ? BANDS.indexOf(path.difficulty.band) : BANDS.length;
}

export const SOLUTION_COLOR = '#ffd166';
export const SELECTED_COLOR = '#fff3c4';
export const CUT_COLOR = '#ff8f6b'; // the step that is impossible
export const REACHED_COLOR = '#8fe3c4'; // parts that can be reached
export const GHOST_COLOR = '#7fd4ff'; // the ghost in a comparison

/**
 * Returns a path's colour in lists and in the scene.
 * @param {Path} path
 */
export function pathColor(path) {
  if (path.mismatch) return VERDICT_STYLE.mismatch.color;
  return path.outcome === 'goal' ? SOLUTION_COLOR : OUTCOME_STYLE[path.outcome].color;
}

/** @param {Result} result */
function isDoubtful(result) {
  return result.verdict === 'solved' && result.holds === false;
}

/** @type {ShownVerdict[]} */
const SOLVED = ['solved', 'doubtful', 'improving', 'found'];

/**
 * Returns true if the query has a solution that replays.
 * @param {Query} query
 */
export const isSolved = (query) => SOLVED.includes(verdictOf(query));

/**
 * @param {Query} query
 * @returns {ShownVerdict}
 */
export function verdictOf(query) {
  if (query.paths.some((path) => path.mismatch && path.kind === 'solution')) return 'mismatch';
  if (query.result) return isDoubtful(query.result) ? 'doubtful' : query.result.verdict;
  if (query.paths.some(({ provisional }) => provisional)) return query.running ? 'improving' : 'found';
  if (query.running) return query.progress ? 'running' : 'waiting';
  return 'none';
}

/**
 * Returns why a path ended, as text. `nameOf`: level, part -> the part's name; `length`: label or
 * short.
 * @param {Path} path
 * @param {Level | undefined} level
 * @param {'label' | 'short'} [length]
 */
export function causeOf(path, level, nameOf = fullName, length = 'label') {
  const words = OUTCOME_STYLE[path.outcome][length];
  if (path.part >= 0 && level && path.part < level.count)
    return `${words} by ${nameOf(level, path.part)}`;
  return words;
}

/**
 * Describes the hardest step of a solution, or returns nothing if it was not measured.
 * @param {Path} path
 * @param {Level | undefined} level
 */
export function hardestOf(path, level) {
  if (!path.difficulty) return '';
  const { hardest, noise } = path.difficulty;
  const name = (/** @type {number} */ part, /** @type {string} */ none) =>
    (part < 0 ? none : fullName(level, part));
  const from = name(hardest.from, 'the start');
  const to = name(hardest.to, 'the goal');
  const what = `Hardest step: ${from} to ${to}, ${hardest.band}`;
  const window =
    hardest.window > 0 ? `, press within ${(hardest.window / 1000).toFixed(2)} s` : '';
  return `${what}${window} (${noise})`;
}
