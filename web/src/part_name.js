// What a part is called. Parts of levels that were written by hand need no name, and an answer of another version may name
// parts that the level does not have: such a part is told by its number.

/** @import {Level} from './types/report.js' */

/**
 * Its path in the place.
 * @param {Level | undefined} level
 * @param {number} part
 */
export const fullName = (level, part) => level?.names[part] || `part ${part}`;

/**
 * The last word of that.
 * @param {Level | undefined} level
 * @param {number} part
 */
export const partName = (level, part) => fullName(level, part).split('/').pop() || `part ${part}`;
