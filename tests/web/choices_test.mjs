// The filters' choices and counts, and how they follow a growing report.
import assert from 'node:assert/strict';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { boxOf, meets, pathsThrough } from '../../web/src/choice.js';
import { coloring } from '../../web/src/coloring.js';
import { deathLabels } from '../../web/src/death_labels.js';
import { tickAt } from '../../web/src/fragment.js';
import { causeOf, hardestOf } from '../../web/src/palette.js';
import { corners } from '../../web/src/scene/straight.js';
import { count } from '../../web/src/ui/dom.js';
import { frames } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const trajectories = report.queries[0].trajectories.length;
const offered = (page, name) => page.locator(`.choice.${name} option`).allTextContents();

// Adds a copy of the selected query's first attempt with another outcome, as live data would.
const grow = (page, outcome) =>
  page.evaluate((ended) => {
    const app = window.obby;
    const query = app.query();
    const trajectory = query.paths.find((path) => path.kind === 'attempt');
    const more = Object.assign(Object.create(Object.getPrototypeOf(trajectory)), trajectory, { outcome: ended });
    app.report.queries[0] = { ...query, paths: [...query.paths, more] };
    app.openQuery();
    app.filters.refresh();
    app.trajectories.choose();
  }, outcome);

test('every list of choices begins with any', async ({ page }) => {
  await page.locator('.filters .fold').click();
  for (const name of ['outcome', 'route', 'killer']) {
    const texts = await offered(page, name);
    assert.equal(texts[0], 'any', `${name}: ${texts}`);
    assert.ok(texts.length > 2);
  }
});

test('boxes count new trajectories and keep typed text', async ({ page }) => {
  const all = { min: [-500, -500, -500], max: [500, 500, 500], keep: true };
  await page.evaluate((box) => window.obby.store.set({ boxes: [box] }), all);
  const counted = page.locator('.box output');
  assert.equal(await counted.innerText(), `${trajectories} trajectories pass through`);
  const field = page.getByLabel('Box 1 from x');
  await field.fill('-7');
  await grow(page, 'fell');
  assert.equal(await counted.innerText(), `${trajectories + 1} trajectories pass through`);
  assert.equal(await field.inputValue(), '-7');
  await page.evaluate(() => window.obby.store.set({ boxes: [] }));
});

test('a list of choices never grows while in use', async ({ page }) => {
  const select = page.locator('.choice.outcome select');
  await select.focus();
  await grow(page, 'hurt');
  assert.ok(!(await offered(page, 'outcome')).includes('Hurt (1)'));
  await select.blur();
  assert.ok((await offered(page, 'outcome')).includes('Hurt (1)'));
});

test('a box keeps no query that has been replaced', async () => {
  setFlagsFromString('--expose-gc');
  const box = boxOf([0, 0, 0], [1, 1, 1]);
  const ask = () => {
    const query = { paths: [] };
    pathsThrough(query, box);
    return new WeakRef(query);
  };
  const asked = ask();
  await new Promise(setImmediate); // a WeakRef keeps its target until then
  runInNewContext('gc')();
  assert.equal(asked.deref(), undefined);
  assert.equal(pathsThrough({ paths: [] }, box).size, 0);
});

