// The views that the page offers: the query, the whole course, from above, a part, a trajectory,
// and a followed player.
import { Box3, Vector3 } from 'three';
import { headingAt } from './follow_camera.js';
import { cornersOf, subjectOf } from './subject.js';
import { bestDirection } from './view_choice.js';

/** @import {Path} from '../path.js' */
/** @import {Level} from '../types/report.js' */
/** @import {Stage} from './stage.js' */

const kAbove = -1.549; // pitch of the view from above, radians
const kAroundPart = 14; // studs
const kEyesBelowTop = 0.7; // studs

/** @param {ArrayLike<number>} points */
const boxAround = (points) => new Box3().setFromArray(points);

export class Views {
  /**
   * @param {Stage} stage
   * @param {() => void} measure updates the free area of the picture
   */
  constructor(stage, measure) {
    this.stage = stage;
    this.rig = stage.rig;
    this.measure = measure;
    this.rig.sight = (from, to) => stage.solids?.firstHit(from, to) ?? 1;
  }

  // Returns what a view of the query shows; without a query, the level.
  subject() {
    const { query, level, bounds } = this.stage;
    const subject = query ? subjectOf(query, level) : { frame: [], seen: [], from: null, to: null };
    if (subject.frame.length) return subject;
    return { ...subject, frame: level?.count ? cornersOf(level) : [...bounds.min, ...bounds.max] };
  }

  /** @param {boolean} atOnce */
  query(atOnce) {
    this.measure();
    const subject = this.subject();
    this.stage.sun.cover(boxAround(subject.frame).expandByScalar(3));
    this.rig.framePoints(subject.frame, this.direction(subject), atOnce);
  }

  /** @param {import('./view_choice.js').Subject} subject */
  direction(subject) {
    const { solids } = this.stage;
    const size = boxAround(subject.frame).getSize(new Vector3());
    // Looks along the shorter side, so that the level runs across the screen.
    const along = { yaw: size.x >= size.z ? 0.55 : Math.PI / 2 - 0.55, pitch: -0.52 };
    return solids ? bestDirection(subject, solids, this.rig.slopes()) : along;
  }

  // Shows all parts, from the current side unless that is too steep or too flat.
  course() {
    const { level } = this.stage;
    if (!level?.count) return;
    this.measure();
    const { yaw, pitch } = this.rig.goal;
    this.rig.framePoints(cornersOf(level), { yaw, pitch: Math.min(-0.35, Math.max(-0.9, pitch)) });
  }

  above() {
    this.measure();
    const { frame } = this.subject();
    const size = boxAround(frame).getSize(new Vector3());
    this.rig.framePoints(frame, { yaw: size.x >= size.z ? 0 : Math.PI / 2, pitch: kAbove });
  }

  /**
   * Frames a part at its current pose.
   * @param {number} part
   */
  part(part) {
    const { levelView } = this.stage;
    if (levelView) this.rig.frame(levelView.centreOf(part), kAroundPart);
  }

  /** @param {Path} path */
  path(path) {
    this.measure();
    const { yaw, pitch } = this.rig.goal;
    this.rig.framePoints(path.points, { yaw, pitch });
  }

  /**
   * @param {Path} path
   * @param {number} tick
   * @param {Level} level
   */
  follow(path, tick, level) {
    const { x, y, z } = path.poseAt(tick);
    const head = new Vector3(x, y + level.body.top - kEyesBelowTop, z);
    this.rig.follow(head, headingAt(path, tick, level.tickRate));
  }

  // Returns a text that changes with the picture's camera.
  stamp() {
    const { position, quaternion, aspect } = this.stage.rig.camera;
    return [...position.toArray(), ...quaternion.toArray(), aspect]
      .map((value) => value.toFixed(4))
      .join();
  }
}
