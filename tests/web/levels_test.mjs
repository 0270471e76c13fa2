// Reports with several levels or none, and pictures that are lost or hidden.
import assert from 'node:assert/strict';
import { arrive, colours, countPrograms, frames, openReport, state } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const [level] = report.levels;
const [course, without] = report.queries;
const named = (name, values = {}) => ({ ...level, name, ...values });

// Returns a level with degenerate hulls: a line, a point, a plane, and one without points. Places
// have flat hulls, and hand-written levels may have any.
function oddHulls() {
  const hull = (numbers) => Buffer.from(Float32Array.from(numbers).buffer).toString('base64');
  const pieces = [
    hull([0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3]),
    hull([1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0]),
    hull([0, 0, 0, 4, 0, 0, 4, 0, 4, 0, 0, 4]),
    hull([]),
  ];
  return named('Odd hulls', { hulls: [{ part: level.hulls[0].part, pieces }] });
}

// Returns a level whose first part has the mesh of another part.
function copiedMesh() {
  const { part, pieces } = level.hulls[0];
  const shape = Buffer.from(level.parts.shape, 'base64');
  shape[0] = shape[part];
  const parts = { ...level.parts, shape: shape.toString('base64') };
  return named('Copied mesh', { parts, hulls: [0, part].map((each) => ({ part: each, pieces })) });
}

// Returns a query whose result names parts that the level does not have.
function ofOthers() {
  const { result } = without;
  return {
    ...without,
    id: 'of other parts',
    result: {
      ...result,
      cut: { ...result.cut, from: 9999, to: 9998, reached: [0, 9999] },
      relaxations: [{ text: 'solvable without what was there', part: 9999, avoid: -1 }],
      ends: [{ outcome: 'killed', part: 9999, count: '3' }],
    },
    trajectories: [],
  };
}

function avoidingThousands() {
  const avoid = Array.from({ length: 3000 }, (_, i) => ({
    ...course.avoid[0],
    name: `Lava ${i}`,
    position: [2 * (i % 60), 0, -Math.floor(i / 60)],
  }));
  return { ...course, id: 'avoiding thousands', avoid, waypoints: [] };
}

// Indices of the queries in the report.
const kHere = 0;
const kElsewhere = 1;
const kLost = 3;
const kOfOthers = 4;
const kThousands = 5;
const kOddHulls = 6;
const kCopiedMesh = 7;

const file = options.sample({
  ...report,
  levels: [level, named('Another'), oddHulls(), copiedMesh()],
  queries: [
    course,
    { ...course, level: 1 },
    without,
    { ...without, id: 'without its level', level: -1, trajectories: [] },
    ofOthers(),
    avoidingThousands(),
    { ...course, id: 'odd hulls', level: 2 },
    { ...course, id: 'copied mesh', level: 3 },
  ],
});

async function visit(page, query) {
  await page.evaluate((index) => window.obby.store.set({ query: index }), query);
  await arrive(page);
}

test('queries with one id are distinguished by level', async ({ page }) => {
  const names = await page.locator('.query .name').allTextContents();
  assert.deepEqual(names.slice(0, 4), [
    'whole course · Sample',
    'whole course · Another',
    'without jumping',
    'without its level',
  ]);
});

test('leaving a level frees its GPU memory', async ({ page }) => {
  const held = () => page.evaluate(() => ({ ...window.obby.stage.renderer.info.memory }));
  await visit(page, kElsewhere);
  await visit(page, kHere);
  const before = await held();
  assert.ok(before.geometries > 0 && before.textures > 0);
  for (let round = 0; round < 2; round++) {
    await visit(page, kElsewhere);
    await visit(page, kHere);
  }
  assert.deepEqual(await held(), before);
});

test('redrawing the same scene needs no new GPU programs', async ({ page }) => {
  await countPrograms(page);
  await visit(page, kElsewhere);
  await visit(page, kHere);
  await page.evaluate(() => window.obby.store.set({ path: 3 }));
  await frames(page, 3);
  assert.equal(await page.evaluate(() => window.linked), 0);
});

test('levels that were never shown are freed at once', async ({ page }) => {
  await visit(page, kHere);
  const waiting = await page.evaluate(
    ([one, other]) => {
      const { store, stage } = window.obby;
      for (let i = 0; i < 5; i++) store.set({ query: i % 2 ? other : one });
      return stage.leaving.waiting.length;
    },
    [kElsewhere, kHere],
  );
  assert.equal(waiting, 9, 'the views of one level and one query, which were drawn');
  await frames(page, 3);
  assert.equal(await page.evaluate(() => window.obby.stage.leaving.waiting.length), 0);
});

test('the selected query is visible in a long list', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 400 });
  for (const query of [kCopiedMesh, kHere]) {
    await visit(page, query);
    const [row, list] = await page.evaluate(() =>
      ['.query[aria-selected=true]', '.queries'].map((name) => {
        const { top, bottom } = document.querySelector(name).getBoundingClientRect();
        return { top, bottom };
      }),
    );
    assert.ok(list.bottom - list.top < 160, 'a list of which a part is seen');
    assert.ok(row.top >= list.top - 1 && row.bottom <= list.bottom + 1, `query ${query}`);
  }
  await page.setViewportSize({ width: 1280, height: 800 });
});

test('every level uses the selected colours', async ({ page }) => {
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
  await visit(page, kElsewhere);
  assert.deepEqual(await colourOf(), own);
  await page.keyboard.press('c');
  await visit(page, kHere);
  assert.deepEqual(await colourOf(), byRole);
});

