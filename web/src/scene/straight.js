// Reduces a motion of many samples to a few points, since most moving parts go straight from place
// to place.

/** @import {Triple} from '../types/page_data.js' */

const kOff = 0.01; // max studs between a sample and a straight segment
const kStep = 0.02; // min studs that define a direction

/**
 * `samples`: (x, y, z) each. Returns the first sample, the corners and the last sample. No sample
 * is farther than kStep from the polyline through them.
 * @param {Float32Array} samples
 */
export function corners(samples) {
  const out = [...samples.subarray(0, 3)];
  let from = 0; // start of the current segment: the sample at the last corner
  /** @type {Triple | null} */
  let direction = null; // direction of the segment
  let far = 0; // distance of the previous sample along `direction`, studs
  for (let i = 3; i < samples.length; i += 3) {
    let [x, y, z] = offset(samples, from, i);
    if (direction) {
      const on = x * direction[0] + y * direction[1] + z * direction[2];
      const beside = Math.hypot(x - on * direction[0], y - on * direction[1], z - on * direction[2]);
      if (on >= far && beside <= kOff) {
        far = on;
        continue;
      }
      from = i - 3;
      out.push(...samples.subarray(from, i));
      direction = null;
      [x, y, z] = offset(samples, from, i);
    }
    const length = Math.hypot(x, y, z);
    if (length <= kStep) continue;
    direction = [x / length, y / length, z / length];
    far = length;
  }
  out.push(...samples.subarray(-3));
  return new Float32Array(out);
}

/**
 * @param {Float32Array} samples
 * @param {number} from
 * @param {number} to
 * @returns {Triple}
 */
const offset = (samples, from, to) => [
  samples[to] - samples[from],
  samples[to + 1] - samples[from + 1],
  samples[to + 2] - samples[from + 2],
];
