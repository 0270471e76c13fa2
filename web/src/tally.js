// Counts of values.

/**
 * Returns a [value, count] pair per distinct value, most frequent first.
 * @template T
 * @param {T[]} values
 * @returns {[T, number][]}
 */
export function tally(values) {
  /** @type {Map<T, number>} */
  const counts = new Map();
  for (const value of values) counts.set(value, (counts.get(value) ?? 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1]);
}
