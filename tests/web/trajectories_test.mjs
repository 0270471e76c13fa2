// The list of trajectories with filters and sorting, colours, isolation, boxes, deaths.
import assert from 'node:assert/strict';
import { arrive, frames, state } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const set = (page, values) => page.evaluate((v) => window.obby.store.set(v), values);
const paths = report.queries[0].trajectories;

// Returns the number of line segments drawn for attempts.
const drawn = (page) =>
  page.evaluate(() => window.obby.stage.pathView.attempts.geometry.drawRange.count / 2);

test('outcome filters thin list and picture and show counts', async ({
  page,
}) => {
  await page.locator('.filters .fold').click();
  const all = await drawn(page);
  await page.locator('.choice.outcome select').selectOption('killed');
  const killed = paths.filter((path) => path.outcome === 'killed');
  assert.equal(await page.locator('.path').count(), killed.length);
  assert.equal(
    await page.locator('.count').innerText(),
    `${killed.length} of ${paths.length} trajectories`,
  );
  assert.equal(
    await drawn(page),
    killed.reduce((sum, path) => sum + path.ticks, 0),
  );
  await page.locator('.filters .text', { hasText: 'Clear all' }).click();
  assert.equal(await drawn(page), all);
});

test('filters by jumps, time and route', async ({ page }) => {
  await page.locator('.choice.maxJumps input').fill('4');
  assert.equal((await state(page)).order.length, paths.filter((path) => path.jumps <= 4).length);
  await page.locator('.choice.maxJumps input').fill('');
  await page.locator('.choice.maxSeconds input').fill('3.5');
  assert.equal((await state(page)).order.length, paths.filter((path) => path.ticks <= 210).length);
  await page.locator('.choice.maxSeconds input').fill('');
  await page.locator('.choice.route select').selectOption({ label: 'Spawn → Landing (1)' });
  assert.deepEqual((await state(page)).order, [1]);
  await page.locator('.choice.route select').selectOption('');
});

test('sorts by time, and arrow keys follow the list', async ({ page }) => {
  await page.locator('.choice.sort select').selectOption('time');
  const ticks = async () => (await state(page)).order.map((i) => paths[i].ticks);
  const sorted = [...paths.map((path) => path.ticks)].sort((a, b) => a - b);
  assert.deepEqual(await ticks(), sorted);
  await page.locator('.direction').click();
  assert.deepEqual(await ticks(), sorted.reverse());
  const { order } = await state(page);
  await set(page, { path: order[2] });
  await page.locator('#view').focus();
  await page.keyboard.press('ArrowDown');
  assert.equal((await state(page)).path, order[3]);
  await set(page, { sort: 'found', descending: false });
});

test('colours by time, jumps, route, method and difficulty, with a legend', async ({ page }) => {
  const colourOf = (index) =>
    page.evaluate((i) => window.obby.trajectories.coloring.of(window.obby.query().paths[i]), index);
  for (const mode of ['time', 'jumps', 'route', 'difficulty']) {
    await page.locator('.choice.colorBy select').selectOption(mode);
    assert.ok((await page.locator('.legend .swatch').count()) >= 2, mode);
    assert.notEqual(await colourOf(0), await colourOf(2), mode);
    await frames(page);
    await options.picture(page, `colours-${mode}`);
  }
  await page.locator('.choice.colorBy select').selectOption('method');
  assert.notEqual(await colourOf(0), await colourOf(1));
  assert.deepEqual(await page.locator('.legend').getByText(/^(auto|ge)$/).allTextContents(), [
    'auto',
    'ge',
  ]);
  await page.locator('.choice.colorBy select').selectOption('outcome');
});

