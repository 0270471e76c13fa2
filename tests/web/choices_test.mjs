// What the filters offer and count, as the report grows.
import assert from 'node:assert/strict';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { boxOf, pathsThrough } from '../../web/src/choice.js';
import { count } from '../../web/src/ui/dom.js';
import { frames } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const ways = report.queries[0].trajectories.length;
const offered = (page, name) => page.locator(`.choice.${name} option`).allTextContents();

// The chosen query with its first attempt once more, which ended otherwise: as a piece of a live page brings it.
const grow = (page, outcome) =>
  page.evaluate((ended) => {
    const app = window.obby;
    const query = app.query();
    const way = query.paths.find((path) => path.kind === 'attempt');
    const more = Object.assign(Object.create(Object.getPrototypeOf(way)), way, { outcome: ended });
    app.report.queries[0] = { ...query, paths: [...query.paths, more] };
    app.openQuery();
    app.filters.refresh();
    app.ways.choose();
  }, outcome);

test('whatever is offered, all of it comes first', async ({ page }) => {
  await page.locator('.filters .fold').click();
  for (const name of ['outcome', 'route', 'killer']) {
    const texts = await offered(page, name);
    assert.equal(texts[0], 'any', `${name}: ${texts}`);
    assert.ok(texts.length > 2);
  }
});

test('boxes count the ways that come, and keep what is being typed', async ({ page }) => {
  const all = { min: [-500, -500, -500], max: [500, 500, 500], keep: true };
  await page.evaluate((box) => window.obby.store.set({ boxes: [box] }), all);
  const counted = page.locator('.box output');
  assert.equal(await counted.innerText(), `${ways} ways pass it`);
  const field = page.getByLabel('Box 1 from x');
  await field.fill('-7');
  await grow(page, 'fell');
  assert.equal(await counted.innerText(), `${ways + 1} ways pass it`);
  assert.equal(await field.inputValue(), '-7');
  await page.evaluate(() => window.obby.store.set({ boxes: [] }));
});

test('a list of choices grows once nobody has it in hand', async ({ page }) => {
  const select = page.locator('.choice.outcome select');
  await select.focus();
  await grow(page, 'hurt');
  assert.ok(!(await offered(page, 'outcome')).includes('Hurt (1)'));
  await select.blur();
  assert.ok((await offered(page, 'outcome')).includes('Hurt (1)'));
});

test('a box keeps no query that another has replaced', async () => {
  setFlagsFromString('--expose-gc');
  const box = boxOf([0, 0, 0], [1, 1, 1]);
  const ask = () => {
    const query = { paths: [] };
    pathsThrough(query, box);
    return new WeakRef(query);
  };
  const asked = ask();
  await new Promise(setImmediate); // a WeakRef holds on until then
  runInNewContext('gc')();
  assert.equal(asked.deref(), undefined);
  assert.equal(pathsThrough({ paths: [] }, box).size, 0);
});

test('what needs an answer is offered once it has come', async ({ page }) => {
  const offers = () =>
    page.evaluate(() => {
      const labels = [...document.querySelectorAll('.toggles label')];
      return !labels.find((label) => /not of the search/.test(label.textContent)).hidden;
    });
  await page.evaluate(() => {
    const { report, store } = window.obby;
    const query = window.obby.query();
    window.answer = (heatMap) => {
      report.queries[0] = { ...query, result: { ...query.result, heatMap } };
      window.obby.openQuery();
      window.obby.ways.choose();
    };
    window.heatMap = query.result.heatMap;
    window.answer(undefined);
    store.set({ heat: true });
  });
  assert.equal(await offers(), false);
  await page.evaluate(() => window.answer(window.heatMap));
  assert.equal(await offers(), true);
  await page.evaluate(() => window.obby.store.set({ heat: false }));
});

test('there may be more ways than a call takes arguments', async ({ page }) => {
  const ticks = await page.evaluate(() => {
    const app = window.obby;
    const paths = new Array(300000).fill({ ticks: 7000 });
    const many = { path: () => undefined, level: () => app.level(), query: () => ({ paths }) };
    return app.length.call(many);
  });
  assert.equal(ticks, 7000);
});

test('numbers are rounded to three digits, whatever unit that takes', () => {
  for (const [number, text] of [
    [9999, '9999'],
    [99949, '99.9 k'],
    [999499, '999 k'],
    [999600, '1.00 M'],
    ['1234567', '1.23 M'],
    [999700000, '1.00 G'],
  ])
    assert.equal(count(number), text);
});

test('all of that raised no error', async ({ page, trouble }) => {
  await frames(page);
  assert.deepEqual(trouble, []);
});

await run(options.sample(report));
