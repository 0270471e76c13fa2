// The list of shortcuts behind `?`.
import { el } from './dom.js';

const kSections = [
  [
    'Play',
    [
      ['Space', 'play, pause'],
      ['← →', 'one tick back, on'],
      ['Shift ← →', 'ten ticks'],
      ['Home End', 'first, last tick'],
      ['− +', 'slower, faster'],
      ['L', 'loop'],
    ],
  ],
  [
    'Choose',
    [
      ['click', 'a line, a row or a part'],
      ['↑ ↓', 'trajectory before, after'],
      ['Tab ↑ ↓ Enter', 'a row, by keyboard'],
      ['[ ]', 'query before, after'],
      ['X', 'keep it as a ghost, to compare others with'],
      ['Shift click', 'compare with this one'],
      ['I', 'draw the chosen one only'],
      ['B', 'draw a box that ways, if any, must (not) pass'],
      ['Esc', 'nothing'],
    ],
  ],
  [
    'Camera',
    [
      ['left drag', 'orbit'],
      ['right drag', 'look around'],
      ['middle drag', 'pan (or Shift + left)'],
      ['wheel', 'in and out'],
      ['two fingers', 'in and out, pan'],
      ['W A S D Q E', 'fly, Shift for fast'],
      ['F', 'frame the selection'],
      ['G', 'follow the player'],
      ['T', 'from above'],
      ['R', 'whole course'],
    ],
  ],
  [
    'Show',
    [
      ['1 … 9, 0', 'toggles under Display'],
      ['C', 'colours of roles or of the level'],
      ['Y', 'light, dark, as the system'],
      ['?', 'this list'],
    ],
  ],
];

export class Help {
  constructor(dialog) {
    this.dialog = dialog;
    const close = el('button', {
      class: 'plain close',
      type: 'button',
      'aria-label': 'Close',
      text: '×',
      on: { click: () => dialog.close() },
    });
    dialog.append(
      el('header', {}, el('h2', { text: 'Shortcuts' }), close),
      el(
        'div',
        { class: 'columns' },
        ...kSections.map(([title, rows]) =>
          el(
            'section',
            {},
            el('h3', { text: title }),
            el(
              'dl',
              {},
              ...rows.flatMap(([keys, text]) => [
                el('dt', {}, el('kbd', { text: keys })),
                el('dd', { text }),
              ]),
            ),
          ),
        ),
      ),
    );
    dialog.addEventListener('click', (event) => {
      if (event.target === dialog) dialog.close();
    });
  }

  toggle() {
    if (this.dialog.open) this.dialog.close();
    else this.dialog.showModal();
  }
}
