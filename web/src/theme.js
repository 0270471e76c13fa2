// Switches between light and dark panels, as the system or the user chooses.

/** @import {Store} from './store.js' */
/** @import {State} from './types/report.js' */

const system = matchMedia('(prefers-color-scheme: light)');

const systems = () => (system.matches ? 'light' : 'dark');

/** @param {State} state */
const shown = ({ theme }) => (theme === 'auto' ? systems() : theme);

/** @param {Store} store */
export function bindTheme(store) {
  const show = () => {
    document.documentElement.dataset.theme = shown(store.state);
  };
  store.on(['theme'], show);
  system.addEventListener('change', show);
  show();
}

/**
 * Switches to the other theme. If the other theme is the system's, the page follows the system
 * again.
 * @param {Store} store
 */
export function nextTheme(store) {
  const theme = shown(store.state) === 'light' ? 'dark' : 'light';
  store.set({ theme: theme === systems() ? 'auto' : theme });
}
