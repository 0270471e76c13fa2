// Computes which vanishing parts are absent, by the level clock or until they are triggered.

/** @import {TimedVanish, Vanish} from '../types/page_data.js' */
/** @import {Level} from '../types/report.js' */

/**
 * Returns true if a part with a timer is absent. Timers act on whole ticks.
 * @param {TimedVanish} rule
 * @param {number} tick
 */
export function timedAway(rule, tick) {
  const away = (Math.floor(tick) + rule.phase) % (rule.delay + rule.away) >= rule.delay;
  return away !== Boolean(rule.inverted);
}

/**
 * Returns the parts that are absent until they are triggered.
 * @param {Level} level
 */
export function goneAtRest(level) {
  const waits = (/** @type {Vanish} */ rule) => rule.trigger !== 'timer' && rule.inverted;
  return new Set(level.vanish.filter(waits).map((rule) => rule.part));
}
