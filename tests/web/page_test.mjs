// Tests the page as a reader uses it: opened from a file, clicked, played, scrubbed.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { arrive, colours, frames, openReport, state } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
// The last two queries have the first one's id.
const again = { ...report.queries[2], id: report.queries[0].id };
const sample = options.sample({ ...report, queries: [...report.queries, again, again] });

test('opens without errors, warnings or requests, and shows a picture', async ({
  page,
  trouble,
  requests,
}) => {
  const seen = await colours(page);
  assert.ok(seen.different > 40, `only ${seen.different} colours`);
  assert.ok(seen.share < 0.97, `${seen.share} of the view is one colour`);
  await options.picture(page, 'page');
  assert.deepEqual(trouble, []);
  assert.equal(requests.length, 1, requests.join());
});

test('lists queries with their verdicts and names as plain text', async ({ page }) => {
  assert.equal(await page.locator('.query').count(), 6);
  assert.match(
    await page.locator('#side').innerText(),
    /whole course[\s\S]*Unreachable[\s\S]*Unknown/,
  );
  assert.equal(await page.locator('.verdict').innerText(), 'Solved');
  await page.evaluate(() => window.obby.store.set({ part: 14 }));
  assert.match(await page.locator('.inspector').innerText(), /Glass <\/script><b>/);
});

test('a part shows its material', async ({ page }) => {
  const of = (part) =>
    page.evaluate((chosen) => {
      const { store, stage } = window.obby;
      store.set({ part: chosen });
      const [{ mesh, at }] = stage.levelView.slots[chosen];
      return mesh.geometry.attributes.aGrain.getX(at);
    }, part);
  const inspector = page.locator('.inspector');
  assert.equal(await of(0), 0);
  assert.doesNotMatch(await inspector.innerText(), /Material/);
  assert.ok((await of(1)) > 0);
  assert.match(await inspector.innerText(), /Material\s+Wood Planks/);
});

test('hovering a part shows its name, role and reason', async ({ page }) => {
  const at = await page.evaluate(() => {
    const { picker } = window.obby.pointer;
    const view = document.getElementById('view').getBoundingClientRect();
    const level = window.obby.level();
    // Finds a point of the picture that shows a part with a reason, and no line.
    for (let y = 0.2; y < 0.8; y += 0.01)
      for (let x = 0.1; x < 0.7; x += 0.01) {
        const [px, py] = [x * view.width, y * view.height];
        const part = picker.part([px, py]);
        if (part < 0 || !level.notes[part]?.length) continue;
        if (!picker.path(window.obby.store.state, [px, py]))
          return { x: view.left + px, y: view.top + py, name: level.names[part].split('/').pop() };
      }
    return null;
  });
  assert.ok(at, 'there is such a part');
  await page.mouse.move(at.x - 1, at.y);
  await page.mouse.move(at.x, at.y);
  await page.locator('#tip strong', { hasText: at.name }).waitFor();
  assert.ok((await page.locator('#tip span').count()) >= 2, 'role and reason');
});

test('the pointer label stays in the window', async ({ page }) => {
  const [right, bottom] = await page.evaluate(() => {
    const { pointer } = window.obby;
    const far = { clientX: innerWidth - 3, clientY: innerHeight - 3 };
    pointer.tell(far, 'A part of a long name', ['its role', 'and the reason for it']);
    const box = pointer.tip.getBoundingClientRect();
    pointer.tip.hidden = true;
    return [innerWidth - box.right, innerHeight - box.bottom];
  });
  assert.ok(right > -0.5 && bottom > -0.5, `${right} and ${bottom} pixels are left`);
});

test('a click in the list selects a trajectory', async ({ page }) => {
  await page.locator('.path').nth(4).click();
  assert.equal((await state(page)).path, 4);
  assert.equal(await page.locator('.path[aria-selected=true]').count(), 1);
});

