// A report that comes in pieces: what the server says is new is put in its place, and what is there keeps its identity.
import { levelOf, Path, queryOf } from './data.js';

const kFormat = 3; // of the data, as of a page in a file

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
      throw new Error(`data of format ${raw.format}, expected ${kFormat}`);
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
      changed.fresh.push(...this.takeQuery(piece, kept));
      changed.queries.add(piece.index);
    }
    for (const query of report.queries) {
      query.running = this.state === 'live' && Boolean(query.progress);
      if (was !== this.state) changed.queries.add(query.index);
    }
    return changed;
  }

  takeQuery({ index, facts, serials, trajectories }, kept) {
    const { queries } = this.report;
    // A new object: what was worked out of the old one does not hold any more.
    const own = queryOf(facts, index);
    const bySerial = new Map((queries[index]?.paths ?? []).map((path) => [path.serial, path]));
    const fresh = [];
    for (const { serial, data } of trajectories) {
      const path = new Path(data, own);
      path.serial = serial;
      if (!bySerial.has(serial)) fresh.push(path);
      bySerial.set(serial, path);
    }
    const there = ({ serial }) =>
      serials.some(([first, last]) => serial >= first && serial <= last);
    own.paths = [...bySerial.values()].filter((path) => there(path) || kept.includes(path));
    for (const path of own.paths) path.query = own;
    queries[index] = own;
    return fresh;
  }
}
