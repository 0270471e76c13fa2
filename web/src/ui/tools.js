// The tools: ruler, picture, film, and copying a trajectory.
import { copyPath, savePicture } from '../export/save.js';
import { Film } from '../export/film.js';
import { el } from './dom.js';

/** @import {App} from '../app.js' */

/**
 * @param {App} app
 * @returns {HTMLElement}
 */
export function toolsOf(app) {
  /**
   * @param {string} text
   * @param {string} title
   * @param {() => void} click
   */
  const button = (text, title, click) =>
    el('button', { class: 'plain text', type: 'button', text, title, on: { click } });
  const ruler = button('Measure', 'Click two points for distance, reach and height (M)', () =>
    app.ruler.toggle(),
  );
  const film = button('Save film', 'Record the playback as WebM', () => app.film.toggle());
  const path = button('Copy path', 'Copy the samples of the selected trajectory as JSON', () =>
    copyPath(app),
  );
  film.hidden = !Film.possible();
  const show = () => {
    const { measuring, path: chosen, playing } = app.store.state;
    ruler.setAttribute('aria-pressed', String(measuring));
    film.setAttribute('aria-pressed', String(Boolean(app.film?.running) && playing));
    path.hidden = chosen < 0;
  };
  app.store.on(['measuring', 'path', 'query', 'playing'], show);
  show();
  return el(
    'div',
    { class: 'tools' },
    ruler,
    button('Save picture', 'Save the picture with its labels as PNG', () => savePicture(app)),
    film,
    path,
  );
}
