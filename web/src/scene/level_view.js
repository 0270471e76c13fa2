// The level in 3D, with an InstancedMesh for each shape, translucency and mobility. Moving and
// vanishing parts follow the level clock.
import {
  Color,
  DynamicDrawUsage,
  Group,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  Quaternion,
  StaticDrawUsage,
  Vector3,
} from 'three';
import { ROLES, SHAPES } from '../data.js';
import { ROLE_STYLE } from '../palette.js';
import { grainOf } from './material_hints.js';
import { partMaterial, ROLE_PATTERN } from './part_material.js';
import { hullGeometry, scaleOf, unitGeometry } from './shapes.js';
import { timedAway } from './vanishing.js';

/** @import {BufferGeometry, Object3D} from 'three' */
/** @import {BodyTrack} from '../tracks.js' */
/** @import {Solids} from './solids.js' */
/** @import {Between, ColorMode, Level} from '../types/report.js' */

const kNeutral = new Color('#808998');
const kFaint = 0.1; // opacity of a vanished part

/**
 * An attribute of the shader.
 * @typedef {'aPattern' | 'aAlpha' | 'aGlow' | 'aGrain' | 'aFlow'} Name
 */
/** @typedef {InstancedMesh & {own: Record<Name, InstancedBufferAttribute>}} PartMesh */

/**
 * Returns the parts of a mesh, by instance.
 * @param {Object3D} mesh
 * @returns {number[]}
 */
export const partsOf = (mesh) => mesh.userData.parts;

export class LevelView {
  /**
   * `colors`: 'roles', or 'level' for the parts' own colours.
   * @param {Level} level
   * @param {ColorMode} colors
   * @param {Solids} solids told of each change
   */
  constructor(level, colors, solids) {
    this.level = level;
    this.solids = solids;
    this.group = new Group();
    this.uniforms = { uTime: { value: 0 }, uPatterns: { value: 1 }, uGrain: { value: 1 } };
    /** @type {PartMesh[]} */
    this.meshes = [];
    /** @type {{mesh: PartMesh, at: number}[][]} */
    this.slots = Array.from({ length: level.count }, () => []); // instances of each part
    this.trackOf = new Map(level.tracks.map((track) => [track.part, track]));
    this.vanishOf = new Map(level.vanish.map((rule) => [rule.part, rule]));
    this.bodies = new Set(level.bodies);
    /** @type {number[]} */
    this.displaced = []; // dynamic parts away from their place in the level
    this.flowOf = new Map(level.conveyors.map((belt) => [belt.part, belt.velocity]));
    this.build();
    this.setColors(colors);
  }

  /** @param {number} part */
  shapeOf(part) {
    return SHAPES[this.level.shape[part]];
  }

  /** @param {number} part */
  roleOf(part) {
    return ROLES[this.level.role[part]];
  }

  /**
   * Parts with equal keys share a mesh.
   * @param {number} part
   */
  keyOf(part) {
    const alpha = this.level.look[4 * part + 3];
    const translucent = alpha < 250 || this.vanishOf.has(part) || this.roleOf(part) === 'ghost';
    const moves = this.trackOf.has(part) || this.bodies.has(part);
    return `${this.shapeOf(part)} ${translucent ? 'translucent' : 'opaque'} ${moves ? 'moving' : 'still'}`;
  }

  build() {
    /** @type {Map<string, number[]>} */
    const groups = new Map();
    /** @type {Map<string, {piece: Float32Array, key: string, parts: number[]}>} */
    const alike = new Map(); // merges equal hull pieces: a place has many copies of one mesh
    const hullsOf = new Map(this.level.hulls.map((hull) => [hull.part, hull.pieces]));
    for (let part = 0; part < this.level.count; part++) {
      const key = this.keyOf(part);
      const pieces = this.shapeOf(part) === 'hull' ? (hullsOf.get(part) ?? []) : [];
      for (const piece of pieces) {
        const same = `${key} ${piece.join()}`;
        const group = alike.get(same) ?? { piece, key, parts: [] };
        group.parts.push(part);
        alike.set(same, group);
      }
      if (pieces.length) continue;
      const group = groups.get(key) ?? [];
      group.push(part);
      groups.set(key, group);
    }
    for (const { piece, key, parts } of alike.values())
      this.addMesh(hullGeometry(piece), key, parts);
    for (const [key, parts] of groups) this.addMesh(unitGeometry(key.split(' ')[0]), key, parts);
  }

