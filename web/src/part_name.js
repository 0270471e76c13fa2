// Names of parts. Parts of hand-written levels need no name, and an answer of another version may
// refer to parts that the level lacks. Such parts get a number.

// Returns the part's path in the place.
export const fullName = (level, part) => level?.names[part] || `part ${part}`;

// Returns the last component of the path.
export const partName = (level, part) => fullName(level, part).split('/').pop() || `part ${part}`;
