// Names of parts. Parts of hand-written levels need no name, and an answer of another version may
// refer to parts that the level lacks. Such parts get a number.

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
