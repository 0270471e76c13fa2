// Shows the state of the live stream, and the option to select the newest solution.
import { checkbox, el } from './dom.js';

/** @import {Store} from '../store.js' */
/** @import {StreamState} from '../types/page_data.js' */
/** @import {Report} from '../types/report.js' */

const kStates = {
  live: { text: 'Live', title: 'The stream is running; new records appear here' },
  ended: { text: 'Ended', title: 'The stream has ended; nothing more will come' },
  broken: { text: 'Cut short', title: 'The stream stopped early; a note says why' },
  lost: { text: 'Connection lost, reconnecting', title: 'obby-view is not answering' },
};

export class LiveMark {
  constructor() {
    this.text = el('span', { class: 'name', role: 'status' });
    this.waiting = el('p', { class: 'quiet' });
    /** @type {Store | undefined} */
    this.store = undefined; // undefined until there is something to show
    this.newest = checkbox((checked) => this.store?.set({ followNewest: checked }));
    this.follow = el(
      'label',
      { hidden: true, title: 'Select each new solution as it arrives' },
      this.newest,
      el('span', { text: 'Follow newest' }),
    );
    this.root = el(
      'section',
      { class: 'live', 'aria-label': 'Live' },
      el('div', { class: 'live-bar' }, el('i', { class: 'lamp' }), this.text, this.follow),
      this.waiting,
    );
  }

  /** @param {Store} store */
  bind(store) {
    this.store = store;
    store.on(['followNewest'], (state) => {
      this.newest.checked = state.followNewest;
    });
  }

  /**
   * `connected`: undefined until known; `started`: there is something to show.
   * @param {StreamState} state
   * @param {boolean | undefined} connected
   * @param {Report} report
   * @param {boolean} started
   */
  show(state, connected, report, started) {
    const name = state === 'live' && connected === false ? 'lost' : state;
    this.root.dataset.state = name;
    if (this.text.textContent !== kStates[name].text) this.text.textContent = kStates[name].text;
    this.text.title = kStates[name].title;
    this.follow.hidden = !started || state !== 'live';
    this.waiting.hidden = started;
    this.waiting.textContent =
      state === 'live'
        ? 'Waiting for the first level.'
        : ['There is nothing to show.', ...report.notes].join(' ');
  }
}
