// A large report, 2,000 parts and 1,000 trajectories of ten seconds, opens and stays usable: what a picture draws and what
// a change sends to the GPU is counted, on any machine the same. How long it takes is for `scripts/bench page`.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { countPrograms, frames, openReport } from './browser.mjs';
import { harness } from './harness.mjs';
import { change, kChanges, writeLargePage } from './large_page.mjs';

const kWays = 1000;
const kMostCalls = 60; // to draw a picture
const kMostPieces = 450e3; // triangles and lines in it
const kMostLines = 125e3; // without a GPU these take the most time
const kMostRows = 800; // of the list, 400 of solutions and of attempts, which says how many more there are
const kMostLaidOut = 200; // of them; about a dozen are in sight

// What a change may send to the GPU, in kB: nothing, one way and its marks, or which ways are drawn and their colours. The
// points of all ways, 1,200 kB more, are sent once.
const kMostSent = { again: 1, select: 150, scrub: 50, filter: 1000, box: 1000, colour: 2200, sort: 1000 };
const kMostSentForAll = 4500;
const kSentOfColours = 500; // at least, or else nothing is counted

const { options, test, run } = harness();
const file = join(options.out, 'size_test.html');
writeLargePage(readFileSync(options.page, 'utf8'), file, 2000, kWays);

// Counts from now on how many bytes of buffers and textures the page sends to the GPU.
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
    assert.ok(calls > 0 && calls < kMostCalls, `${name}: ${calls} calls`);
    assert.ok(triangles + lines > 0 && triangles + lines < kMostPieces, `${name}: ${triangles + lines} pieces`);
    assert.ok(lines < kMostLines, `${name}: ${lines} lines`);
    assert.ok(sent < (kMostSent[name] ?? kMostSentForAll), `${name}: ${sent} kB`);
    assert.ok(rows > 0 && rows <= kMostRows, `${name}: ${rows} rows`);
    if (name === 'colour') assert.ok(sent > kSentOfColours, `only ${sent} kB of colours`);
    // Once more: what it takes is there.
    await page.evaluate(() => (window.linked = 0));
    await change(page, values(1));
    assert.equal(await page.evaluate(() => window.linked), 0, `${name}: programs of the GPU made anew`);
  }
  assert.equal(await page.evaluate(() => window.obby.store.state.order.length), kWays);
  await page.locator('.path').first().scrollIntoViewIfNeeded();
  await frames(page, 3);
  const laidOut = await page.evaluate(() => {
    const names = [...document.querySelectorAll('.path .name')];
    return names.filter((name) => name.checkVisibility({ contentVisibilityAuto: true })).length;
  });
  assert.ok(laidOut > 0 && laidOut < kMostLaidOut, `${laidOut} rows are laid out`);
  await options.picture(page, 'large');
  assert.deepEqual(trouble, []);
  assert.equal(requests.length, 1);
});

await run();
