// Starts the page: reads and shows the report, or shows the error.
import { App } from './app.js';
import { readReport } from './data.js';
import { Live } from './live.js';
import { byId } from './page.js';
import { INITIAL } from './store.js';
import { el } from './ui/dom.js';
import { keepSettings, keptSettings } from './view_settings.js';

/** @import {LiveData, PageData} from './types/page_data.js' */
/** @import {Report} from './types/report.js' */

/**
 * Replaces the whole page, because half of a report would mislead.
 * @param {unknown} error
 */
function fail(error) {
  const reason = error instanceof Error ? error.message : String(error);
  document.body.replaceChildren(
    el('p', { class: 'fatal', text: `This report cannot be shown: ${reason}` }),
  );
  reportError(error); // also logs to the console
}

function start() {
  try {
    const begin = (/** @type {Report} */ report) => {
      const kept = keptSettings();
      const app = new App(report, { ...INITIAL, ...kept, follow: false });
      keepSettings(app, kept);
      window.obby = app; // for tests and debugging
      return app;
    };
    /** @type {PageData | LiveData} */
    const raw = JSON.parse(byId('obby-data').textContent);
    if ('live' in raw) new Live(byId('side'), begin, fail);
    else begin(readReport(raw));
  } catch (error) {
    fail(error);
  }
}

start();