  /**
   * @param {BufferGeometry} geometry
   * @param {string} key
   * @param {number[]} parts
   */
  addMesh(geometry, key, parts) {
    const [shape, look, mobility] = key.split(' ');
    const mesh = new InstancedMesh(
      geometry,
      partMaterial(shape, look === 'translucent', this.uniforms),
      parts.length,
    );
    const usage = mobility === 'moving' ? DynamicDrawUsage : StaticDrawUsage;
    mesh.instanceMatrix.setUsage(usage);
    mesh.frustumCulled = mobility === 'still';
    mesh.renderOrder = look === 'translucent' ? 1 : 0;
    mesh.userData.parts = parts;
    mesh.castShadow = look === 'opaque' && shape !== 'truss';
    mesh.receiveShadow = true;
    const attribute = (/** @type {Name} */ name, /** @type {number} */ width) => {
      const own = new InstancedBufferAttribute(new Float32Array(parts.length * width), width);
      geometry.setAttribute(name, own);
      return own;
    };
    const own = {
      aPattern: attribute('aPattern', 1),
      aAlpha: attribute('aAlpha', 1),
      aGlow: attribute('aGlow', 1),
      aGrain: attribute('aGrain', 1),
      aFlow: attribute('aFlow', 3),
    };
    const partMesh = Object.assign(mesh, { own });
    parts.forEach((part, at) => this.place(partMesh, at, part));
    this.meshes.push(partMesh);
    this.group.add(partMesh);
  }

  /**
   * @param {PartMesh} mesh
   * @param {number} at
   * @param {number} part
   */
  place(mesh, at, part) {
    this.slots[part].push({ mesh, at });
    const { position, rotation, size } = this.level;
    const shape = this.shapeOf(part);
    const turn = new Quaternion().fromArray(rotation, 4 * part).normalize();
    const scale = new Vector3(...scaleOf(shape, size.subarray(3 * part, 3 * part + 3)));
    mesh.setMatrixAt(
      at,
      new Matrix4().compose(new Vector3().fromArray(position, 3 * part), turn, scale),
    );
    mesh.own.aPattern.setX(at, ROLE_PATTERN[this.roleOf(part)] ?? 0);
    mesh.own.aAlpha.setX(at, this.alphaOf(part));
    const material = this.level.materials[this.level.material[part] ?? 0];
    mesh.own.aGrain.setX(at, grainOf(material));
    const flow = this.flowOf.get(part);
    if (flow) {
      const local = new Vector3(...flow).applyQuaternion(turn.clone().invert());
      mesh.own.aFlow.setXYZ(at, local.x, local.y, local.z);
    }
  }

  /** @param {number} part */
  alphaOf(part) {
    const alpha = this.level.look[4 * part + 3] / 255;
    // An invisible part still affects the player, so it is shown faintly.
    return Math.max(alpha, this.roleOf(part) === 'plain' ? 0.12 : 0.3);
  }

