// Parses the report inside the page. Base64 blocks become typed arrays, and runs of actions are
// looked up by tick. docs/page-data.md describes the format.
import { bytes, floats, longs } from './bytes.js';
import { ROLE_STYLE } from './palette.js';
import { Path } from './path.js';
import { Track } from './tracks.js';

/** @import {LevelData, PageData, QueryFacts, ResultData, Role, Shape} from './types/page_data.js' */
/** @import {Level, Query, Report, Result} from './types/report.js' */

/** @type {Shape[]} */
export const SHAPES = ['block', 'ball', 'cylinder', 'wedge', 'cornerWedge', 'truss', 'hull'];
// Roles by code.
export const ROLES = /** @type {Role[]} */ (Object.keys(ROLE_STYLE));

/**
 * Here and below, base64 texts are dropped once typed arrays replace them.
 * @param {LevelData} raw
 * @returns {Level}
 */
export function levelOf({ parts, tracks, hulls, ...rest }) {
  return {
    ...rest,
    count: parts.count,
    position: floats(parts.position),
    rotation: floats(parts.rotation),
    size: floats(parts.size),
    shape: bytes(parts.shape),
    role: bytes(parts.role),
    look: bytes(parts.look),
    flags: bytes(parts.flags),
    material: bytes(parts.material),
    materials: parts.materials ?? [''],
    tracks: tracks.map((track) => new Track(track)),
    hulls: hulls.map((hull) => ({ part: hull.part, pieces: hull.pieces.map(floats) })),
  };
}

/**
 * Returns true if parts of the level act by the level clock.
 * @param {Level | undefined} level
 */
export const hasMotion = (level) =>
  Boolean(level?.tracks.length || level?.vanish.length || level?.conveyors.length);

/**
 * @param {ResultData | null} raw
 * @returns {Result | null}
 */
function resultOf(raw) {
  if (!raw) return null;
  const { heatMap, ...facts } = raw;
  if (!heatMap) return facts;
  const { size, feet, counts } = heatMap;
  return { ...facts, heatMap: { size, feet: floats(feet), counts: longs(counts) } };
}

/**
 * Returns a query without its trajectories.
 * @param {QueryFacts} facts
 * @param {number} index
 * @returns {Query}
 */
export const queryOf = (facts, index) => ({
  ...facts,
  index,
  result: resultOf(facts.result),
  paths: [],
});

/**
 * @param {PageData} raw
 * @returns {Report}
 */
export function readReport(raw) {
  const levels = raw.levels.map(levelOf);
  const queries = raw.queries.map(({ trajectories, ...facts }, index) => {
    const own = queryOf(facts, index);
    own.paths = trajectories.map((path) => new Path(path, own));
    return own;
  });
  return { title: raw.title, notes: raw.notes, levels, queries };
}
