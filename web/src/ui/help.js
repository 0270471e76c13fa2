// The list of shortcuts that `?` opens.
import { el } from './dom.js';

/** @type {[title: string, rows: [keys: string, text: string][]][]} */
const kSections = [
  [
    'Play',
    [
      ['Space', 'play or pause'],
      ['← → , .', 'previous or next tick'],
      ['Shift ← →', 'ten ticks'],
      ['Home End', 'first or last tick'],
      ['− +', 'slower or faster'],
      ['L', 'loop'],
      ['< >', 'loop from here, to here (or Shift and drag over the profile)'],
      ['click the clock', 'type a time'],
    ],
  ],
  [
    'Select',
    [
      ['click', 'a line, a row or a part'],
      ['↑ ↓', 'previous or next trajectory'],
      ['Tab ↑ ↓ Enter', 'a row, by keyboard'],
      ['[ ]', 'previous or next query'],
      ['X', 'keep as ghost, to compare others with it'],
      ['Shift click', 'compare with this one'],
      ['I', 'draw only the selected one'],
      ['B', 'draw a box to filter trajectories'],
      ['M', 'measure between two points'],
      ['Esc', 'clear selection'],
    ],
  ],
  [
    'Camera',
    [
      ['left drag', 'orbit'],
      ['right drag', 'look around'],
      ['middle drag', 'pan (or Shift + left drag)'],
      ['wheel', 'zoom'],
      ['two fingers', 'zoom and pan'],
      ['W A S D Q E', 'fly, with Shift faster'],
      ['F', 'frame the selected part or trajectory'],
      ['G', 'follow the player; the wheel goes to its eyes'],
      ['T', 'view from above'],
      ['R', 'whole course'],
    ],
  ],
  [
    'Show',
    [
      ['1 … 9, 0', 'switches under Display'],
      ['C', 'colours of roles or of the level'],
      ['Y', 'light or dark'],
      ['? F1', 'this list'],
    ],
  ],
];

export class Help {
  /**
   * @param {HTMLDialogElement} dialog
   * @param {() => void} reset resets the view settings
   */
  constructor(dialog, reset) {
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
      el(
        'footer',
        {},
        el('p', { class: 'quiet', text: 'The browser keeps camera mode, colours, speed and layers for the next page.' }),
        el('button', {
          class: 'plain reset',
          type: 'button',
          text: 'Reset view settings',
          on: {
            click: () => {
              reset();
              dialog.close();
            },
          },
        }),
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
