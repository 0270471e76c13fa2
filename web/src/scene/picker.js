// Finds the trajectory, part or point of the stage under the pointer.
import { pickPart, pickPath, pointAtHeight, pointOnParts } from './picking.js';

/** @import {Path} from '../path.js' */
/** @import {State} from '../types/report.js' */
/** @import {At, Screen} from './picking.js' */
/** @import {Stage} from './stage.js' */

export class Picker {
  /** @param {Stage} stage */
  constructor(stage) {
    this.stage = stage;
  }

  /** @returns {Screen} */
  screen() {
    const { rig, width, height } = this.stage;
    return { camera: rig.camera, width, height };
  }

  /**
   * Returns the point under the pointer, on a part or at the height of the camera's target.
   * @param {At} at
   */
  point(at) {
    const { levelView, rig } = this.stage;
    if (!levelView) return null;
    return pointOnParts(levelView.group, this.screen(), at, rig.goal.target.y);
  }

  /**
   * @param {At} at
   * @param {number} height
   */
  pointAtHeight(at, height) {
    return pointAtHeight(this.screen(), at, height);
  }

  /**
   * @param {State} state
   * @param {At} at
   */
  path({ path: chosen, ghost, solutions, attempts }, at) {
    const { query, shown } = this.stage;
    const isVisible = (/** @type {Path} */ { kind }, /** @type {number} */ index) =>
      index === chosen ||
      index === ghost ||
      (shown.has(index) && (kind === 'solution' ? solutions : kind !== 'attempt' || attempts));
    return pickPath(query?.paths ?? [], this.screen(), at, isVisible);
  }

  /**
   * Returns the part, or -1 for none.
   * @param {At} at
   */
  part(at) {
    const { levelView } = this.stage;
    return levelView ? pickPart(levelView.group, this.screen(), at) : -1;
  }
}
