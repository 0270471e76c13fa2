// Shows why a query is unreachable: a frame around every reachable part, and an arrow over the
// smallest impossible step.
import {
  ArrowHelper,
  BoxGeometry,
  BufferGeometry,
  EdgesGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Quaternion,
  Vector3,
} from 'three';
import { CUT_COLOR, REACHED_COLOR } from '../palette.js';
import { lackOf } from '../ui/findings.js';
import { dispose } from './dispose.js';

/** @import {Triple} from '../types/page_data.js' */
/** @import {Label, Level, Query} from '../types/report.js' */

const kAbove = 1.2; // studs above the parts that the arrow connects
const kHead = 1.6; // length of the arrow's head, studs

/**
 * @param {Level} level
 * @param {number} part
 */
function centreOf(level, part) {
  const { position, rotation, size } = level;
  const turn = new Quaternion().fromArray(rotation, 4 * part).normalize();
  // Half the height of the rotated box.
  const up = [0, 1, 2].reduce((sum, k) => {
    const axis = new Vector3().setComponent(k, size[3 * part + k] / 2).applyQuaternion(turn);
    return sum + Math.abs(axis.y);
  }, 0);
  return new Vector3().fromArray(position, 3 * part).add(new Vector3(0, up + kAbove, 0));
}

/**
 * Merges the edges of all reached parts into one buffer.
 * @param {Level} level
 * @param {number[]} parts
 */
function frames(level, parts) {
  const edges = new EdgesGeometry(new BoxGeometry(1, 1, 1)).attributes.position;
  const points = [];
  const corner = new Vector3();
  for (const part of parts) {
    if (part < 0 || part >= level.count) continue;
    const turn = new Quaternion().fromArray(level.rotation, 4 * part).normalize();
    const size = new Vector3().fromArray(level.size, 3 * part).addScalar(0.15);
    const at = new Vector3().fromArray(level.position, 3 * part);
    for (let i = 0; i < edges.count; i++)
      points.push(
        ...corner.fromBufferAttribute(edges, i).multiply(size).applyQuaternion(turn).add(at),
      );
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
  const lines = new LineSegments(geometry, new LineBasicMaterial({ color: REACHED_COLOR }));
  lines.renderOrder = 4;
  lines.frustumCulled = false;
  return lines;
}

export class CutView {
  /**
   * @param {Query} query
   * @param {Level | undefined} level
   */
  constructor(query, level) {
    this.group = new Group();
    /** @type {Label[]} */
    this.labels = [];
    const cut = query.result?.cut;
    if (!cut || !level) return;
    this.group.add(frames(level, cut.reached));
    const from = this.place(level, cut.from, query.startPosition);
    const to = this.place(level, cut.to, query.goal?.position);
    const known = [from, to].filter((end) => end !== null);
    if (!known.length) return;
    if (from && to) this.group.add(this.arrow(from, to));
    const middle = known.reduce((sum, end) => sum.add(end), new Vector3());
    this.labels.push({
      text: `✕ ${lackOf(cut) || 'impossible step'}`,
      at: middle.divideScalar(known.length).add(new Vector3(0, 1, 0)),
      color: CUT_COLOR,
    });
  }

  /**
   * Returns the top of a part, or a point above `otherwise` if the level lacks the part.
   * @param {Level} level
   * @param {number} part
   * @param {Triple | null | undefined} otherwise
   */
  place(level, part, otherwise) {
    if (part >= 0 && part < level.count) return centreOf(level, part);
    return otherwise ? new Vector3(...otherwise).add(new Vector3(0, kAbove, 0)) : null;
  }

  /**
   * @param {Vector3} from
   * @param {Vector3} to
   */
  arrow(from, to) {
    const along = to.clone().sub(from);
    const length = Math.max(along.length(), 0.1);
    const head = Math.min(kHead, length / 2);
    const arrow = new ArrowHelper(along.normalize(), from, length, CUT_COLOR, head, head * 0.7);
    for (const { material } of [arrow.line, arrow.cone])
      for (const each of [material].flat()) each.depthTest = false;
    arrow.line.renderOrder = 10;
    arrow.cone.renderOrder = 10;
    return arrow;
  }

  dispose() {
    dispose(this.group);
  }
}
