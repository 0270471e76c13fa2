// Two trajectories side by side: the ghost, one clock for both, the table.
import assert from 'node:assert/strict';
import { frames, state } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const set = (page, values) => page.evaluate((v) => window.obby.store.set(v), values);
const paths = report.queries[0].trajectories;

const kLong = 0; // index of a trajectory of the sample
const kShort = 4; // index of a trajectory with a fraction of that one's ticks

// Returns the last tick of the timeline, and the positions of the selected trajectory's jumps in
// thousandths of its length.
const bar = (page) =>
  page.evaluate(() => ({
    last: Number(document.querySelector('.scrub').max),
    jumps: [...document.querySelectorAll('.mark.jump')].map((mark) =>
      parseFloat(mark.getAttribute('d').slice(1)),
    ),
  }));

// Asserts that the timeline spans `ticks`, with the trajectory's jumps at the right positions.
async function assertBar(page, ticks, trajectory) {
  const { last, jumps } = await bar(page);
  assert.equal(last, ticks);
  assert.equal(last, await page.evaluate(() => window.obby.length()));
  const wanted = trajectory.jumpTicks.map((tick) => (1000 * tick) / ticks);
  assert.equal(jumps.length, wanted.length);
  jumps.forEach((at, i) => assert.ok(Math.abs(at - wanted[i]) < 0.01, `${at}, not ${wanted[i]}`));
}

test('two trajectories run side by side from their starts', async ({ page }) => {
  await set(page, { path: 0, tick: 0 });
  await page.locator('.path[data-path="1"]').click({ modifiers: ['Shift'] });
  assert.equal((await state(page)).ghost, 1);
  await set(page, { tick: 200 });
  await frames(page, 3);
  const [where, wanted, shown] = await page.evaluate(() => {
    const { stage } = window.obby;
    const pose = window.obby.query().paths[1].poseAt(200);
    return [
      stage.ghost.group.position.toArray(),
      [pose.x, pose.y, pose.z],
      stage.ghost.group.visible,
    ];
  });
  assert.equal(shown, true);
  assert.deepEqual(where, wanted);
  assert.match(
    await page.locator('#comparison').innerText(),
    /Selected[\s\S]*Ghost[\s\S]*studs apart now/,
  );
  // The belt's box begins 6 studs along the segment from 0 to 18 studs, which starts at 3.75 s and
  // takes 0.75 s.
  assert.match(await page.locator('#comparison').innerText(), /Belt\s+4\.00 s/);
  await options.picture(page, 'comparison');
  await page.locator('#view').focus();
  await page.keyboard.press('x');
  assert.equal(await page.locator('#comparison').isVisible(), false);
});

test('the table shows how and where each ended', async ({ page }) => {
  const killed = paths.findIndex(({ outcome, part }) => outcome === 'killed' && part >= 0);
  await set(page, { path: 0, ghost: killed });
  assert.match(await page.locator('#comparison').innerText(), /Outcome\s+.*Killed by Lava/);
  await set(page, { ghost: -1 });
});

test('the bar is as long as the longer of the two', async ({ page }) => {
  const [long, short] = [paths[kLong], paths[kShort]];
  assert.ok(short.ticks < 0.8 * long.ticks && short.jumpTicks.length > 1);
  await set(page, { path: kShort, ghost: -1, tick: 0 });
  await assertBar(page, short.ticks, short);
  await page.locator(`.path[data-path="${kLong}"]`).click({ modifiers: ['Shift'] });
  await assertBar(page, long.ticks, short);
  assert.match(
    await page.locator('.clock .time').innerText(),
    new RegExp(` / ${(long.ticks / 60).toFixed(2)} s$`),
  );
  const box = await page.locator('.scrub').boundingBox();
  await page.mouse.click(box.x + box.width - 2, box.y + box.height / 2);
  const { tick } = await state(page);
  assert.ok(tick > 0.98 * long.ticks, `scrubbed to ${tick} of ${long.ticks}`);
  assert.equal(Number(await page.locator('.scrub').inputValue()), tick);
  await page.getByLabel('End the comparison').click();
  await assertBar(page, short.ticks, short);
});

test('a ghost keeps the length of the bar', async ({ page }) => {
  await set(page, { path: kLong, ghost: -1, tick: 0 });
  await page.locator('#view').focus();
  await page.keyboard.press('x');
  await assertBar(page, paths[kLong].ticks, paths[kLong]);
  for (let down = 0; down < kShort - kLong; down++) await page.keyboard.press('ArrowDown');
  assert.equal((await state(page)).path, kShort);
  await assertBar(page, paths[kLong].ticks, paths[kShort]);
});

test('swapping leaves the keyboard on its button', async ({ page }) => {
  await page.getByRole('button', { name: 'Swap' }).focus();
  await page.keyboard.press('Enter');
  const { path, ghost } = await state(page);
  assert.deepEqual([path, ghost], [kLong, kShort]);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.key), 'swap');
  await assertBar(page, paths[kLong].ticks, paths[kLong]);
});

test('waypoints are passed in order at any height', async ({ page }) => {
  await set(page, { path: 0, ghost: -1, tick: 0 });
  await page.evaluate(() => {
    const query = window.obby.query();
    const { x, y, z } = query.paths[0].poseAt(250);
    const flat = (name, position) => ({
      region: { name, position, rotation: [0, 0, 0, 1], size: [4, 0.5, 4] },
      maxJumps: -1,
    });
    query.waypoints = [flat('Under the feet', [x, y, z]), flat('Back home', [0, 0.5, 0])];
    window.obby.store.set({ ghost: 1 });
  });
  const words = await page.locator('#comparison').innerText();
  assert.match(words, /Under the feet\s+[34]\.\d\d s/);
  assert.match(words, /Back home\s+never/);
});

test('the page raised no error and made no request', async ({ trouble, requests }) => {
  assert.deepEqual(trouble, []);
  assert.equal(requests.length, 1, requests.join());
});

await run(options.sample(report));
