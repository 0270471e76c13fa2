// Tests the page before the reader touches anything. The page shows a query with an answer,
// distinguishable rows, a player at its start, no clock if nothing can be played, and a legend of
// the colours.
import assert from 'node:assert/strict';
import { coloring } from '../../web/src/coloring.js';
import { routeNames } from '../../web/src/route_names.js';
import { solutionNames } from '../../web/src/solution_names.js';
import { decimal } from '../../web/src/ui/dom.js';
import { frames, openReport, state } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const [level] = report.levels;
const [course, without] = report.queries;
const unanswered = { ...without, id: 'not asked', result: undefined, trajectories: [] };
const still = { ...level, name: 'Still', tracks: [], vanish: [], conveyors: [] };
const file = options.sample({
  ...report,
  levels: [level, still],
  queries: [unanswered, { ...unanswered, id: 'still', level: 1 }, course],
});

const place = { count: 5, names: ['A/Spawn', 'A/Plank', 'A/Plank', 'A/Lift', 'A/Finish'] };
const solution = (route, ticks, jumps) => ({ kind: 'solution', route, ticks, jumps });
const marks = (...routes) =>
  [...routeNames({ paths: routes.map((route) => ({ route })) }, place).values()].map(
    ({ mark }) => mark,
  );

test('routes are distinguished by their unshared parts', () => {
  assert.deepEqual(marks([0, 1, 4]), [''], 'there is one only');
  assert.deepEqual(marks([0, 3, 4], [0, 1, 4]), ['over the Lift', 'over the Plank']);
  assert.deepEqual(marks([0, 4], [0, 3, 4]), ['not over the Lift', 'over the Lift']);
  assert.deepEqual(marks([0, 1, 4], [0, 2, 4]), ['over Plank #1', 'over Plank #2']);
  assert.deepEqual(
    marks([0, 1, 2, 4], [0, 1, 4], [0, 2, 4]),
    ['over Plank #1, over Plank #2', 'not over Plank #2', 'not over Plank #1'],
    'one part alone is not enough',
  );
  assert.deepEqual(marks([0, 1, 3, 4], [0, 3, 1, 4]), ['route 1', 'route 2'], 'the same parts');
});

test('routes with the same text show their difference', () => {
  const paths = [[0, 1, 4], [0, 2, 4], [0, 3, 4]].map((route) => ({ route }));
  assert.deepEqual(
    [...routeNames({ paths }, place).values()].map(({ text }) => text),
    [
      'Spawn → Plank → Finish (over Plank #1)',
      'Spawn → Plank → Finish (over Plank #2)',
      'Spawn → Lift → Finish',
    ],
  );
});

test('every solution has its own name', () => {
  const paths = [
    solution([0, 1, 4], 330, 3),
    solution([0, 3, 4], 330, 3),
    solution([0, 3, 4], 330, 3),
    solution([0, 3, 4], 360, 1),
    { kind: 'attempt', route: [], ticks: 9, jumps: 0 },
  ];
  assert.deepEqual(
    [...solutionNames({ paths }, place)].map(([index, { name, facts }]) => [index, name, ...facts]),
    [
      [0, 'over the Plank', '3 jumps', '5.50 s'],
      [1, 'over the Lift', '3 jumps', '5.50 s'],
      [2, 'over the Lift (2)', '3 jumps', '5.50 s'],
      [3, 'over the Lift', '1 jump', '6.00 s'],
    ],
  );
});

test('solutions of one route are named by jumps and time', () => {
  const paths = [solution([0, 1], 330, 3), solution([0, 1], 192, 1)];
  assert.deepEqual(
    [...solutionNames({ paths }, place).values()],
    ['3 jumps, 5.50 s', '1 jump, 3.20 s'].map((name) => ({ name, facts: [] })),
  );
});

test('no number is minus zero', () => {
  assert.deepEqual([-0.04, 0, -0.06, 12.34].map((value) => decimal(value)), [
    '0.0',
    '0.0',
    '-0.1',
    '12.3',
  ]);
});

test('the first query with an answer is shown', async ({ page }) => {
  assert.equal((await state(page)).query, 2);
  assert.match(await page.locator('.verdict').innerText(), /Solved/);
  assert.match(await page.locator('.query').first().innerText(), /Not asked/);
});

