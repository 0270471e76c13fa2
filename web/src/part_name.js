// Names of parts. A part is named by its number if it has no name, as in hand-written levels, or
// if the level lacks it, as when the answer is from another version.

/** @import {Level} from './types/report.js' */

/**
 * Returns the part's path in the place.
 * @param {Level | undefined} level
 * @param {number} part
 */
export const fullName = (level, part) => level?.names[part] || `part ${part}`;

/**
 * Returns the last component of the path.
 * @param {Level | undefined} level
 * @param {number} part
 */
export const partName = (level, part) => fullName(level, part).split('/').pop() || `part ${part}`;
