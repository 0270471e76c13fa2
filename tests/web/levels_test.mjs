// Several levels in one report, none at all, and a picture that comes and goes.
import assert from 'node:assert/strict';
import { colours, frames, openReport, state } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const [level] = report.levels;
const [course, without] = report.queries;
const file = options.sample({
  ...report,
  levels: [level, { ...level, name: 'Another' }],
  queries: [course, { ...course, id: 'elsewhere', level: 1 }],
});

async function visit(page, query) {
  await page.evaluate((index) => window.obby.store.set({ query: index }), query);
  await frames(page, 3);
}

test('a level that is left frees what it held on the GPU', async ({ page }) => {
  const held = () => page.evaluate(() => ({ ...window.obby.stage.renderer.info.memory }));
  await visit(page, 1);
  await visit(page, 0);
  const before = await held();
  assert.ok(before.geometries > 0 && before.textures > 0);
  for (let round = 0; round < 3; round++) {
    await visit(page, 1);
    await visit(page, 0);
  }
  assert.deepEqual(await held(), before);
});

test('every level has the colours that the reader has chosen', async ({ page }) => {
  const lava = level.names.findIndex((name) => name.endsWith('/Lava'));
  const colourOf = () =>
    page.evaluate((part) => {
      const { levelView } = window.obby.stage;
      const [{ mesh, at }] = levelView.slots[part];
      return [...mesh.instanceColor.array.slice(3 * at, 3 * at + 3)];
    }, lava);
  const byRole = await colourOf();
  await page.locator('#view').focus();
  await page.keyboard.press('c');
  const own = await colourOf();
  assert.notDeepEqual(own, byRole);
  await visit(page, 1);
  assert.deepEqual(await colourOf(), own);
  await page.keyboard.press('c');
  await visit(page, 0);
  assert.deepEqual(await colourOf(), byRole);
});

test('the wheel moves in from as far away as a large course takes', async ({ page }) => {
  const far = await page.evaluate(() => {
    const { rig, bounds } = window.obby.stage;
    rig.frameBox(bounds.clone().expandByScalar(20000), { yaw: 0.5, pitch: -0.5 }, true);
    return rig.goal.distance;
  });
  await page.mouse.move(700, 300);
  await page.mouse.wheel(0, -70);
  await page.waitForFunction((d) => window.obby.stage.rig.goal.distance < d, far);
  const near = await page.evaluate(() => window.obby.stage.rig.goal.distance);
  assert.ok(near > 0.8 * far, `${far} to ${near} studs`);
  await page.evaluate(() => window.obby.stage.frameQuery(true));
});

test('all of that raised no error', async ({ trouble }) => assert.deepEqual(trouble, []));

test('a picture that the GPU has lost is drawn again', async ({ browser }) => {
  const { page } = await openReport(browser, file);
  assert.ok((await colours(page)).different > 40);
  await page.evaluate(
    () =>
      new Promise((done) => {
        const { canvas, renderer } = window.obby.stage;
        const gpu = renderer.getContext().getExtension('WEBGL_lose_context');
        canvas.addEventListener('webglcontextlost', () => setTimeout(() => gpu.restoreContext()));
        canvas.addEventListener('webglcontextrestored', done);
        gpu.loseContext();
      }),
  );
  await frames(page, 5);
  assert.ok((await colours(page, false)).different > 40, 'nothing was drawn');
  await page.context().close();
});