  /** @param {ColorMode} mode */
  setColors(mode) {
    const color = new Color();
    const own = new Color();
    this.uniforms.uPatterns.value = mode === 'roles' ? 1 : 0.5;
    this.uniforms.uGrain.value = mode === 'roles' ? 0.5 : 1;
    for (let part = 0; part < this.level.count; part++) {
      const look = this.level.look;
      own.setRGB(look[4 * part] / 255, look[4 * part + 1] / 255, look[4 * part + 2] / 255, 'srgb');
      const role = this.roleOf(part);
      if (mode === 'level') color.copy(own);
      else if (role === 'plain') color.copy(own).lerp(kNeutral, 0.68);
      else color.set(ROLE_STYLE[role].color);
      for (const { mesh, at } of this.slots[part]) mesh.setColorAt(at, color);
    }
    for (const { instanceColor } of this.meshes)
      if (instanceColor) instanceColor.needsUpdate = true;
  }

  /**
   * `tick`: tick of the level clock. `gone`: parts that the trajectory's events have made vanish.
   * `moved`: ticks since the start of each triggered part in motion.
   * @param {number} tick
   * @param {{has: (part: number) => boolean}} gone
   * @param {Map<number, number>} moved
   */
  update(tick, gone, moved) {
    this.uniforms.uTime.value = tick / this.level.tickRate;
    for (const [part, track] of this.trackOf) {
      this.pose(part, track.at(track.triggered ? (moved.get(part) ?? 0) : tick), track);
    }
    for (const [part, rule] of this.vanishOf) {
      const away = rule.trigger === 'timer' ? timedAway(rule, tick) : gone.has(part);
      this.setAttribute(part, 'aAlpha', away ? kFaint : this.alphaOf(part));
      this.solids.setAway(part, away);
    }
  }

  /**
   * `tracks`: poses of the dynamic parts that the trajectory moves; `tick`: ticks since its
   * start.
   * @param {BodyTrack[]} tracks
   * @param {number} tick
   */
  updateBodies(tracks, tick) {
    for (const part of this.displaced)
      this.pose(part, { i: part, next: part, share: 0 }, this.level);
    for (const track of tracks) this.pose(track.part, track.at(tick), track);
    this.displaced = tracks.map((track) => track.part);
  }

  /**
   * @param {number} part
   * @param {Between} between
   * @param {{position: Float32Array | null, rotation: Float32Array | Int16Array | null}} track
   */
  pose(part, { i, next, share }, track) {
    const matrix = new Matrix4();
    for (const { mesh, at } of this.slots[part]) {
      const position = new Vector3();
      const rotation = new Quaternion();
      const scale = new Vector3();
      mesh.getMatrixAt(at, matrix);
      matrix.decompose(position, rotation, scale);
      if (track.position) {
        position
          .fromArray(track.position, 3 * i)
          .lerp(new Vector3().fromArray(track.position, 3 * next), share);
      }
      if (track.rotation) {
        rotation
          .fromArray(track.rotation, 4 * i)
          .normalize()
          .slerp(new Quaternion().fromArray(track.rotation, 4 * next).normalize(), share);
      }
      mesh.setMatrixAt(at, matrix.compose(position, rotation, scale));
      this.solids.place(part, position, rotation);
      mesh.instanceMatrix.needsUpdate = true;
      mesh.boundingSphere = null; // outdated: rays would miss parts that moved
    }
  }

  /**
   * @param {number} part
   * @param {Name} name
   * @param {number} value
   */
  setAttribute(part, name, value) {
    for (const { mesh, at } of this.slots[part] ?? []) {
      const attribute = mesh.own[name];
      if (attribute.getX(at) !== value) {
        attribute.setX(at, value);
        attribute.needsUpdate = true;
      }
    }
  }

  /**
   * @param {number} part
   * @param {boolean} on
   */
  glow(part, on) {
    if (part >= 0) this.setAttribute(part, 'aGlow', on ? 1 : 0);
  }

  /**
   * Returns the centre of a part as currently drawn.
   * @param {number} part
   */
  centreOf(part) {
    const { mesh, at } = this.slots[part][0];
    const matrix = new Matrix4();
    mesh.getMatrixAt(at, matrix);
    return new Vector3().setFromMatrixPosition(matrix);
  }
}
