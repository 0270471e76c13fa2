// A report that arrives in pieces. New data replaces the old, and unchanged objects keep their
// identity.
import { levelOf, queryOf } from './data.js';
import { Path } from './path.js';

/** @import {LivePiece, LiveQuery, StreamState} from './types/page_data.js' */
/** @import {Report} from './types/report.js' */

const kFormat = 4; // data format, as in a page file

/**
 * Returns true if one of the ranges [first, last], ascending, contains the number. There may be
 * one range per attempt.
 * @param {[number, number][]} ranges
 * @param {number} number
 */
function isIn(ranges, number) {
  let [low, high] = [0, ranges.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ranges[middle][1] < number) low = middle + 1;
    else high = middle;
  }
  return low < ranges.length && ranges[low][0] <= number;
}

export class LiveReport {
  constructor() {
    /** @type {Report} */
    this.report = { title: '', notes: [], levels: [], queries: [] };
    this.revision = 0; // revision of the last piece
    /** @type {StreamState} */
    this.state = 'live';
  }

  /**
   * `raw`: an answer of /data. `kept`: trajectories in view, which stay even if the stream has
   * replaced them, except a first solution, which its improved one replaces. Returns {levels, queries}, the indices of the changed ones, and `fresh`, the new
   * trajectories.
   * @param {LivePiece} raw
   * @param {(Path | undefined)[]} kept
   */
  take(raw, kept = []) {
    if (raw.format !== kFormat)
      throw new Error(`its data has format ${raw.format}, expected ${kFormat}; reload the page`);
    const { report } = this;
    /** @type {{levels: Set<number>, queries: Set<number>, fresh: Path[]}} */
    const changed = { levels: new Set(), queries: new Set(), fresh: [] };
    const was = this.state;
    this.revision = raw.revision;
    this.state = raw.head.state;
    Object.assign(report, { title: raw.head.title, notes: raw.head.notes });
    for (const { index, data } of raw.levels) {
      report.levels[index] = levelOf(data);
      changed.levels.add(index);
    }
    for (const piece of raw.queries) {
      this.takeQuery(piece, kept, changed.fresh);
      changed.queries.add(piece.index);
    }
    for (const query of report.queries) {
      query.running = this.state === 'live';
      if (was !== this.state) changed.queries.add(query.index);
    }
    return changed;
  }

  /**
   * Appends new trajectories to `fresh`.
   * @param {LiveQuery} piece
   * @param {(Path | undefined)[]} kept
   * @param {Path[]} fresh
   */
  takeQuery({ index, facts, serials, trajectories }, kept, fresh) {
    const { queries } = this.report;
    // A new object, so that values cached by the old one are dropped.
    const own = queryOf(facts, index);
    const before = queries[index]?.paths ?? [];
    const bySerial = new Map(before.map((path) => [path.serial ?? -1, path]));
    for (const { serial, data } of trajectories) {
      const path = new Path(data, own);
      path.serial = serial;
      if (!bySerial.has(serial)) fresh.push(path);
      bySerial.set(serial, path);
    }
    own.paths = [...bySerial]
      .filter(([serial, path]) => isIn(serials, serial) || (kept.includes(path) && !path.provisional))
      .map(([, path]) => path);
    for (const path of own.paths) path.query = own;
    queries[index] = own;
  }
}
