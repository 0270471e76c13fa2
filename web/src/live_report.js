// A report that arrives in pieces. New data replaces the old, and unchanged objects keep their
// identity.
import { levelOf, Path, queryOf } from './data.js';

const kFormat = 3; // data format, as in a page file

// Returns true if one of the ranges [first, last], ascending, contains the number. There may be one
// for each attempt.
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
    this.report = { title: '', notes: [], levels: [], queries: [] };
    this.revision = 0; // of the last piece
    this.state = 'live';
  }

  // `raw`: an answer of /data. `kept`: trajectories in view, which stay even if the stream has
  // replaced them. Returns {levels, queries}, the indices of the changed ones, and `fresh`, the new
  // trajectories.
  take(raw, kept = []) {
    if (raw.format !== kFormat)
      throw new Error(`its data has format ${raw.format}, expected ${kFormat}; reload the page`);
    const { report } = this;
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

  // Appends new trajectories to `fresh`.
  takeQuery({ index, facts, serials, trajectories }, kept, fresh) {
    const { queries } = this.report;
    // A new object, so that values cached by the old one are dropped.
    const own = queryOf(facts, index);
    const bySerial = new Map((queries[index]?.paths ?? []).map((path) => [path.serial, path]));
    for (const { serial, data } of trajectories) {
      const path = new Path(data, own);
      path.serial = serial;
      if (!bySerial.has(serial)) fresh.push(path);
      bySerial.set(serial, path);
    }
    own.paths = [...bySerial.values()].filter(
      (path) => isIn(serials, path.serial) || kept.includes(path),
    );
    for (const path of own.paths) path.query = own;
    queries[index] = own;
  }
}
