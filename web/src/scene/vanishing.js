// Which parts are away: by the clock, or until something happens.

/** @import {TimedVanish, Vanish} from '../types/page_data.js' */
/** @import {Level} from '../types/report.js' */

/**
 * Between two ticks nothing comes or goes.
 * @param {TimedVanish} rule
 * @param {number} tick
 */
export function timedAway(rule, tick) {
  const away = (Math.floor(tick) + rule.phase) % (rule.delay + rule.away) >= rule.delay;
  return away !== Boolean(rule.inverted);
}

/**
 * Parts that are away until something happens.
 * @param {Level} level
 */
export function goneAtRest(level) {
  const waits = (/** @type {Vanish} */ rule) => rule.trigger !== 'timer' && rule.inverted;
  return new Set(level.vanish.filter(waits).map((rule) => rule.part));
}