test('choices that need an answer appear with it', async ({ page }) => {
  const offers = () =>
    page.evaluate(() => {
      const labels = [...document.querySelectorAll('.toggles label')];
      return !labels.find((label) => /of listed trajectories only/.test(label.textContent)).hidden;
    });
  await page.evaluate(() => {
    const { report, store } = window.obby;
    const query = window.obby.query();
    window.answer = (heatMap) => {
      report.queries[0] = { ...query, result: { ...query.result, heatMap } };
      window.obby.openQuery();
      window.obby.trajectories.choose();
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

test('more trajectories than call arguments are handled', async ({ page }) => {
  const ticks = await page.evaluate(() => {
    const app = window.obby;
    const paths = new Array(300000).fill({ ticks: 7000 });
    const many = { path: () => undefined, level: () => app.level(), query: () => ({ paths }) };
    return app.length.call(many);
  });
  assert.equal(ticks, 7000);
});

test('numbers are rounded to three digits in any unit', () => {
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

test('trajectories far from a box are skipped', () => {
  const trajectory = { samples: 3, points: Float32Array.from([0, 0, 0, 5, 2, 0, 9, 0, 0]) };
  const crossed = boxOf([4, 0, -1], [6, 3, 1]);
  assert.equal(meets(trajectory, crossed), true);
  assert.equal(meets(trajectory, boxOf([0, 1.9, -1], [1, 2, 1])), false, 'near, and not met');
  trajectory.points = new Proxy(trajectory.points, {
    get() {
      throw new Error('looked at');
    },
  });
  assert.equal(meets(trajectory, boxOf([20, 0, -1], [30, 9, 9])), false);
  assert.equal(meets(trajectory, boxOf([0, -9, -1], [9, -1, 9])), false);
  assert.throws(() => meets(trajectory, crossed), /looked at/);
});

// Returns the distance from a point to the polyline through other points, in studs.
function besideTrajectory(points, at) {
  let lowest = Infinity;
  for (let i = 0; i + 5 < points.length; i += 3) {
    const by = [0, 1, 2].map((k) => points[i + 3 + k] - points[i + k]);
    const off = [0, 1, 2].map((k) => at[k] - points[i + k]);
    const dot = (a, b) => a.reduce((sum, v, k) => sum + v * b[k], 0);
    const share = Math.min(1, Math.max(0, dot(off, by) / (dot(by, by) || 1)));
    lowest = Math.min(lowest, Math.hypot(...off.map((v, k) => v - share * by[k])));
  }
  return lowest;
}

test('motion paths are simplified within a tolerance', () => {
  const samplesOf = (count, at) =>
    Float32Array.from(Array.from({ length: count }, (_, i) => at(i)).flat());
  // Moves from 1010 to 1000 and back.
  const there = (i) => [1000 + 0.1 * Math.abs(100 - i), 3, -27];
  assert.deepEqual([...corners(samplesOf(201, there))], [1010, 3, -27, 1000, 3, -27, 1010, 3, -27]);
  const still = samplesOf(5, () => [1, 2, 3]);
  assert.deepEqual([...corners(still)], [1, 2, 3, 1, 2, 3]);
  const round = samplesOf(721, (i) => [10 * Math.cos(i / 114.6), i / 300, 10 * Math.sin(i / 114.6)]);
  const drawn = corners(round);
  assert.ok(drawn.length < round.length / 4, `${drawn.length / 3} points`);
  for (let i = 0; i < round.length; i += 3) {
    const beside = besideTrajectory(drawn, round.subarray(i, i + 3));
    assert.ok(beside <= 0.0201, `sample ${i / 3}: ${beside} studs`);
  }
});

test('a time in an address keeps its tick', () => {
  for (const rate of [10, 60, 240, 480])
    for (let tick = 0; tick < 3 * rate; tick++)
      assert.equal(tickAt(Number((tick / rate).toFixed(3)), rate), tick);
  assert.ok(Math.abs(tickAt(0.009, 60) - 0.54) < 1e-9, 'between two ticks');
});

test('an unnamed part is identified by its number', () => {
  const level = { count: 2, names: ['', 'Workspace/Lava'] };
  const killed = (part) => ({ outcome: 'killed', part, end: () => [0, 0, 0] });
  assert.equal(causeOf(killed(0), level), 'Killed by part 0');
  assert.equal(causeOf(killed(1), level), 'Killed by Workspace/Lava');
  assert.deepEqual(
    deathLabels([killed(0), killed(1), killed(1)], level, 6).map(({ text }) => text),
    ['✕ 2 killed by Lava', '✕ 1 killed by part 0'],
  );
  const hardest = { from: 0, to: -1, band: 'hard', window: 0 };
  const difficulty = { hardest, noise: 'average' };
  assert.equal(hardestOf({ difficulty }, level), 'Hardest step: part 0 to the goal, hard (average)');
});

test('a query without trajectories colours no number', () => {
  for (const mode of ['time', 'jumps'])
    assert.deepEqual(coloring({ paths: [] }, undefined, mode).legend, []);
});

test('another colouring updates the present rows', async ({ page }) => {
  const first = (by) =>
    page.evaluate((colorBy) => {
      window.row ??= document.querySelector('.path');
      window.obby.store.set({ colorBy });
      const tint = window.row.querySelector('.swatch').style.getPropertyValue('--tint');
      return { there: window.row.isConnected, tint };
    }, by);
  const [before, after] = [await first('outcome'), await first('time')];
  assert.deepEqual([before.there, after.there], [true, true]);
  assert.notEqual(after.tint, before.tint);
  assert.deepEqual(await first('outcome'), before);
});

test('a smaller level can follow a part selection', async ({ page }) => {
  const seen = await page.evaluate(() => {
    const { report: told, store } = window.obby;
    const [level] = told.levels;
    const none = { tracks: [], hulls: [], vanish: [], conveyors: [], bodies: [] };
    told.levels.push({ ...level, ...none, count: 3, role: level.role.slice(0, 3) });
    told.queries.push({ ...told.queries[1], index: told.queries.length, level: 1, paths: [] });
    store.set({ query: 0, part: level.count - 1 });
    const inspector = document.querySelector('.inspector');
    const before = inspector.hidden;
    store.set({ query: told.queries.length - 1 });
    return [before, inspector.hidden, store.state.part, window.obby.stage.level.count];
  });
  assert.deepEqual(seen, [false, true, -1, 3]);
  await page.evaluate(() => window.obby.store.set({ query: 0 }));
});

test('a query without trajectories shows no box', async ({ page }) => {
  const seen = await page.evaluate(() => {
    const { report: told, store, stage } = window.obby;
    const empty = told.queries.length;
    told.queries.push({ ...told.queries[1], index: empty, paths: [] });
    const at = (query) => {
      store.set({ query });
      return [stage.filterBoxes.group.visible, store.state.drawing];
    };
    store.set({ query: 0 });
    store.set({ drawing: true, boxes: [{ min: [-9, -9, -9], max: [9, 9, 9], keep: true }] });
    const shown = [at(0), at(empty), at(0)];
    const boxes = store.state.boxes.length;
    store.set({ boxes: [] });
    return { shown, boxes };
  });
  assert.deepEqual(seen.shown, [
    [true, true],
    [false, false],
    [true, false],
  ]);
  assert.equal(seen.boxes, 1, 'the filter of the other queries stays');
});

// A button under the player's feet may take parts away and bring them back for hours.
test('the profile marks dense events separately', async ({
  page,
}) => {
  const seen = await page.evaluate(() => {
    const { store, stage } = window.obby;
    store.set({ query: 0 });
    store.set({ path: -1 });
    const trajectory = window.obby.query().paths[0];
    const { part } = window.obby.level().vanish[0];
    const told = trajectory.events;
    trajectory.events = Array.from({ length: 300001 }, (_, i) => [Math.floor(i / 1000), part, i % 2]);
    store.set({ path: 0 });
    const marks = document.querySelectorAll('.profile .mark.event').length;
    const away = [10, 300, 20].map((tick) => stage.gone.at(trajectory.events, tick).has(part));
    trajectory.events = told;
    store.set({ path: -1 });
    return { marks, away };
  });
  assert.ok(seen.marks > 200 && seen.marks <= 2001, `${seen.marks} marks`);
  assert.deepEqual(seen.away, [false, true, false]);
});

test('the page raised no error', async ({ page, trouble }) => {
  await frames(page);
  assert.deepEqual(trouble, []);
});

await run(options.sample(report));