test('a click on a line in the view selects its trajectory', async ({ page }) => {
  await page.evaluate(() => window.obby.store.set({ path: -1 }));
  await frames(page, 3);
  const at = await page.evaluate(() => {
    const { stage } = window.obby;
    const path = window.obby.query().paths[0];
    const point = stage.rig.camera.position.clone().fromArray(path.points, 3 * 440);
    point.y += 0.35;
    point.project(stage.rig.camera);
    const box = document.getElementById('view').getBoundingClientRect();
    return {
      x: box.left + ((point.x + 1) / 2) * box.width,
      y: box.top + ((1 - point.y) / 2) * box.height,
    };
  });
  await page.mouse.move(at.x, at.y);
  await page.locator('#tip').waitFor();
  await page.mouse.click(at.x, at.y);
  await frames(page);
  const { path, tick } = await state(page);
  assert.equal(path, 0);
  assert.ok(Math.abs(tick - 440) < 25, `tick ${tick}`);
});

test('play moves the clock, the player and the moving parts; space stops it', async ({ page }) => {
  await page.evaluate(() => window.obby.store.set({ tick: 0 }));
  const where = () =>
    page.evaluate(() => {
      const { stage } = window.obby;
      return [stage.avatar.group.position.z, stage.levelView.centreOf(4).x];
    });
  await frames(page, 3);
  const before = await where();
  await page.locator('.play').click();
  await page.waitForFunction(() => window.obby.store.state.tick > 20);
  await frames(page, 3);
  const after = await where();
  assert.ok(after[0] < before[0] - 0.5, `player ${before[0]} to ${after[0]}`);
  assert.ok(Math.abs(after[1] - before[1]) > 0.5, `lift ${before[1]} to ${after[1]}`);
  await page.locator('#view').focus();
  await page.keyboard.press('Space');
  assert.equal((await state(page)).playing, false);
});

test('scrubbing and stepping set the tick', async ({ page }) => {
  const box = await page.locator('.scrub').boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  const { tick, path } = await state(page);
  const ticks = await page.evaluate((i) => window.obby.query().paths[i].ticks, path);
  assert.ok(Math.abs(tick - ticks / 2) < ticks / 20, `tick ${tick} of ${ticks}`);
  await page.locator('#view').focus();
  await page.keyboard.press('ArrowRight');
  assert.equal((await state(page)).tick, Math.floor(tick) + 1);
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  assert.equal((await state(page)).tick, Math.floor(tick) - 1);
});

test('the hardest step is marked in the list, the picture and the profile', async ({ page }) => {
  await page.evaluate(() => window.obby.store.set({ path: 0 }));
  await frames(page);
  assert.equal(await page.locator('.path .band').allInnerTexts().then(String), 'Hard');
  assert.match(await page.locator('.path').first().getAttribute('title'), /Step 2 to .*Lift, hard/);
  assert.equal(await page.locator('.profile .hardest').count(), 1);
  const marked = () =>
    page.evaluate(() => window.obby.stage.pathView.hardest?.geometry.instanceCount);
  assert.equal(await marked(), 45);
  await page.evaluate(() => window.obby.store.set({ path: 1 }));
  await frames(page);
  assert.equal(await page.locator('.profile .hardest').count(), 0);
  assert.equal(await marked(), undefined);
  await page.evaluate(() => window.obby.store.set({ path: 0 }));
});

test('keys control toggles, help and colours', async ({ page }) => {
  const drawn = () => page.evaluate(() => window.obby.stage.shown.size);
  const all = await drawn();
  await page.keyboard.press('2');
  await frames(page);
  assert.ok((await drawn()) < all, 'without the failed attempts');
  await page.keyboard.press('2');
  await page.keyboard.press('c');
  assert.equal((await state(page)).colors, 'level');
  await page.keyboard.press('c');
  await page.keyboard.press('?');
  assert.equal(await page.locator('#help').isVisible(), true);
  await options.picture(page, 'help');
  await page.keyboard.press('?');
  assert.equal(await page.locator('#help').isVisible(), false);
});

test('flying and wheel move the camera', async ({ page }) => {
  const eye = () => page.evaluate(() => window.obby.stage.rig.camera.position.toArray());
  const before = await eye();
  await page.keyboard.down('w');
  await page.waitForFunction((from) => {
    const now = window.obby.stage.rig.camera.position.toArray();
    return Math.hypot(...now.map((v, i) => v - from[i])) > 1;
  }, before);
  await page.keyboard.up('w');
  const distance = () => page.evaluate(() => window.obby.stage.rig.goal.distance);
  const far = await distance();
  await page.mouse.move(700, 300);
  await page.mouse.wheel(0, -300);
  await page.waitForFunction((d) => window.obby.stage.rig.goal.distance < d, far);
});

