// The regions of a query as translucent boxes with floating labels.
import {
  BoxGeometry,
  DoubleSide,
  EdgesGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  Quaternion,
  RingGeometry,
  ShaderMaterial,
  Color,
  Vector3,
} from 'three';
import { ROLE_STYLE } from '../palette.js';
import { plural } from '../ui/dom.js';
import { dispose } from './dispose.js';

/** @import {Region, Triple} from '../types/page_data.js' */
/** @import {Label, Query} from '../types/report.js' */

const kAvoid = '#d873c4';
const kWaypoint = '#ffd166';
// Max regions drawn of one list, since a tag may mark thousands of parts.
export const kMaxAlike = 500;
const kMaxNamed = 40; // max labels of one list

/** @typedef {{fill: ShaderMaterial, line: LineBasicMaterial}} Materials */
/** @typedef {Materials & {solid: BoxGeometry, edges: EdgesGeometry}} Look */

/**
 * Returns a material that fades upward, so that a tall box does not hide its contents.
 * @param {string} color
 */
function fillMaterial(color) {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    uniforms: { uColor: { value: new Color(color) } },
    vertexShader:
      'varying float vUp; void main() { vUp = uv.y; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); vUp = position.y + 0.5; }',
    fragmentShader:
      'uniform vec3 uColor; varying float vUp; void main() { gl_FragColor = vec4(uColor, mix(0.26, 0.05, vUp)); }',
  });
}

// Returns a function from a color to shared geometry and materials, since there may be hundreds
// of boxes.
function sharedLooks() {
  const solid = new BoxGeometry(1, 1, 1);
  const edges = new EdgesGeometry(solid);
  /** @type {Map<string, Look>} */
  const looks = new Map();
  return (/** @type {string} */ color) => {
    const known = looks.get(color);
    if (known) return known;
    const line = new LineBasicMaterial({ color, transparent: true, opacity: 0.85 });
    const look = { solid, edges, fill: fillMaterial(color), line };
    looks.set(color, look);
    return look;
  };
}

/**
 * @param {Region} region
 * @param {Look} look
 */
function box(region, { solid, edges, fill, line }) {
  const group = new Group();
  const body = new Mesh(solid, fill);
  body.renderOrder = 3;
  const frame = new LineSegments(edges, line);
  frame.renderOrder = 4;
  group.add(body, frame);
  group.position.fromArray(region.position);
  group.quaternion.copy(new Quaternion().fromArray(region.rotation).normalize());
  group.scale.fromArray(region.size);
  return group;
}

/** @param {Triple} position */
function ring(position) {
  const mesh = new Mesh(
    new RingGeometry(1.5, 1.9, 48).rotateX(-Math.PI / 2),
    fillMaterial(ROLE_STYLE.start.color),
  );
  mesh.material.fragmentShader =
    'uniform vec3 uColor; void main() { gl_FragColor = vec4(uColor, 0.9); }';
  mesh.position.fromArray(position);
  mesh.position.y += 0.06;
  mesh.renderOrder = 3;
  return mesh;
}

/** @param {Region} region */
function top(region) {
  const turn = new Quaternion().fromArray(region.rotation).normalize();
  const half = region.size.map((v) => v / 2);
  const up = [0, 1, 2].reduce((sum, k) => {
    const axis = new Vector3().setComponent(k, half[k]).applyQuaternion(turn);
    return sum + Math.abs(axis.y);
  }, 0);
  return new Vector3().fromArray(region.position).add(new Vector3(0, up + 0.4, 0));
}

export class RegionView {
  /** @param {Query} query */
  constructor(query) {
    this.group = new Group();
    /** @type {Label[]} */
    this.labels = [];
    const lookOf = sharedLooks();
    /**
     * @param {Region} region
     * @param {string} color
     * @param {string} text
     */
    const add = (region, color, text) => {
      this.group.add(box(region, lookOf(color)));
      if (text) this.labels.push({ text, at: top(region), color });
    };
    /**
     * @param {Region[]} regions
     * @param {string} color
     * @param {string} otherwise
     */
    const addAlike = (regions, color, otherwise) =>
      regions
        .slice(0, kMaxAlike)
        .forEach((region, i) => add(region, color, i < kMaxNamed ? region.name || otherwise : ''));
    if (query.start) add(query.start, ROLE_STYLE.start.color, 'Start');
    else if (query.startPosition) {
      this.group.add(ring(query.startPosition));
      this.labels.push({
        text: 'Start',
        at: new Vector3().fromArray(query.startPosition).add(new Vector3(0, 6.4, 0)),
        color: ROLE_STYLE.start.color,
      });
    }
    if (query.goal) add(query.goal, ROLE_STYLE.goal.color, 'Goal');
    addAlike(query.goals, ROLE_STYLE.goal.color, 'Goal');
    query.visits.forEach((region) => add(region, kWaypoint, region.name || 'Visit'));
    query.waypoints.forEach((waypoint, i) => {
      const limit = waypoint.maxJumps >= 0 ? ` · ≤ ${plural(waypoint.maxJumps, 'jump')}` : '';
      add(
        waypoint.region,
        kWaypoint,
        `${i + 1}${waypoint.region.name ? ` ${waypoint.region.name}` : ''}${limit}`,
      );
    });
    addAlike(query.avoid, kAvoid, 'Avoid');
  }

  dispose() {
    dispose(this.group);
  }
}
