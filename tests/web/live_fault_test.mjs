// Faults between the server and the picture of obby-view --live. The page reports them or recovers.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { LiveReport } from '../../web/src/live_report.js';
import { frames, started, withoutWebGl } from './browser.mjs';
import { harness } from './harness.mjs';
import { openLive, recordsOf, Viewer, trajectoriesAre } from './live_driver.mjs';

const { options, test, run } = harness();
const stream = recordsOf(
  options.solver,
  ...['--query', 'any', '--attempts', '8', '--max-steps', '100000'],
  join(options.levels, 'several-routes.jsonl'),
);
const of = (type) => stream.filter((record) => record.type === type);
const course = [of('header')[0], of('level')[0], of('query').find(({ id }) => id === 'any')];
const trajectories = of('trajectory').filter((record) => record.query === 'any');

test('there are enough trajectories to send', () => assert.ok(trajectories.length >= 3, `${trajectories.length}`));

// A page that opens late gets a long stream in one piece. Thinned attempts may have a range each.
test('a piece can hold more trajectories than call arguments', () => {
  const count = 150000;
  const numbers = Array.from({ length: count }, (_, i) => i + 1);
  const data = { kind: 'attempt', ticks: 0, stride: 1, position: '', yaw: '', state: '', runs: '' };
  const facts = { id: 'q', level: -1, result: null };
  const piece = (revision, serials, trajectories) => ({
    format: 4,
    revision,
    head: { state: 'live', title: '', notes: [] },
    levels: [],
    queries: [{ index: 0, facts, serials, trajectories }],
  });
  const live = new LiveReport();
  const sent = numbers.map((serial) => ({ serial, data }));
  assert.equal(live.take(piece(1, [[1, count]], sent)).fresh.length, count);
  const odd = numbers.filter((serial) => serial % 2 === 1).map((serial) => [serial, serial]);
  const begun = performance.now();
  assert.equal(live.take(piece(2, odd, [])).fresh.length, 0);
  assert.equal(live.report.queries[0].paths.length, count / 2);
  assert.ok(performance.now() - begun < 10000, 'the time is at most linear in the trajectories');
});

test('a page without WebGL stays live with a message', async ({
  browser,
}) => {
  const viewer = new Viewer(options.viewer);
  const { page, trouble } = await openLive(browser, await viewer.address, withoutWebGl);
  viewer.write(...course, trajectories[0]);
  await started(page);
  await trajectoriesAre(page, 1);
  assert.match(await page.locator('#stage').innerText(), /no WebGL/);
  viewer.write(trajectories[1]);
  await trajectoriesAre(page, 2);
  assert.ok(
    trouble.every((text) => /^THREE.*WebGL/.test(text)),
    String(trouble),
  );
  await page.context().close();
  await viewer.stop();
});

test('data of another format ends the requests', async ({
  browser,
}) => {
  const viewer = new Viewer(options.viewer);
  const { page, trouble, requests } = await openLive(browser, await viewer.address);
  viewer.write(...course, trajectories[0]);
  await started(page);
  await trajectoriesAre(page, 1);
  await page.route('**/data?*', (route) => route.fulfill({ json: { format: 5 } }));
  viewer.write(trajectories[1]);
  await page.locator('.fatal', { hasText: 'its data has format 5, expected 4; reload the page' }).waitFor();
  const asked = requests.length;
  viewer.write(trajectories[2]);
  await page.waitForTimeout(1500); // the server notifies open pages five times a second
  assert.equal(requests.length, asked, requests.slice(asked).join());
  await frames(page, 5);
  assert.equal(trouble.length, 1, trouble.join());
  await page.context().close();
  await viewer.stop();
});

test('a failed request is retried until live', async ({
  browser,
}) => {
  const viewer = new Viewer(options.viewer);
  const { page } = await openLive(browser, await viewer.address);
  viewer.write(...course, trajectories[0]);
  await started(page);
  await trajectoriesAre(page, 1);
  await page.evaluate(() => {
    // The page collects the messages, because each is shown for only a second.
    window.said = [];
    const name = document.querySelector('.live .name');
    const note = () => window.said.push(name.textContent);
    new MutationObserver(note).observe(name, { childList: true });
  });
  await page.route('**/data?*', (route) => route.abort(), { times: 1 });
  viewer.write(trajectories[1]);
  await trajectoriesAre(page, 2);
  assert.match(await page.evaluate(() => window.said.join()), /Connection lost/);
  assert.equal(await page.locator('.live .name').innerText(), 'Live');
  await page.context().close();
  await viewer.stop();
});

test('a server that stops before any level is reported', async ({ browser }) => {
  const viewer = new Viewer(options.viewer);
  const { page } = await openLive(browser, await viewer.address);
  const name = page.locator('.live .name');
  await name.filter({ hasText: 'Live' }).waitFor();
  await viewer.stop();
  await name.filter({ hasText: 'Connection lost' }).waitFor();
  await page.context().close();
});

await run();
