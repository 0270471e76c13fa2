// A way of many samples as a few points: most moving parts go straight from one place to the next.

/** @import {Triple} from '../types/page_data.js' */

const kOff = 0.01; // studs that a sample may lie beside a straight stretch
const kStep = 0.02; // studs that it takes to tell a direction

/**
 * `samples`: (x, y, z) each. Gives the first, the corners, and the last: no sample is farther than kStep from the way
 * through these.
 * @param {Float32Array} samples
 */
export function corners(samples) {
  const out = [...samples.subarray(0, 3)];
  let from = 0; // where the stretch begins: the sample of the last corner
  /** @type {Triple | null} */
  let way = null; // its direction
  let far = 0; // how far on it the sample before is
  for (let i = 3; i < samples.length; i += 3) {
    let [x, y, z] = offset(samples, from, i);
    if (way) {
      const on = x * way[0] + y * way[1] + z * way[2];
      const beside = Math.hypot(x - on * way[0], y - on * way[1], z - on * way[2]);
      if (on >= far && beside <= kOff) {
        far = on;
        continue;
      }
      from = i - 3;
      out.push(...samples.subarray(from, i));
      way = null;
      [x, y, z] = offset(samples, from, i);
    }
    const length = Math.hypot(x, y, z);
    if (length <= kStep) continue;
    way = [x / length, y / length, z / length];
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
