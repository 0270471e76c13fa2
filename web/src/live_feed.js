// The connection to obby-view --live. Events announce new revisions, which are then fetched.

/** @import {LivePiece} from './types/page_data.js' */

const kAgain = 1000; // ms until a lost connection is retried
// Pause after a piece, in multiples of its processing time. It keeps the page responsive.
const kIdle = 2;

/** @param {number} ms */
const pause = (ms) => new Promise((done) => setTimeout(done, ms));

export class LiveFeed {
  /**
   * @param {object} page
   * @param {() => number} page.revisionOf returns the page's revision
   * @param {(raw: LivePiece) => void} page.take processes an answer of /data
   * @param {(connected: boolean) => void} page.tell reports whether the connection is up
   * @param {(error: unknown) => void} page.fail gets the error if `take` throws
   */
  constructor({ revisionOf, take, tell, fail }) {
    this.revisionOf = revisionOf;
    this.take = take;
    this.tell = tell;
    this.fail = fail;
    this.token = new URLSearchParams(location.search).get('token') ?? '';
    this.newest = 0; // the server's revision
    this.closed = false;
    this.busy = false;
    /** @type {EventSource | undefined} */
    this.events = undefined;
    /** @type {number | undefined} */
    this.again = undefined; // timer of the next try
  }

  /** @param {string} path */
  address(path, more = '') {
    return `${path}?token=${encodeURIComponent(this.token)}${more}`;
  }

  open() {
    this.events = new EventSource(this.address('events'));
    this.events.onopen = () => this.tell(true);
    this.events.onmessage = (/** @type {MessageEvent<string>} */ { data }) => {
      /** @type {{revision: number}} */
      const { revision } = JSON.parse(data);
      this.newest = revision;
      this.fetchNews();
    };
    this.events.onerror = () => this.lost();
  }

  // The browser reconnects by itself unless it was refused.
  lost() {
    if (this.closed) return;
    this.tell(false);
    if (this.closed || this.events?.readyState !== EventSource.CLOSED) return;
    clearTimeout(this.again);
    this.again = setTimeout(() => {
      if (!this.closed) this.open();
    }, kAgain);
  }

  // Closes the connection after the last data, so that the browser does not reconnect.
  close() {
    this.closed = true;
    this.events?.close();
  }

  async fetchNews() {
    if (this.busy) return;
    this.busy = true;
    while (this.newest > this.revisionOf() && !this.closed) {
      /** @type {LivePiece | null} */
      let raw = null;
      try {
        const answer = await fetch(this.address('data', `&from=${this.revisionOf()}`));
        if (answer.ok) raw = await answer.json();
      } catch {
        // Handled below.
      }
      if (!raw) {
        this.lost();
        await pause(kAgain);
        continue;
      }
      this.tell(true); // only a fetch may have failed while the events went on
      const begun = performance.now();
      this.show(raw);
      await pause(kIdle * (performance.now() - begun));
    }
    this.busy = false;
  }

  /**
   * Data that cannot be shown will fail again, so the connection is closed.
   * @param {LivePiece} raw
   */
  show(raw) {
    try {
      this.take(raw);
    } catch (error) {
      this.close();
      this.fail(error);
    }
  }
}