test('the wheel zooms in from far away', async ({ page }) => {
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
  await page.evaluate(() => window.obby.views.query(true));
});

test('a query without its level shows no old picture', async ({ page }) => {
  const seen = async () => ({
    colours: (await colours(page, false)).different,
    words: await page.evaluate(() =>
      ['labels', 'hud'].map((id) => !document.getElementById(id).hidden),
    ),
  });
  await visit(page, kHere);
  const before = await seen();
  assert.ok(before.colours > 40);
  assert.deepEqual(before.words, [true, true]);
  await visit(page, kLost);
  assert.deepEqual(await seen(), { colours: 1, words: [false, false] });
  // Removed lines are freed, even though this query draws nothing.
  await page.evaluate(() => {
    const { stage, report } = window.obby;
    for (const path of report.queries[0].paths) stage.pathView.hover(path);
    window.obby.dirty = true;
  });
  await frames(page, 3);
  assert.equal(await page.evaluate(() => window.obby.stage.pathView.left.length), 0);
  await visit(page, kHere);
  assert.ok((await seen()).colours > 40);
});

test('parts missing from the level are reported', async ({
  page,
}) => {
  await visit(page, kOfOthers);
  assert.match(await page.locator('.findings').innerText(), /part 9999 to part 9998/);
  assert.equal(await page.locator('.findings button:not(.trajectory)').count(), 0);
  await page.locator('.ends .killer').first().click();
  const { part, killer } = await state(page);
  assert.deepEqual([part, killer], [-1, 9999]);
});

test('drawn and labelled regions have a limit', async ({
  page,
}) => {
  await visit(page, kThousands);
  const { boxes, labels, looks } = await page.evaluate(() => {
    const { group, labels: all } = window.obby.stage.regionView;
    const materials = new Set();
    group.traverse(({ material }) => material && materials.add(material));
    return { boxes: group.children.length, labels: all.length, looks: materials.size };
  });
  assert.deepEqual([boxes, labels], [2 + 500, 2 + 40], 'start and goal, and those to avoid');
  assert.equal(looks, 1 + 2 + 2, 'the ring of the start, two of the goal, two of all to avoid');
  const asked = await page.locator('.limits').innerText();
  assert.match(asked, /3000 regions to avoid \(500 are drawn\)/);
});

test('degenerate hulls do not block other parts', async ({ page }) => {
  await visit(page, kOddHulls);
  assert.ok((await colours(page, false)).different > 40);
  const drawn = (part) => window.obby.stage.levelView.slots[part].length;
  assert.equal(await page.evaluate(drawn, level.hulls[0].part), 4);
});

test('parts of one mesh are drawn together', async ({ page }) => {
  await visit(page, kCopiedMesh);
  const { part } = level.hulls[0];
  const meshes = await page.evaluate(
    (i) =>
      window.obby.stage.levelView.group.children
        .filter((mesh) => mesh.userData.parts.includes(i))
        .map((mesh) => mesh.userData.parts),
    part,
  );
  assert.deepEqual(meshes, [[0, part]]);
});

// The page is hidden if, for example, it is in a frame that opens later.
test('framing on a hidden page takes effect later', async ({ page }) => {
  await visit(page, kHere);
  const show = (display) =>
    page.evaluate((how) => {
      document.getElementById('stage').style.display = how;
    }, display);
  await show('none');
  await frames(page, 2);
  await page.evaluate(() => window.obby.views.query(true));
  await show('');
  await frames(page, 3);
  const eye = await page.evaluate(() => window.obby.stage.rig.camera.position.toArray());
  assert.ok(eye.every(Number.isFinite), `the camera is at ${eye}`);
  assert.ok((await colours(page, false)).different > 40);
});

test('the page raised no error', async ({ trouble }) => assert.deepEqual(trouble, []));

test('a picture that the GPU lost is drawn again', async ({ page }) => {
  await visit(page, kHere);
  assert.ok((await colours(page, false)).different > 40);
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
});

test('answers without their level are reported', async ({
  browser,
}) => {
  const alone = { ...without, level: -1, trajectories: [] };
  const bare = options.sample({ ...report, levels: [], queries: [alone] });
  const { page, trouble } = await openReport(browser, bare);
  assert.match(await page.locator('.findings').innerText(), /solvable without Lava/);
  await page.locator('.ends .killer').first().click();
  await page.locator('#view').click({ position: { x: 400, y: 300 } });
  for (const key of ['b', 'c', 'f', 't', '9']) await page.keyboard.press(key);
  assert.equal((await state(page)).drawing, false, 'no trajectory could pass a box');
  // The drawing of a box may have begun at another query.
  await page.evaluate(() => window.obby.store.set({ drawing: true }));
  await page.locator('#view').click({ position: { x: 400, y: 300 } });
  await frames(page, 3);
  assert.equal((await state(page)).part, -1);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

// In concatenated streams an answer may precede all levels.
test('a first query without a level blocks no others', async ({
  browser,
}) => {
  const nowhere = { start: null, startPosition: null, goal: null };
  const first = { ...without, ...nowhere, id: 'first', level: -1, trajectories: [] };
  const mixed = options.sample({ ...report, queries: [first, course] });
  const { page, trouble } = await openReport(browser, mixed);
  assert.equal((await colours(page, false)).different, 1);
  await page.evaluate(() => window.obby.store.set({ query: 1 }));
  await frames(page, 3);
  const eye = await page.evaluate(() => window.obby.stage.rig.camera.position.toArray());
  assert.ok(eye.every(Number.isFinite), `the camera flies there from ${eye}`);
  await arrive(page);
  assert.ok((await colours(page, false)).different > 40);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

await run(file);
