// Puts a large report in the page, and makes typical changes by a reader. size_test counts their
// work, and the bench times them.
import { writeFileSync } from 'node:fs';
import { fillTemplate } from './browser.mjs';
import { largeReport } from './large_report.mjs';

// Writes a page with `parts` parts and `trajectories` trajectories of ten seconds to `file`.
export function writeLargePage(template, file, parts, trajectories) {
  const report = largeReport(parts, trajectories, 600);
  writeFileSync(file, fillTemplate(template, report, report.title));
}

// Maps a change to the values that it sets the i-th time. The values always differ from the
// previous ones and need about as much work.
export const kChanges = {
  again: () => ({}),
  select: (i) => ({ path: 100 + i }),
  scrub: (i) => ({ tick: 50 + i }),
  filter: (i) => ({ maxSeconds: 8 - 0.1 * i }),
  box: (i) => ({ boxes: [{ min: [i, 0, 0], max: [i + 20, 20, 60], keep: true }] }),
  heat: (i) => ({ boxes: [], heat: true, maxSeconds: 9.9 - 0.1 * i }),
  colour: (i) => ({ colorBy: ['time', 'jumps', 'outcome'][i] }),
  sort: (i) => ({ sort: ['time', 'jumps', 'found'][i], maxSeconds: 0, boxes: [], heat: false }),
};

// Makes a change and draws it. Returns the milliseconds until the picture is complete.
export function change(page, values) {
  return page.evaluate(async (v) => {
    const { obby } = window;
    const start = performance.now();
    obby.store.set(v);
    obby.draw(obby.store.state.tick, obby.path());
    const gl = obby.stage.renderer.getContext();
    // Reading a pixel waits for the picture.
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return performance.now() - start;
  }, values);
}
