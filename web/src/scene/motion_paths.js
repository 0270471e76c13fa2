// The motion of moving parts as dashed lines.
import { BufferGeometry, Float32BufferAttribute, Group, Line, LineDashedMaterial } from 'three';
import { ROLE_STYLE } from '../palette.js';
import { corners } from './straight.js';

/** @import {Level} from '../types/report.js' */

/** @param {Level} level */
export function pathsOfMotion(level) {
  const group = new Group();
  const material = new LineDashedMaterial({
    color: ROLE_STYLE.moving.color,
    dashSize: 0.6,
    gapSize: 0.5,
    transparent: true,
    opacity: 0.45,
    depthWrite: false,
  });
  for (const track of level.tracks) {
    if (!track.position) continue;
    const geometry = new BufferGeometry();
    // A browser without a GPU draws about 400 line segments a ms, and a track has a sample per
    // tick.
    geometry.setAttribute('position', new Float32BufferAttribute(corners(track.position), 3));
    const line = new Line(geometry, material);
    line.computeLineDistances();
    group.add(line);
  }
  return group;
}
