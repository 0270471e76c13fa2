// Compares pictures of the page with those in golden/. After an intended change, rewrite them with
// OBBY_WRITE_GOLDEN=1 and look at them.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { colours, frames, openReport } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const require = createRequire(resolve(options.web, 'package.json'));
const { PNG } = require('pngjs');
const { default: pixelmatch } = await import(pathToFileURL(require.resolve('pixelmatch')));
const sample = options.sample(report);

const kGolden = join(dirname(fileURLToPath(import.meta.url)), 'golden');
const kSize = { width: 960, height: 600 };
const kDifferent = 0.005; // max share of different pixels; drivers round edges differently
const kThreshold = 0.15; // colour distance below which two pixels are equal

// `fragment`: the fragment of the address, with the query, trajectory and time. `values`: values
// to set in the store.
const kScenes = {
  course: { fragment: '#q=whole course', values: {} },
  chosen: { fragment: '#q=whole course&traj=0&t=3.2', values: { ghost: 1, theme: 'dark' } },
  light: { fragment: '#q=whole course', values: { theme: 'light', heat: true, heatTrajectories: true } },
  cut: { fragment: '#q=without jumping', values: { colorBy: 'time', theme: 'dark' } },
  box: {
    fragment: '#q=whole course&traj=4&t=2',
    values: { isolate: true, boxes: [{ min: [-8, 0, -40], max: [8, 20, -20], keep: true }] },
  },
};

// Returns the first picture that equals the previous one. Until then the camera glides and the
// player's trail fades.
async function settled(page) {
  let before = null;
  for (let look = 0; look < 40; look++) {
    await frames(page, 12);
    const now = await page.screenshot();
    if (before?.equals(now)) return now;
    before = now;
  }
  throw new Error('the picture does not come to rest');
}

async function pictureOf(browser, { fragment, values }) {
  const { page, trouble } = await openReport(browser, sample, {
    fragment: encodeURI(fragment),
    viewport: kSize,
    density: 1,
  });
  await page.evaluate((v) => window.obby.store.set({ playing: false, ...v }), values);
  const picture = await settled(page);
  assert.ok((await colours(page, false)).different > 40, 'the level is drawn');
  await page.context().close();
  assert.deepEqual(trouble, []);
  return picture;
}

// Returns the share of different pixels, and saves a picture of them in the test's output folder.
function differing(name, golden, picture) {
  const [a, b] = [PNG.sync.read(golden), PNG.sync.read(picture)];
  assert.deepEqual([b.width, b.height], [a.width, a.height]);
  const marked = new PNG({ width: a.width, height: a.height });
  const count = pixelmatch(a.data, b.data, marked.data, a.width, a.height, {
    threshold: kThreshold,
  });
  writeFileSync(join(options.out, `golden-${name}-differs.png`), PNG.sync.write(marked));
  return count / (a.width * a.height);
}

for (const [name, scene] of Object.entries(kScenes))
  test(`matches the golden picture: ${name}`, async ({ browser }) => {
    const picture = await pictureOf(browser, scene);
    writeFileSync(join(options.out, `golden-${name}.png`), picture);
    const file = join(kGolden, `${name}.png`);
    if (process.env.OBBY_WRITE_GOLDEN) {
      mkdirSync(kGolden, { recursive: true });
      writeFileSync(file, picture);
      return;
    }
    const share = differing(name, readFileSync(file), picture);
    console.log(`     ${(100 * share).toFixed(3)} % of the pixels differ`);
    assert.ok(share <= kDifferent, `${(100 * share).toFixed(2)} % of the pixels differ`);
  });

test('a different picture is detected', () => {
  const [a, b] = ['course', 'cut'].map((name) => readFileSync(join(kGolden, `${name}.png`)));
  assert.ok(differing('other', a, b) > 4 * kDifferent);
});

await run();
