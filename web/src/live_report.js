// A report that comes in pieces: what the server says is new is put in its place, and what is there keeps its identity.
import { levelOf, Path, queryOf } from './data.js';

const kFormat = 3; // of the data, as of a page in a file

// Whether one of the ranges, [first, last] and ascending, holds the number. There may be one for each attempt.
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

  // `raw`: an answer of /data. `kept`: trajectories that stay even if the stream has replaced them, for somebody looks at
  // them. Gives {levels, queries}: the indices of those that changed, and `fresh`: the trajectories that are new.
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

  // New trajectories are put behind those in `fresh`.
  takeQuery({ index, facts, serials, trajectories }, kept, fresh) {
    const { queries } = this.report;
    // A new object: what was worked out of the old one does not hold any more.
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
