// Computes the extent of a level without a few outliers.
import { Box3, Vector3 } from 'three';

/** @import {Level} from '../types/report.js' */

/** @param {Level} level */
export function extentOf(level) {
  const axis = (/** @type {number} */ k) =>
    Float32Array.from({ length: level.count }, (_, i) => level.position[3 * i + k]).sort();
  const at = (/** @type {Float32Array} */ values, /** @type {number} */ share) =>
    values[Math.min(values.length - 1, Math.floor(share * values.length))] ?? 0;
  const sorted = [0, 1, 2].map(axis);
  const bounds = new Box3();
  bounds.min.fromArray(sorted.map((values) => at(values, 0.02)));
  bounds.max.fromArray(sorted.map((values) => at(values, 0.98)));
  bounds.expandByScalar(4);
  const centre = bounds.getCenter(new Vector3());
  return { bounds, centre, radius: Math.max(10, bounds.getSize(new Vector3()).length() / 2) };
}