test('an unknown difficulty band is shown as unknown', async ({ page }) => {
  const seen = await page.evaluate(() => {
    const { store, list } = window.obby;
    const { path } = store.state;
    const [trajectory] = window.obby.query().paths;
    const told = trajectory.difficulty;
    const show = (difficulty, chosen) => {
      trajectory.difficulty = difficulty;
      store.set({ path: -1 });
      list.fill();
      store.set({ path: chosen });
    };
    const band = 'unknown';
    show({ ...told, band, hardest: { ...told.hardest, band } }, 0);
    const { textContent } = document.querySelector('.path .band');
    const marked = document.querySelectorAll('.profile .hardest').length;
    show(told, path);
    return [textContent, marked];
  });
  assert.deepEqual(seen, ['Unknown', 1]);
});

test('a click on a route toggles its filter', async ({ page }) => {
  const route = page.locator('.findings .trajectory').nth(1);
  assert.equal(await route.innerText(), 'Spawn → Landing');
  await route.click();
  const only = paths.filter((path) => path.route.join(' ') === '0 6');
  assert.equal(await page.locator('.path').count(), only.length);
  await route.click();
  assert.equal(await page.locator('.path').count(), paths.length);
});

test('isolating draws only the selected trajectory', async ({ page }) => {
  await page.locator('#view').focus();
  await page.keyboard.press('i');
  assert.equal(await drawn(page), 0);
  assert.equal((await state(page)).order.length, paths.length, 'the list stays');
  await page.keyboard.press('i');
  assert.ok((await drawn(page)) > 0);
});

test('a click on a killer shows its trajectories', async ({ page }) => {
  await page.locator('.ends .killer', { hasText: 'Spinner' }).click();
  const { order, part } = await state(page);
  assert.ok(order.length > 0);
  assert.ok(order.every((i) => paths[i].part === part && paths[i].outcome === 'killed'));
  assert.match(await page.locator('.inspector').innerText(), /Spinner/);
  await page.locator('.ends .killer', { hasText: 'Spinner' }).click();
  assert.equal((await state(page)).order.length, paths.length);
});

test('a drawn box keeps or drops trajectories through it', async ({ page }) => {
  await page.locator('#view').focus();
  await page.keyboard.press('t');
  await arrive(page);
  // A box over the second step, which every trajectory but the shortest passes.
  const corners = await page.evaluate(() => {
    const { rig, width, height } = window.obby.stage;
    const frame = document.getElementById('view').getBoundingClientRect();
    return [
      [-2.4, 1.5, -13.4],
      [2.4, 1.5, -8.6],
    ].map((corner) => {
      const p = rig.camera.position.clone().fromArray(corner).project(rig.camera);
      return [frame.left + ((p.x + 1) / 2) * width, frame.top + ((1 - p.y) / 2) * height];
    });
  });
  await page.keyboard.press('b');
  await page.mouse.move(...corners[0]);
  await page.mouse.down();
  await page.mouse.move(...corners[1], { steps: 4 });
  await page.mouse.up();
  const { boxes, order, drawing } = await state(page);
  assert.equal(drawing, false);
  assert.equal(boxes.length, 1);
  for (const [got, wanted] of [
    [boxes[0].min[0], -2.4],
    [boxes[0].max[0], 2.4],
    [boxes[0].min[2], -13.4],
    [boxes[0].max[2], -8.6],
  ])
    assert.ok(Math.abs(got - wanted) < 0.3, `${got}, drawn at ${wanted}`);
  assert.ok(order.length > 0 && order.length < paths.length, `${order.length} pass`);
  assert.match(
    await page.locator('.box output').innerText(),
    new RegExp(`^${order.length} trajectories pass through$`),
  );
  await frames(page);
  await options.picture(page, 'box');
  await page.locator('.box select').selectOption('drop');
  const dropped = (await state(page)).order;
  assert.deepEqual(
    [...order, ...dropped].sort((a, b) => a - b),
    paths.map((_, i) => i),
  );
});

