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

await run(file);
