// A large report, 2,000 parts and 1,000 trajectories of ten seconds, opens within three seconds and stays usable. The
// bounds are for the best of three, for a machine that does other things, too; a browser without a GPU draws it. Where
// drawing the same picture again takes it long already, the bounds are longer in proportion: how much there is to draw is
// counted, not timed.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { frames, openReport } from './browser.mjs';
import { harness } from './harness.mjs';
import { largeReport } from './large_report.mjs';

const kMostToOpen = 3000; // ms from navigation to the first picture
const kMostToAnswer = 1000; // ms from a key or a click to the next picture
const kMostCalls = 60; // to draw a picture
const kMostPieces = 450e3; // triangles and lines in it
const kUsualToDraw = 500; // ms on a machine for which the bounds are meant
const { options, test, run } = harness();
const file = options.sample(largeReport(2000, 1000, 600));

async function best(attempts, body) {
  let least = Infinity;
  for (let i = 0; i < attempts; i++) least = Math.min(least, await body());
  return least;
}

// Changes what is shown; the milliseconds until it is drawn.
function answer(page, values) {
  return page.evaluate(async (v) => {
    const { obby } = window;
    const start = performance.now();
    obby.store.set(v);
    obby.draw(obby.store.state.tick, obby.path());
    const gl = obby.stage.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits for the picture
    return performance.now() - start;
  }, values);
}

// How much longer than usual this machine may take.
async function slowness(page) {
  const ms = await best(3, () => answer(page, {}));
  const drawn = await page.evaluate(() => ({ ...window.obby.stage.renderer.info.render }));
  const pieces = drawn.triangles + drawn.lines;
  console.log(
    `     the same picture again: ${Math.round(ms)} ms, ${drawn.calls} calls, ${pieces} triangles and lines`,
  );
  assert.ok(drawn.calls > 0 && drawn.calls < kMostCalls, `${drawn.calls} calls`);
  assert.ok(pieces > 0 && pieces < kMostPieces, `${pieces} triangles and lines`);
  return Math.max(1, ms / kUsualToDraw);
}

test('opens in time', async ({ browser }) => {
  let slower = 1;
  const ms = await best(3, async () => {
    const { page, trouble } = await openReport(browser, file);
    const taken = await page.evaluate(() => window.obby.firstDrawn);
    slower = await slowness(page);
    assert.deepEqual(trouble, []);
    await page.context().close();
    return taken;
  });
  console.log(`     open: ${Math.round(ms)} ms`);
  assert.ok(ms > 0 && ms < kMostToOpen * slower, `${ms} ms`);
});

test('answers in time', async ({ browser }) => {
  const { page, trouble, requests } = await openReport(browser, file);
  const slower = await slowness(page);
  const asked = {
    select: (i) => ({ path: 100 + i }),
    scrub: (i) => ({ tick: 50 + i }),
    filter: (i) => ({ mostSeconds: 8 - i }),
    box: (i) => ({ boxes: [{ min: [10 * i, 0, 0], max: [10 * i + 20, 20, 60], keep: true }] }),
    heat: (i) => ({ boxes: [], heat: true, mostSeconds: 9.9 - 0.1 * i }),
    colour: (i) => ({ colorBy: ['time', 'jumps', 'outcome'][i] }),
    sort: (i) => ({ sort: ['time', 'jumps', 'found'][i], mostSeconds: 0, boxes: [], heat: false }),
  };
  for (const [name, values] of Object.entries(asked)) {
    let i = 0;
    const ms = await best(3, () => answer(page, values(i++)));
    console.log(`     ${name}: ${Math.round(ms)} ms`);
    assert.ok(ms < kMostToAnswer * slower, `${name}: ${ms} ms`);
  }
  const at = await page.evaluate(() => {
    const start = performance.now();
    window.obby.stage.pick(window.obby.store.state, 400, 300);
    return performance.now() - start;
  });
  console.log(`     what is under the pointer: ${Math.round(at)} ms`);
  await frames(page);
  await page.screenshot({ path: join(options.out, 'large.png') });
  assert.deepEqual(trouble, []);
  assert.equal(requests.length, 1);
});

await run();
