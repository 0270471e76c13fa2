// Tests the page by keyboard: lists with a single tab stop, and other keyboard layouts.
import assert from 'node:assert/strict';
import { arrive, state } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const put = (page, values) => page.evaluate((v) => window.obby.store.set(v), values);
// Returns the number of tab stops of each list, and the focused row: `query` or `trajectory` is its
// index, the other is -1.
const rows = (page) =>
  page.evaluate(() => {
    const { dataset, parentElement } = document.activeElement;
    return {
      stops: ['.queries', '.paths'].map(
        (list) => document.querySelectorAll(`${list} [role=option][tabindex="0"]`).length,
      ),
      query: Number(dataset.query ?? -1),
      trajectory: Number(dataset.path ?? -1),
      inList: Boolean(parentElement?.closest('.paths')),
    };
  });

test('a list is one Tab stop with arrow keys', async ({ page }) => {
  const press = async (key) => {
    await page.keyboard.press(key);
    return (await rows(page)).trajectory;
  };
  await put(page, { path: 3, tick: 5, playing: false });
  assert.deepEqual((await rows(page)).stops, [1, 1]);
  await page.locator('.choice.colorBy select').focus();
  assert.equal(await press('Tab'), 3, 'the chosen one');
  const last = report.queries[0].trajectories.length - 1;
  for (const [key, trajectory] of Object.entries({ ArrowDown: 4, Home: 0, ArrowUp: 0, End: last }))
    assert.equal(await press(key), trajectory, key);
  assert.equal(await press('ArrowDown'), last);
  const far = last - (await press('PageUp'));
  assert.ok(far > 1 && far < last, `a page of ${far} rows`);
  assert.equal(await press('PageDown'), last);
  await press('ArrowRight');
  const { path, tick } = await state(page);
  assert.deepEqual([path, tick], [3, 6], 'nothing is chosen, and other keys are as elsewhere');
  assert.equal(await press('Space'), last);
  assert.equal((await state(page)).path, last);
  for (const playing of [true, false]) {
    await press('Space');
    const now = await state(page);
    assert.deepEqual([now.path, now.playing], [last, playing], 'on the chosen one it plays');
  }
  assert.equal(await press('Enter'), last);
  assert.equal((await state(page)).path, -1);
  for (const ghost of [last, -1]) {
    await press('Shift+Enter');
    assert.equal((await state(page)).ghost, ghost);
  }
  assert.equal(await press('Tab'), -1);
  assert.equal(await press('Shift+Tab'), last);
  await page.locator('.query[tabindex="0"]').focus();
  await press('End');
  const { length } = report.queries;
  assert.equal((await rows(page)).query, length - 1);
  await press('Enter');
  assert.equal((await state(page)).query, length - 1);
  assert.equal((await rows(page)).query, length - 1);
  await put(page, { query: 0 });
  await arrive(page);
});

// By default Firefox makes every scrolling element a tab stop.
test('scrolling lists take no focus', async ({
  page,
}) => {
  const stops = await page.evaluate(() =>
    ['.queries', '.paths'].map((list) => document.querySelector(list).getAttribute('tabindex')),
  );
  assert.deepEqual(stops, ['-1', '-1']);
  await put(page, { path: 3, tick: 0 });
  await page.locator('.paths h3').first().click();
  assert.equal(await page.evaluate(() => document.activeElement === document.body), true);
  await page.keyboard.press('ArrowDown');
  assert.equal((await state(page)).path, 4);
  await put(page, { path: -1 });
});

test('sorting, filtering and rebuilding a list keeps focus', async ({ page }) => {
  await page.locator('.path[data-path="5"]').focus();
  const asFound = { sort: 'found', descending: false };
  for (const values of [{ sort: 'time' }, { descending: true }, asFound]) {
    await put(page, values);
    const { trajectory, stops } = await rows(page);
    assert.deepEqual([trajectory, stops], [5, [1, 1]], JSON.stringify(values));
  }
  const { outcome } = report.queries[0].trajectories[5];
  await put(page, { outcome: outcome === 'killed' ? 'fell' : 'killed' });
  const gone = await rows(page);
  assert.deepEqual([gone.inList, gone.stops], [true, [1, 1]], 'another is in its place');
  await put(page, { outcome: '' });
  assert.equal((await rows(page)).trajectory, gone.trajectory);
});

test('a clicked row leaves the keys to the page', async ({ page }) => {
  await page.locator('.path[data-path="4"]').click();
  await page.keyboard.press('ArrowDown');
  assert.equal((await state(page)).path, 5);
  await page.locator('.path[data-path="4"]').click({ modifiers: ['Shift'] });
  for (const playing of [true, false]) {
    await page.keyboard.press('Space');
    const now = await state(page);
    assert.deepEqual([now.path, now.ghost, now.playing], [5, 4, playing]);
  }
  await put(page, { ghost: -1 });
});

test('keys that need Alt match by their character', async ({ page }) => {
  const press = (init) =>
    page.evaluate((how) => window.dispatchEvent(new KeyboardEvent('keydown', how)), init);
  await press({ key: ']', code: 'Digit6', altKey: true });
  assert.equal((await state(page)).query, 1);
  await press({ key: '[', code: 'Digit5', altKey: true });
  assert.equal((await state(page)).query, 0);
  for (const how of [{ altKey: true }, { ctrlKey: true }, { metaKey: true }])
    await press({ key: 'l', code: 'KeyL', ...how });
  // This shortcut goes forward in some browsers.
  await press({ key: ']', code: 'BracketRight', metaKey: true });
  const { loop, query } = await state(page);
  assert.deepEqual([loop, query], [true, 0]);
  await arrive(page);
});

test('Space presses the button of the shortcut list', async ({ page }) => {
  const open = () => page.evaluate(() => document.getElementById('help').open);
  await page.locator('#view').focus();
  await page.keyboard.press('?');
  assert.equal(await open(), true);
  await page.locator('#help .close').focus();
  await page.keyboard.press('Space');
  assert.deepEqual([await open(), (await state(page)).playing], [false, false]);
});

test('the page raised no error', async ({ trouble }) => assert.deepEqual(trouble, []));

await run(options.sample(report));
