// The ways of moving parts as dashed lines.
import { BufferGeometry, Float32BufferAttribute, Group, Line, LineDashedMaterial } from 'three';
import { ROLE_STYLE } from '../palette.js';

export function pathsOfMotion(level) {
  const group = new Group();
  for (const track of level.tracks) {
    if (!track.position) continue;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(track.position, 3));
    const line = new Line(
      geometry,
      new LineDashedMaterial({
        color: ROLE_STYLE.moving.color,
        dashSize: 0.6,
        gapSize: 0.5,
        transparent: true,
        opacity: 0.45,
        depthWrite: false,
      }),
    );
    line.computeLineDistances();
    group.add(line);
  }
  return group;
}
