// A faint grain for each kind of material, in studs. Many of the engine's materials share one.
export const GRAIN = {
  none: 0,
  glow: 1, // emits light
  sheen: 2, // smooth, with slanted streaks of light
  boards: 3, // lines along the part's length
  bricks: 4, // rows, every other one shifted
  speckles: 5, // uneven ground, stone, sand
  plates: 6, // sheets with seams
  weave: 7, // crossing threads
};

/** @type {Partial<Record<keyof typeof GRAIN, string>>} */
const kGrainOf = {
  glow: 'Neon CrackedLava',
  sheen: 'Ice Glacier Glass ForceField Foil Marble',
  boards: 'Wood WoodPlanks',
  bricks: 'Brick Cobblestone Pavement CeramicTiles ClayRoofTiles RoofShingles',
  speckles:
    'Grass LeafyGrass Sand Sandstone Snow Mud Ground Asphalt Concrete Granite Slate Rock Basalt Pebble Limestone Salt Plaster',
  plates: 'Metal DiamondPlate CorrodedMetal',
  weave: 'Fabric Carpet Leather Cardboard Rubber',
};

/** @type {Map<string, number>} */
const grains = new Map();
for (const grain of /** @type {(keyof typeof GRAIN)[]} */ (Object.keys(GRAIN)))
  for (const name of kGrainOf[grain]?.split(' ') ?? []) grains.set(name, GRAIN[grain]);

/** @param {string} material */
export const grainOf = (material) => grains.get(material) ?? GRAIN.none;

// Factors of a point's brightness; `uv` in studs on the face.
export const GRAIN_SHADER = `
float random(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }
// A dark line at integers of v with half width thin, faded out where finer than a pixel.
float seam(float v, float thin) {
  float w = fwidth(v);
  float d = 0.5 - abs(fract(v) - 0.5);
  return (1.0 - smoothstep(thin, thin + w, d)) * (1.0 - smoothstep(0.15, 0.5, w));
}
// Value noise on a lattice.
float cloud(vec2 p) {
  vec2 i = floor(p);
  vec2 f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  float low = mix(random(i), random(i + vec2(1.0, 0.0)), f.x);
  float high = mix(random(i + vec2(0.0, 1.0)), random(i + vec2(1.0, 1.0)), f.x);
  return mix(low, high, f.y);
}
float grain(vec2 uv, vec2 half_) {
  float far = 1.0 - smoothstep(0.2, 1.2, fwidth(uv.x) + fwidth(uv.y));
  if (vGrain < 0.5) return 0.0;
  if (vGrain < 1.5) return 0.0;
  if (vGrain < 2.5) return 0.22 * smoothstep(0.72, 0.8, fract((uv.x + uv.y) / 5.0)) * far;
  if (vGrain < 3.5) {
    vec2 board = half_.x >= half_.y ? uv.yx : uv;
    float shade = 0.16 * (random(vec2(floor(board.x), 3.0)) - 0.5);
    float fibre = 0.14 * (cloud(vec2(board.x * 9.0, board.y * 0.7)) - 0.5);
    return (shade + fibre) * far - 0.3 * seam(board.x, 0.03);
  }
  if (vGrain < 4.5) {
    float course = floor(uv.y);
    float along = uv.x / 2.0 + 0.5 * mod(course, 2.0);
    float shade = 0.2 * (random(vec2(floor(along), course)) - 0.5) * far;
    return shade - 0.3 * max(seam(uv.y, 0.05), seam(along, 0.025));
  }
  if (vGrain < 5.5) return (0.3 * cloud(uv * 1.7) + 0.2 * cloud(uv * 6.0) - 0.25) * far;
  if (vGrain < 6.5) {
    float brushed = 0.1 * (cloud(vec2(uv.x * 0.6, uv.y * 14.0)) - 0.5) * far;
    return brushed - 0.25 * max(seam(uv.x / 4.0, 0.008), seam(uv.y / 4.0, 0.008));
  }
  vec2 thread = floor(uv * 3.0);
  return 0.14 * (mod(thread.x + thread.y, 2.0) - 0.5) * (1.0 - smoothstep(0.1, 0.4, fwidth(uv.x * 3.0) + fwidth(uv.y * 3.0)));
}
`;
