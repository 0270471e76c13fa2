// Colour ramps for numbers. Their lightness rises with the number, so that they are readable
// without hue.

// The ramp of trajectories.
const kRamp = [
  [76, 99, 176],
  [33, 145, 140],
  [94, 201, 98],
  [253, 231, 37],
];
// The colour map "inferno" of matplotlib (CC0), without its near-black beginning.
const kHeat = [
  [66, 10, 104],
  [106, 23, 110],
  [147, 38, 103],
  [188, 55, 84],
  [221, 81, 58],
  [243, 120, 25],
  [252, 165, 10],
  [246, 215, 70],
  [252, 255, 164],
];
export const NO_VALUE_COLOR = '#8190a8'; // for what has no value

/**
 * @param {number[][]} ramp
 * @param {number} share
 */
function mixed(ramp, share) {
  const s = Math.min(Math.max(share, 0), 1) * (ramp.length - 1);
  const i = Math.min(ramp.length - 2, Math.floor(s));
  const mix = ramp[i].map((v, k) => Math.round(v + (ramp[i + 1][k] - v) * (s - i)));
  return `#${mix.map((v) => v.toString(16).padStart(2, '0')).join('')}`;
}

/** @param {number} share */
export const rampColor = (share) => mixed(kRamp, share);

/**
 * Returns a colour of the heat map, which has its own ramp, since it lies on parts of all colours.
 * @param {number} share
 */
export const heatColor = (share) => mixed(kHeat, share);