test('answers without their level are told, and nothing in the picture fails', async ({
  browser,
}) => {
  const alone = { ...without, level: -1, trajectories: [] };
  const bare = options.sample({ ...report, levels: [], queries: [alone] });
  const { page, trouble } = await openReport(browser, bare);
  assert.match(await page.locator('.findings').innerText(), /solvable without Lava/);
  await page.locator('.ends .killer').first().click();
  await page.locator('#view').click({ position: { x: 400, y: 300 } });
  for (const key of ['b', 'c', 'f', 't', '9']) await page.keyboard.press(key);
  assert.equal((await state(page)).drawing, true);
  await page.locator('#view').click({ position: { x: 400, y: 300 } });
  await frames(page, 3);
  assert.equal((await state(page)).part, -1);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

test('queries of one id are told apart by their level', async ({ browser }) => {
  const two = options.sample({
    ...report,
    levels: [level, { ...level, name: 'Another' }],
    queries: [course, without, { ...course, level: 1 }],
  });
  const { page, trouble } = await openReport(browser, two);
  assert.deepEqual(await page.locator('.query .name').allTextContents(), [
    'whole course · Sample',
    'without jumping',
    'whole course · Another',
  ]);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

test('a query without its level shows no picture of the one before', async ({ browser }) => {
  const lost = { ...without, level: -1, trajectories: [] };
  const mixed = options.sample({ ...report, levels: [level], queries: [course, lost] });
  const { page, trouble } = await openReport(browser, mixed);
  const seen = async () => ({
    colours: (await colours(page, false)).different,
    words: await page.evaluate(() =>
      ['labels', 'hud'].map((id) => !document.getElementById(id).hidden),
    ),
  });
  const before = await seen();
  assert.ok(before.colours > 40);
  assert.deepEqual(before.words, [true, true]);
  await visit(page, 1);
  assert.deepEqual(await seen(), { colours: 1, words: [false, false] });
  await visit(page, 0);
  assert.ok((await seen()).colours > 40);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

test('parts that the level does not have are told, and a click on them shows none', async ({
  browser,
}) => {
  const result = {
    ...without.result,
    cut: { ...without.result.cut, from: 9999, to: 9998, reached: [0, 9999] },
    relaxations: [{ text: 'solvable without what was there', part: 9999, avoid: -1 }],
    ends: [{ outcome: 'killed', part: 9999, count: '3' }],
  };
  const older = options.sample({
    ...report,
    levels: [level],
    queries: [{ ...without, result, trajectories: [] }],
  });
  const { page, trouble } = await openReport(browser, older);
  assert.match(await page.locator('.findings').innerText(), /part 9999 to part 9998/);
  assert.equal(await page.locator('.findings button:not(.way)').count(), 0);
  await page.locator('.ends .killer').first().click();
  const { part, killer } = await state(page);
  assert.deepEqual([part, killer], [-1, 9999]);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

test('of thousands of regions those are drawn and named that can be looked at', async ({
  browser,
}) => {
  const avoid = Array.from({ length: 3000 }, (_, i) => ({
    ...course.avoid[0],
    name: `Lava ${i}`,
    position: [2 * (i % 60), 0, -Math.floor(i / 60)],
  }));
  const tagged = options.sample({
    ...report,
    levels: [level],
    queries: [{ ...course, avoid, waypoints: [] }],
  });
  const { page, trouble } = await openReport(browser, tagged);
  const { boxes, labels } = await page.evaluate(() => {
    const { group, labels: all } = window.obby.stage.regionView;
    return { boxes: group.children.length, labels: all.length };
  });
  assert.deepEqual([boxes, labels], [2 + 500, 2 + 40], 'start and goal, and those to avoid');
  const asked = await page.locator('.limits').innerText();
  assert.match(asked, /3000 regions to avoid \(500 are drawn\)/);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

// Places have collision hulls that are flat, and made-up levels any.
test('a hull that is a line or a point keeps nothing else from being shown', async ({
  browser,
}) => {
  const part = level.hulls[0].part;
  const hull = (numbers) => Buffer.from(Float32Array.from(numbers).buffer).toString('base64');
  const pieces = [
    hull([0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3]),
    hull([1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0]),
    hull([0, 0, 0, 4, 0, 0, 4, 0, 4, 0, 0, 4]),
    hull([]),
  ];
  const odd = options.sample({ ...report, levels: [{ ...level, hulls: [{ part, pieces }] }] });
  const { page, trouble } = await openReport(browser, odd);
  assert.ok((await colours(page)).different > 40);
  assert.equal(await page.evaluate((i) => window.obby.stage.levelView.slots[i].length, part), 4);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

test('parts of one mesh are drawn together', async ({ browser }) => {
  const { part, pieces } = level.hulls[0];
  const shape = Buffer.from(level.parts.shape, 'base64');
  shape[0] = shape[part];
  const parts = { ...level.parts, shape: shape.toString('base64') };
  const hulls = [0, part].map((each) => ({ part: each, pieces }));
  const copied = options.sample({ ...report, levels: [{ ...level, parts, hulls }] });
  const { page, trouble } = await openReport(browser, copied);
  const meshes = await page.evaluate(
    (i) =>
      window.obby.stage.levelView.group.children
        .filter((mesh) => mesh.userData.parts.includes(i))
        .map((mesh) => mesh.userData.parts),
    part,
  );
  assert.deepEqual(meshes, [[0, part]]);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

await run(file);
