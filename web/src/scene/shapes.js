// Unit geometries of the part shapes, and the scale of each part. Unit geometries have extent 1
// on each axis.
import {
  BoxGeometry,
  BufferGeometry,
  CylinderGeometry,
  Float32BufferAttribute,
  SphereGeometry,
  Vector3,
} from 'three';
import { ConvexGeometry } from 'three/addons/geometries/ConvexGeometry.js';

/** @import {Shape, Triple} from '../types/page_data.js' */

/**
 * Builds triangles with flat normals from corner letters.
 * @param {Record<string, Triple>} corners
 * @param {string[][]} triangles
 */
function faceted(corners, triangles) {
  const positions = triangles.flatMap((triangle) =>
    triangle.flatMap((corner) => corners[corner].map((v) => v / 2)),
  );
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.computeVertexNormals();
  return geometry;
}

function wedge() {
  /** @type {Record<string, Triple>} */
  const corners = {
    a: [-1, -1, -1],
    b: [1, -1, -1],
    c: [1, -1, 1],
    d: [-1, -1, 1],
    e: [-1, 1, 1],
    f: [1, 1, 1],
  };
  return faceted(corners, [
    ['a', 'b', 'c'],
    ['a', 'c', 'd'], // floor
    ['d', 'c', 'f'],
    ['d', 'f', 'e'], // back
    ['a', 'e', 'f'],
    ['a', 'f', 'b'], // slope
    ['b', 'f', 'c'],
    ['a', 'd', 'e'], // sides
  ]);
}

function cornerWedge() {
  /** @type {Record<string, Triple>} */
  const corners = {
    a: [-1, -1, -1],
    b: [1, -1, -1],
    c: [1, -1, 1],
    d: [-1, -1, 1],
    top: [1, 1, -1],
  };
  return faceted(corners, [
    ['a', 'b', 'c'],
    ['a', 'c', 'd'],
    ['a', 'top', 'b'],
    ['b', 'top', 'c'],
    ['c', 'top', 'd'],
    ['d', 'top', 'a'],
  ]);
}

/** @param {string} shape */
export function unitGeometry(shape) {
  switch (shape) {
    case 'ball':
      return new SphereGeometry(0.5, 28, 18);
    case 'cylinder':
      return new CylinderGeometry(0.5, 0.5, 1, 36).rotateZ(Math.PI / 2).toNonIndexed();
    case 'wedge':
      return wedge();
    case 'cornerWedge':
      return cornerWedge();
    default:
      return new BoxGeometry(1, 1, 1);
  }
}

/**
 * Returns true if the points are collinear.
 * @param {Vector3[]} points
 */
function inLine(points) {
  const from = (/** @type {Vector3} */ point) => point.clone().sub(points[0]);
  let span = new Vector3();
  for (const point of points) if (from(point).lengthSq() > span.lengthSq()) span = from(point);
  const min = 1e-14 * span.lengthSq() ** 2; // rounding tolerance; thin shapes are still visible
  return points.every((point) => from(point).cross(span).lengthSq() <= min);
}

/**
 * `vertices`: studs from the part's centre. A hull that is a point or a line is invisible.
 * @param {Float32Array} vertices
 */
export function hullGeometry(vertices) {
  const points = [];
  for (let i = 0; i + 2 < vertices.length; i += 3)
    points.push(new Vector3().fromArray(vertices, i));
  return inLine(points) ? faceted({}, []) : new ConvexGeometry(points);
}

/**
 * @param {Shape} shape
 * @param {Float32Array} size
 * @returns {Triple}
 */
export function scaleOf(shape, [x, y, z]) {
  const at = (/** @type {number} */ value) => Math.max(value, 0.05);
  const min = at(Math.min(x, y, z));
  if (shape === 'ball') return [min, min, min];
  if (shape === 'cylinder') return [at(x), at(Math.min(y, z)), at(Math.min(y, z))];
  if (shape === 'hull') return [1, 1, 1];
  return [at(x), at(y), at(z)];
}
