// A report of 2,000 parts and 1,000 trajectories of ten seconds opens and stays usable. The test
// counts what a picture draws and what a change sends to the GPU, which does not depend on the
// machine. `scripts/bench page` measures the time.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { countPrograms, frames, openReport } from './browser.mjs';
import { harness } from './harness.mjs';
import { change, kChanges, writeLargePage } from './large_page.mjs';

const kTrajectories = 1000;
const kMaxCalls = 60; // max draw calls of a picture
const kMaxPieces = 450e3; // max triangles and lines of a picture
const kMaxLines = 125e3; // max lines of a picture; without a GPU, lines take the most time
// Max rows of the list: 400 solutions and 400 attempts; the list states the number of others.
const kMaxRows = 800;
const kMaxLaidOut = 200; // max rows with a layout; about a dozen are visible

// Max kB that a change sends to the GPU: nothing, one trajectory with its marks, or the indices and
// colours of the drawn trajectories. The points of all trajectories, 1,200 kB, are sent once.
const kMaxSent = { again: 1, select: 150, scrub: 50, filter: 1000, box: 1000, colour: 2200, sort: 1000 };
const kMaxSentForAll = 4500;
const kSentOfColours = 500; // min kB for new colours; less would mean that the count is broken

const { options, test, run } = harness();
const file = join(options.out, 'size_test.html');
writeLargePage(readFileSync(options.page, 'utf8'), file, 2000, kTrajectories);

// Counts the bytes of buffers and textures that the page sends to the GPU from now on.
function countSent(page) {
  return page.evaluate(() => {
    window.sentBytes = 0;
    const { prototype } = WebGL2RenderingContext;
    const bytesOf = (args) => args.find((arg) => ArrayBuffer.isView(arg))?.byteLength ?? 0;
    const senders = Object.keys(prototype).filter((name) => /^(buffer|tex).*(Data|Image.D)$/.test(name));
    for (const name of senders) {
      const original = prototype[name];
      prototype[name] = function counted(...args) {
        window.sentBytes += bytesOf(args);
        return original.apply(this, args);
      };
    }
  });
}

test('a large report needs few draw calls', async ({ browser }) => {
  const { page, trouble, requests } = await openReport(browser, file);
  await countSent(page);
  await countPrograms(page);
  for (const [name, values] of Object.entries(kChanges)) {
    await page.evaluate(() => (window.sentBytes = 0));
    await change(page, values(0));
    const sent = (await page.evaluate(() => window.sentBytes)) / 1000;
    const { calls, triangles, lines } = await page.evaluate(() => window.obby.stage.renderer.info.render);
    const rows = await page.locator('.paths [role=option]').count();
    console.log(`     ${name}: ${calls} calls, ${triangles + lines} pieces, ${Math.round(sent)} kB sent, ${rows} rows`);
    assert.ok(calls > 0 && calls < kMaxCalls, `${name}: ${calls} calls`);
    assert.ok(triangles + lines > 0 && triangles + lines < kMaxPieces, `${name}: ${triangles + lines} pieces`);
    assert.ok(lines < kMaxLines, `${name}: ${lines} lines`);
    assert.ok(sent < (kMaxSent[name] ?? kMaxSentForAll), `${name}: ${sent} kB`);
    assert.ok(rows > 0 && rows <= kMaxRows, `${name}: ${rows} rows`);
    if (name === 'colour') assert.ok(sent > kSentOfColours, `only ${sent} kB of colours`);
    // For the second change of a kind, the GPU programs are already linked.
    await page.evaluate(() => (window.linked = 0));
    await change(page, values(1));
    assert.equal(await page.evaluate(() => window.linked), 0, `${name}: GPU programs linked again`);
  }
  assert.equal(await page.evaluate(() => window.obby.store.state.order.length), kTrajectories);
  await page.locator('.path').first().scrollIntoViewIfNeeded();
  await frames(page, 3);
  const laidOut = await page.evaluate(() => {
    const names = [...document.querySelectorAll('.path .name')];
    return names.filter((name) => name.checkVisibility({ contentVisibilityAuto: true })).length;
  });
  assert.ok(laidOut > 0 && laidOut < kMaxLaidOut, `${laidOut} rows are laid out`);
  await options.picture(page, 'large');
  assert.deepEqual(trouble, []);
  assert.equal(requests.length, 1);
});

await run();
