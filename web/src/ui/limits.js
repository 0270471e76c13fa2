// The limits of a query in words.
import { kMaxAlike } from '../scene/regions.js';
import { el, plural, seconds } from './dom.js';

/** @import {Query} from '../types/report.js' */

/** @param {Query} query */
function jumpLimits({ minJumps, maxJumps }) {
  if (maxJumps === 0) return ['no jumps'];
  if (maxJumps >= 0 && maxJumps === minJumps) return [`exactly ${plural(maxJumps, 'jump')}`];
  const limits = [];
  if (maxJumps >= 0) limits.push(`at most ${plural(maxJumps, 'jump')}`);
  if (minJumps > 0) limits.push(`at least ${plural(minJumps, 'jump')}`);
  return limits;
}

/**
 * Converts fallingDown to falling down.
 * @param {string} state
 */
const stateName = (state) => state.replace(/[A-Z]/g, (c) => ` ${c.toLowerCase()}`);

/** @param {Query} query */
export function limitsOf(query) {
  const parts = [];
  parts.push(...jumpLimits(query));
  if (query.timeLimit > 0) parts.push(`within ${seconds(query.timeLimit)} s`);
  if (query.waypoints.length) parts.push(plural(query.waypoints.length, 'waypoint'));
  if (query.visits.length) parts.push(`${plural(query.visits.length, 'place')} in any order`);
  const drawn = (/** @type {unknown[]} */ { length }) =>
    length > kMaxAlike ? ` (${kMaxAlike} are drawn)` : '';
  const goals = query.goals.length + (query.goal ? 1 : 0);
  if (query.goals.length) parts.push(`one of ${plural(goals, 'goal')}${drawn(query.goals)}`);
  if (query.avoid.length)
    parts.push(`${plural(query.avoid.length, 'region')} to avoid${drawn(query.avoid)}`);
  if (query.maxDamage >= 0) parts.push(`at most ${query.maxDamage} health lost`);
  if (query.forbid.length) parts.push(`never ${query.forbid.map(stateName).join(' or ')}`);
  return el('p', {
    class: 'quiet limits',
    text: parts.length ? `Limits: ${parts.join(', ')}` : '',
    hidden: !parts.length,
  });
}
