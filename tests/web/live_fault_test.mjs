// obby-view --live where something goes wrong between the server and the picture: the page says so, or goes on.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { frames } from './browser.mjs';
import { harness } from './harness.mjs';
import { openLive, recordsOf, started, Viewer, waysAre } from './live_driver.mjs';

const { options, test, run } = harness();
const stream = recordsOf(
  options.solver,
  ...['--query', 'any', '--attempts', '8', '--max-steps', '100000'],
  join(options.levels, 'several-routes.jsonl'),
);
const of = (type) => stream.filter((record) => record.type === type);
const course = [of('header')[0], of('level')[0], of('query').find(({ id }) => id === 'any')];
const ways = of('trajectory').filter((record) => record.query === 'any');

test('there are enough ways to send', () => assert.ok(ways.length >= 3, `${ways.length}`));

test('a page that cannot draw says so and asks for no more', async ({ browser }) => {
  const viewer = new Viewer(options.viewer);
  const { page, trouble, requests } = await openLive(browser, await viewer.address, (opened) =>
    opened.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    }),
  );
  viewer.write(...course);
  await page.locator('.fatal').waitFor();
  assert.match(await page.locator('body').innerText(), /^This report cannot be shown: .*WebGL/);
  assert.ok(
    trouble.some((text) => /exception: .*WebGL/.test(text)),
    String(trouble),
  );
  const asked = requests.length;
  viewer.write(ways[0]);
  await page.waitForTimeout(1500); // the server tells open pages five times a second
  assert.equal(requests.length, asked, requests.slice(asked).join());
  await page.context().close();
  await viewer.stop();
});

test('data of another format is refused, whatever was there', async ({ browser }) => {
  const viewer = new Viewer(options.viewer);
  const { page, trouble } = await openLive(browser, await viewer.address);
  viewer.write(...course, ways[0]);
  await started(page);
  await waysAre(page, 1);
  await page.route('**/data?*', (route) => route.fulfill({ json: { format: 4 } }));
  viewer.write(ways[1]);
  await page.locator('.fatal', { hasText: 'data of format 4, expected 3' }).waitFor();
  await frames(page, 5);
  assert.equal(trouble.length, 1, trouble.join());
  await page.context().close();
  await viewer.stop();
});

test('data that does not come once is asked for again, and the page is live', async ({
  browser,
}) => {
  const viewer = new Viewer(options.viewer);
  const { page } = await openLive(browser, await viewer.address);
  viewer.write(...course, ways[0]);
  await started(page);
  await waysAre(page, 1);
  await page.route('**/data?*', (route) => route.abort(), { times: 1 });
  viewer.write(ways[1]);
  const name = page.locator('.live .name');
  await name.filter({ hasText: 'Connection lost' }).waitFor();
  await waysAre(page, 2);
  assert.equal(await name.innerText(), 'Live');
  await page.context().close();
  await viewer.stop();
});

await run();