test('rows show routes of solutions and ends of attempts', async ({
  page,
}) => {
  const rows = await page.locator('.path').allTextContents();
  assert.match(rows[0], /^over Step 1\s*Hard\s*12 jumps\s*9\.00 s$/);
  assert.match(rows[1], /^not over Step 1\s*12 jumps\s*9\.00 s$/);
  assert.ok(rows.some((text) => /^Killed by Lava\s*\d+ jumps\s*\d\.\d\d s$/.test(text)));
});

test('the player starts standing with no key pressed', async ({ page }) => {
  const hud = page.locator('#hud');
  const held = () => hud.locator('.cap.down').count();
  assert.deepEqual([(await state(page)).tick, await held()], [0, 0]);
  assert.match(await hud.innerText(), /Speed\s+0\.0 studs\/s/);
  await page.locator('#view').focus();
  await page.keyboard.press('ArrowRight');
  await frames(page, 3);
  assert.ok((await held()) >= 2, 'a direction and the jump of the first tick');
  assert.doesNotMatch(await hud.innerText(), /Speed\s+0\.0 studs\/s/);
  await page.keyboard.press('Home');
});

test('failed attempts are listed and drawn on request', async ({ browser }) => {
  const { page } = await openReport(browser, file, { attempts: false });
  const shown = () =>
    page.evaluate(() => [
      document.querySelectorAll('.path').length,
      window.obby.stage.shown.size,
      document.querySelectorAll('.label[style*="f0484e"]').length > 0,
    ]);
  const [few, drawn, labels] = await shown();
  assert.deepEqual([few, labels], [drawn, false], 'no deaths are named');
  await page.locator('.list .attempts').click();
  const [all, drawnThen] = await shown();
  assert.deepEqual([all, drawnThen], [course.trajectories.length, course.trajectories.length]);
  assert.ok(few < all);
  await page.locator('#view').focus();
  await page.keyboard.press('2');
  assert.equal((await shown())[0], few);
  await page.locator('.killer').first().click();
  assert.equal((await state(page)).attempts, true, 'a click on a killer asks for its attempts');
  await page.context().close();
});

test('a query says from where to where it goes', async ({ page }) => {
  assert.match(await page.locator('.course').innerText(), /^From .+ to .+/);
});

test('the search effort is shown on request', async ({ page }) => {
  const effort = page.locator('.detail details');
  assert.equal(await effort.locator('dl').isVisible(), false);
  await effort.locator('summary').click();
  assert.match(await effort.innerText(), /Simulated ticks\s+8\.41 M/);
  await page.evaluate(() => window.obby.sidebar.refresh());
  assert.equal(await effort.locator('dl').isVisible(), true, 'it stays open');
});

test('the heat map has a scale', async ({ page }) => {
  const scale = page.locator('.legend .heat');
  assert.equal(await scale.count(), 0);
  await page.locator('#view').focus();
  await page.keyboard.press('9');
  assert.match(await scale.innerText(), /places explored per tile\s+1\s+9\s+90/);
  await page.evaluate(() => window.obby.store.set({ heatTrajectories: true }));
  assert.match(await scale.innerText(), /trajectories per tile\s+1\s+8\s+62/);
  await page.evaluate(() => window.obby.store.set({ heatTrajectories: false }));
  await page.keyboard.press('9');
  assert.equal(await scale.count(), 0);
});

test('the legend tells the closest attempt from the failed ones', () => {
  const paths = [{ kind: 'closest', outcome: 'running' }, { kind: 'attempt', outcome: 'fell' }];
  const { legend } = coloring({ paths }, undefined, 'outcome');
  assert.deepEqual(
    legend.map(([label, , swatch]) => [label, swatch]),
    [['Fell', 'attempt'], ['Unfinished', 'solution']],
  );
});

test('the clock is hidden if nothing can be played', async ({ page }) => {
  const shown = () => page.locator('#timeline .clock').isVisible();
  const go = (query) => page.evaluate((q) => window.obby.store.set({ query: q }), query);
  assert.equal(await shown(), true);
  await go(1);
  assert.equal(await shown(), false);
  assert.match(await page.locator('#timeline').innerText(), /Nothing to play/);
  await page.locator('#view').focus();
  await page.keyboard.press('Space');
  assert.equal((await state(page)).playing, false);
  assert.equal(await page.locator('#timeline').getByLabel('Shortcuts (?)').isVisible(), true);
  await go(0);
  assert.equal(await shown(), true, 'its moving parts run by the clock');
  await go(2);
});

test('the page raised no error', async ({ trouble }) => assert.deepEqual(trouble, []));

await run(file);
