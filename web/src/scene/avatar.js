// The player: torso, head, arms and legs of the simulated body, with a simple walk that shows
// facing and pace.
import {
  BoxGeometry,
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  Mesh,
  MeshLambertMaterial,
  Points,
  PointsMaterial,
} from 'three';
import { GHOST_COLOR } from '../palette.js';
import { glyphTexture } from './markers.js';

/** @import {Material, MeshLambertMaterialParameters} from 'three' */
/** @import {Body} from '../types/page_data.js' */
/** @import {Pose} from '../types/report.js' */

/**
 * @param {number} width
 * @param {number} height
 * @param {number} depth
 * @param {Material} material
 * @param {number} x
 * @param {number} y
 */
function limb(width, height, depth, material, x, y) {
  // The pivot is the limb's top, so that it swings at the hip or shoulder.
  const geometry = new BoxGeometry(width, height, depth).translate(0, -height / 2, 0);
  const mesh = new Mesh(geometry, material);
  mesh.position.set(x, y, 0);
  return mesh;
}

// The ghost of a comparison has one translucent colour.
const kGhost = { color: GHOST_COLOR, emissive: '#16384a', transparent: true, opacity: 0.5 };

export class Avatar {
  /** @param {Body} body */
  constructor(body, ghost = false) {
    const material = (/** @type {MeshLambertMaterialParameters} */ look) =>
      new MeshLambertMaterial(ghost ? kGhost : look);
    const skin = material({ color: '#ffd7a3', emissive: '#3a2c18' });
    const shirt = material({ color: '#f4f6fb', emissive: '#3c4048' });
    const trousers = material({ color: '#2f3c5c', emissive: '#0c0f16' });
    const w = body.width / 2;
    const hip = body.hip;
    const neck = body.neck;
    this.group = new Group();
    const torso = new Mesh(new BoxGeometry(body.width, neck - hip, body.depth), shirt);
    torso.position.y = (neck + hip) / 2;
    const headSize = Math.max(0.3, body.top - neck);
    const head = new Mesh(new BoxGeometry(headSize * 1.1, headSize, headSize * 1.1), skin);
    head.position.y = neck + headSize / 2;
    const visor = new Mesh(new BoxGeometry(headSize * 0.8, headSize * 0.28, 0.08), trousers);
    visor.position.set(0, neck + headSize * 0.6, -headSize * 0.56);
    const armWidth = Math.max(0.2, (body.span - body.width) / 2);
    this.arms = [-1, 1].map((side) =>
      limb(armWidth, neck - hip, body.depth, skin, side * (w + armWidth / 2), neck),
    );
    this.legs = [-1, 1].map((side) =>
      limb(w * 0.98, hip, body.depth * 0.98, trousers, (side * w) / 2, hip),
    );
    this.group.add(torso, head, visor, ...this.arms, ...this.legs);
    this.group.add(this.pointer(body.top + 1.6, ghost ? GHOST_COLOR : '#ffffff'));
    this.stride = Math.max(2, hip * 2.4);
  }

  /**
   * Adds a marker above the head that is visible through solids.
   * @param {number} height
   * @param {string} color
   */
  pointer(height, color) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute([0, height, 0], 3));
    const sign = new Points(
      geometry,
      new PointsMaterial({
        map: glyphTexture('down', color),
        size: 22 * Math.min(devicePixelRatio, 2),
        sizeAttenuation: false,
        transparent: true,
        depthTest: false,
        depthWrite: false,
      }),
    );
    sign.renderOrder = 20;
    sign.frustumCulled = false;
    return sign;
  }

  /**
   * `travelled`: studs walked since the start, for the phase of the steps.
   * @param {Pose} pose
   * @param {number} speed
   * @param {boolean} airborne
   * @param {number} travelled
   */
  pose({ x, y, z, yaw }, speed, airborne, travelled) {
    this.group.position.set(x, y, z);
    this.group.rotation.y = yaw;
    const reach = airborne ? 0 : Math.min(0.75, speed / 22);
    const swing = Math.sin((travelled / this.stride) * Math.PI) * reach;
    this.legs[0].rotation.x = airborne ? 0.35 : swing;
    this.legs[1].rotation.x = airborne ? -0.25 : -swing;
    this.arms[0].rotation.x = airborne ? 2.6 : -swing;
    this.arms[1].rotation.x = airborne ? 2.6 : swing;
  }
}
