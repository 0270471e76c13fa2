// The material of parts: soft light, fine edges, and a pattern per role in studs, so that roles
// are distinguishable without colour: stripes for kill, chevrons for carry, rings for throw,
// checks for the goal, dots for vanishing.
import { DoubleSide, FrontSide, MeshLambertMaterial } from 'three';
import { GRAIN_SHADER } from './material_hints.js';

/** @import {IUniform} from 'three' */
/** @import {Role} from '../types/page_data.js' */

export const PATTERN = { none: 0, stripes: 1, chevrons: 2, rings: 3, checks: 4, dots: 5 };
/** @type {Partial<Record<Role, number>>} */
export const ROLE_PATTERN = {
  kill: PATTERN.stripes,
  conveyor: PATTERN.chevrons,
  pad: PATTERN.rings,
  goal: PATTERN.checks,
  vanish: PATTERN.dots,
};

const VERTEX_HEAD = `
attribute float aPattern; attribute float aAlpha; attribute float aGlow; attribute float aGrain;
attribute vec3 aFlow;
varying vec3 vLocal; varying vec3 vHalf; varying vec3 vFace; varying vec3 vFlow;
varying float vPattern; varying float vAlpha; varying float vGlow; varying float vGrain;
`;
const VERTEX_BODY = `
vec3 partScale = vec3(length(instanceMatrix[0].xyz), length(instanceMatrix[1].xyz), length(instanceMatrix[2].xyz));
vLocal = position * partScale; vHalf = 0.5 * partScale; vFace = normal; vFlow = aFlow;
vPattern = aPattern; vAlpha = aAlpha; vGlow = aGlow; vGrain = aGrain;
`;
const FRAGMENT_HEAD = `
varying vec3 vLocal; varying vec3 vHalf; varying vec3 vFace; varying vec3 vFlow;
varying float vPattern; varying float vAlpha; varying float vGlow; varying float vGrain;
uniform float uTime; uniform float uPatterns; uniform float uGrain;
vec2 faceUv(vec3 p) {
  vec3 n = abs(vFace);
  return n.y > n.x && n.y > n.z ? p.xz : n.x > n.z ? p.zy : p.xy;
}
${GRAIN_SHADER}
// Rises from 0 to 1 across an edge at 0.5, smooth at any distance. Stripes finer than a pixel get
// their mean.
float band(float v) {
  float w = fwidth(v);
  float s = abs(fract(v) - 0.5) * 2.0;
  return mix(smoothstep(0.5 - w, 0.5 + w, s), 0.5, smoothstep(0.4, 1.0, w));
}
float pattern() {
  vec2 uv = faceUv(vLocal);
  if (vPattern < 0.5) return 0.0;
  if (vPattern < 1.5) return band((uv.x + uv.y) / 2.2);
  if (vPattern < 2.5) {
    float speed = length(vFlow);
    vec3 along = vFlow / max(speed, 1e-3);
    vec2 side = faceUv(vLocal - along * dot(vLocal, along));
    return band((dot(vLocal, along) - 0.7 * length(side)) / 4.0 - uTime * speed / 4.0);
  }
  if (vPattern < 3.5) return band(length(uv) / 1.6 - uTime * 0.8);
  if (vPattern < 4.5) return abs(band(uv.x / 4.0 + 0.25) - band(uv.y / 4.0 + 0.25));
  vec2 cell = fract(uv / 1.5) - 0.5;
  float w = fwidth(uv.x + uv.y) / 1.5;
  return mix(smoothstep(0.24 + w, 0.24 - w, length(cell)), 0.2, smoothstep(0.3, 0.8, w));
}
float edge() {
  vec3 gap = vHalf - abs(vLocal);
  gap += step(0.99, abs(vFace)) * 1e4;
  float d = min(gap.x, min(gap.y, gap.z));
  float w = max(fwidth(d), 1e-5);
  float thin = min(vHalf.x, min(vHalf.y, vHalf.z));
  return (1.0 - smoothstep(0.6 * w, 1.6 * w, d)) * (1.0 - smoothstep(0.25, 0.8, w / max(thin, 0.3)));
}
`;
const FRAGMENT_BODY = `
diffuseColor.rgb *= 1.0 + uGrain * grain(faceUv(vLocal), faceUv(vHalf));
float mark = pattern() * uPatterns;
diffuseColor.rgb = mix(diffuseColor.rgb, vPattern > 3.5 && vPattern < 4.5 ? diffuseColor.rgb * 1.5 + 0.05
  : diffuseColor.rgb * (vPattern < 1.5 ? 0.74 : 0.62), mark);
#ifdef OBBY_LATTICE
  vec2 cell = fract(faceUv(vLocal) / 2.0);
  vec2 rim = min(cell, 1.0 - cell);
  if (min(min(rim.x, rim.y), min(abs(cell.x - cell.y), abs(cell.x + cell.y - 1.0)) * 0.7) > 0.085) discard;
#endif
#ifdef OBBY_EDGES
  diffuseColor.rgb = mix(diffuseColor.rgb, diffuseColor.rgb * 1.35 + 0.05, edge());
#endif
diffuseColor.rgb += vGlow * vec3(0.16, 0.16, 0.13);
diffuseColor.a *= vAlpha;
`;

const SHINE = `
if (vGrain > 0.5 && vGrain < 1.5) totalEmissiveRadiance += uGrain * 0.5 * diffuseColor.rgb;
`;

/**
 * All materials share `uniforms`: uTime in seconds of play; uPatterns (roles) and uGrain
 * (materials) from 0 to 1.
 * @param {string} shape
 * @param {boolean} translucent
 * @param {Record<string, IUniform<number>>} uniforms
 */
export function partMaterial(shape, translucent, uniforms) {
  const lattice = shape === 'truss';
  const material = new MeshLambertMaterial({
    transparent: translucent,
    depthWrite: !translucent,
    side: lattice ? DoubleSide : FrontSide,
  });
  const edges = ['block', 'wedge', 'cornerWedge', 'truss'].includes(shape);
  material.defines = {
    ...(lattice && { OBBY_LATTICE: '' }),
    ...(edges && { OBBY_EDGES: '' }),
  };
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader =
      VERTEX_HEAD +
      shader.vertexShader.replace(
        '#include <begin_vertex>',
        `#include <begin_vertex>\n${VERTEX_BODY}`,
      );
    shader.fragmentShader =
      FRAGMENT_HEAD +
      shader.fragmentShader.replace(
        '#include <color_fragment>',
        `#include <color_fragment>\n${FRAGMENT_BODY}`,
      );
    shader.fragmentShader = shader.fragmentShader.replace(
      '#include <emissivemap_fragment>',
      `#include <emissivemap_fragment>\n${SHINE}`,
    );
  };
  material.customProgramCacheKey = () => `${lattice} ${edges}`;
  return material;
}