test('an edited box finds trajectories between samples', async ({ page }) => {
  for (const end of ['from', 'to']) {
    const field = page.getByLabel(`Box 1 ${end} y`);
    await field.fill(end === 'from' ? '-60' : '-50');
    await field.press('Enter');
  }
  assert.equal((await state(page)).order.length, paths.length, 'nothing passes so far down');
  const between = await page.evaluate(() => {
    const { store } = window.obby;
    const { points } = window.obby.query().paths[0];
    const at = [0, 1, 2].map((k) => (points[3 * 20 + k] + points[3 * 21 + k]) / 2);
    const box = { min: at.map((v) => v - 0.01), max: at.map((v) => v + 0.01), keep: true };
    store.set({ boxes: [box] });
    return store.state.order;
  });
  assert.ok(between.includes(0));
  await page.getByLabel('Remove box 1').click();
  assert.equal((await state(page)).order.length, paths.length);
});

test('a click draws no box', async ({ page }) => {
  await page.locator('#view').focus();
  await page.keyboard.press('b');
  await page.mouse.move(700, 300);
  await page.mouse.down();
  await page.mouse.up();
  await page.mouse.move(780, 340, { steps: 4 });
  const { boxes, drawing } = await state(page);
  assert.deepEqual([boxes.length, drawing], [0, true], 'the drag is still to come');
  await page.keyboard.press('Escape');
});

test('deaths of shown trajectories name the killer', async ({ page }) => {
  const labels = () => page.locator('#labels .label').allTextContents();
  assert.ok((await labels()).includes('✕ 4 killed by Lava'), String(await labels()));
  await set(page, { outcome: 'fell' });
  assert.ok(!(await labels()).some((text) => text.includes('Lava')));
  await set(page, { outcome: '' });
});

test('the heat map counts listed trajectories once per cell', async ({ page }) => {
  await page.locator('#view').focus();
  await page.keyboard.press('9');
  await set(page, { heatTrajectories: true });
  const fullest = () => page.evaluate(() => window.obby.stage.heat.max);
  assert.equal(await fullest(), paths.length, 'all start in one cell');
  await set(page, { outcome: 'killed' });
  assert.equal(await fullest(), paths.filter((path) => path.outcome === 'killed').length);
  await set(page, { outcome: '' });
  await frames(page);
  await options.picture(page, 'heat');
  const fold = page.getByRole('button', { name: 'Display' });
  await fold.click();
  await page.getByText('of listed trajectories only').click();
  assert.equal(await fullest(), 90, "the search's own cells");
  await frames(page);
  await options.picture(page, 'heat-search');
  await fold.click();
  await page.keyboard.press('9');
  assert.equal(await page.evaluate(() => window.obby.stage.heat.group.children.length), 0);
});

test('jumps and landings of the selected trajectory are marked', async ({ page }) => {
  await set(page, { path: 0 });
  const marked = await page.evaluate(() =>
    window.obby.stage.marks.group.children.map((cloud) => cloud.geometry.attributes.position.count),
  );
  assert.deepEqual(marked, [1, 12]); // this trajectory walks only one segment, on the belt
  assert.equal(await page.locator('.mark.jump').count(), 12);
  assert.equal(await page.locator('.mark.event').count(), 2);
});

test('an unreachable query explains its cut and advice', async ({
  page,
}) => {
  await set(page, { query: 1 });
  await arrive(page);
  assert.match(
    await page.locator('.findings').innerText(),
    /Why there is no solution[\s\S]*3 parts are reachable[\s\S]*Step 2 to Landing[\s\S]*at least 1.5 studs of height/,
  );
  assert.ok((await page.locator('#labels').textContent()).includes('✕ at least 1.5 studs of height'));
  await page.locator('.findings .text', { hasText: 'without Lava' }).click();
  assert.match(await page.locator('.inspector').innerText(), /Lava/);
  await arrive(page);
  await options.picture(page, 'cut');
  await set(page, { query: 0 });
});

test('the page raised no error and made no request', async ({ trouble, requests }) => {
  assert.deepEqual(trouble, []);
  assert.equal(requests.length, 1, requests.join());
});

await run(options.sample(report));