test('selecting a query shows it and any mismatch', async ({ page }) => {
  await page.locator('.query').nth(3).click();
  await arrive(page);
  assert.equal(await page.locator('.verdict').innerText(), 'Replay mismatch');
  assert.equal(await page.locator('.path.mismatch').count(), 1);
  await options.picture(page, 'mismatch');
});

test('the address identifies query, trajectory and time', async ({
  page,
  browser,
}) => {
  for (const [index, nth] of [
    [5, '2'],
    [2, null],
  ]) {
    await page.evaluate((query) => window.obby.store.set({ query }), index);
    await page.evaluate(() => window.obby.store.set({ path: 3, tick: 66 }));
    await arrive(page);
    await page.waitForFunction((n) => {
      const values = new URLSearchParams(location.hash.slice(1));
      return values.get('t') === '1.100' && values.get('n') === n;
    }, nth);
    const fragment = await page.evaluate(() => location.hash);
    const opened = await openReport(browser, sample, { fragment });
    const { query, path, tick } = await state(opened.page);
    assert.deepEqual([query, path, Math.round(tick)], [index, 3, 66]);
    await opened.page.context().close();
  }
});

test('a link followed on an open page is shown', async ({ page }) => {
  await page.evaluate(() => {
    window.obby.store.set({ query: 0, path: 0, tick: 0 });
    location.hash = '#q=in eight seconds&traj=3&t=1.1&cam=1,2,3,0.5,-0.5,20';
  });
  await page.waitForFunction(() => window.obby.store.state.query === 2);
  const { path, tick } = await state(page);
  assert.deepEqual([path, Math.round(tick)], [3, 66]);
  assert.equal(await page.evaluate(() => window.obby.stage.rig.goal.distance), 20);
  await page.evaluate(() => {
    location.hash = '#traj=30'; // the first query has this trajectory, the shown one does not
  });
  await page.waitForFunction(() => window.obby.store.state.tick === 0);
  assert.equal((await state(page)).path, -1);
});

test('the page raised no error and made no request', async ({ trouble, requests }) => {
  assert.deepEqual(trouble, []);
  assert.equal(requests.length, 1, requests.join());
});

test('a level alone has nothing to sort or filter', async ({ browser }) => {
  const file = options.sample({ ...report, title: 'Level', queries: [] });
  const { page, trouble } = await openReport(browser, file);
  const words = await page.locator('#side').innerText();
  assert.match(words, /Level only/);
  assert.doesNotMatch(words, /Sort by|Filter|Not asked/);
  assert.ok((await colours(page)).different > 40);
  for (const key of ['9', '0', 'b', 'i', 'x', 'f', 'r', 'ArrowDown', ']', 'Space']) await page.keyboard.press(key);
  await frames(page, 3);
  assert.equal((await state(page)).drawing, false, 'a box could not be taken away again');
  assert.deepEqual(trouble, []);
  await page.context().close();
});

test('a page written by obby-view opens', async ({ browser }) => {
  const stream = join(options.out, 'level.jsonl');
  const file = join(options.out, 'level.html');
  const parts = Array.from({ length: 2000 }, (_, i) => ({
    name: `Part ${i} </script>`,
    position: [(i % 50) * 6, (i * 7) % 13, Math.floor(i / 50) * 6],
    size: [4, 1, 4],
    ...(i % 50 === 1 ? { kill: {} } : {}),
    ...(i % 100 === 2 ? { motion: { spin: { speed: 2 } } } : {}),
  }));
  const records = [
    {
      type: 'level',
      name: 'Two thousand',
      spawns: [{ name: 'start', position: [0, 0.5, 0] }],
      parts,
    },
    { type: 'query', id: 'far', goal: { position: [30, 9, 0], size: [8, 8, 8] } },
  ];
  writeFileSync(stream, `${records.map((record) => JSON.stringify(record)).join('\n')}\n`);
  execFileSync(options.viewer, [stream, '-o', file], { stdio: 'inherit' });
  const { page, trouble, requests } = await openReport(browser, file);
  assert.ok((await colours(page)).different > 20);
  await options.picture(page, 'level');
  assert.deepEqual(trouble, []);
  assert.equal(requests.length, 1);
});

await run(sample);
