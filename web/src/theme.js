// Light or dark panels: as the reader's system has it, or as they chose here.

const kNext = { auto: 'light', light: 'dark', dark: 'auto' };
const system = matchMedia('(prefers-color-scheme: light)');

export function bindTheme(store) {
  const show = () => {
    const { theme } = store.state;
    const light = theme === 'light' || (theme === 'auto' && system.matches);
    document.documentElement.dataset.theme = light ? 'light' : 'dark';
  };
  store.on(['theme'], show);
  system.addEventListener('change', show);
  show();
}

export const nextTheme = (store) => store.set({ theme: kNext[store.state.theme] });
