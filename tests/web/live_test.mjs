// obby-view --live: the page grows with the stream, keeps the reader's selection, and shows the
// state of the stream.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { frames, openReport, started, state } from './browser.mjs';
import { harness } from './harness.mjs';
import { openLive, recordsOf, Viewer, trajectoriesAre } from './live_driver.mjs';

const { options, test, run } = harness();
const set = (page, values) => page.evaluate((v) => window.obby.store.set(v), values);
const mark = (page) => page.locator('.live .name').innerText();

const kUnsolved = 'hops-without-jumps'; // a query of the level that uses up any time limit
const kTimeLimit = 120; // seconds until a search without visible growth fails the test

const stream = recordsOf(
  options.solver,
  ...['--query', 'any', '--solutions', '4', '--attempts', '40', '--max-steps', '300000'],
  join(options.levels, 'several-routes.jsonl'),
);
const of = (type) => stream.filter((record) => record.type === type);
const header = of('header')[0];
const level = of('level')[0];
const query = of('query').find(({ id }) => id === 'any');
const result = of('result')[0];
const trajectories = of('trajectory').filter((record) => record.query === 'any');
const solutions = trajectories.filter(({ outcome }) => outcome === 'goal');
const attempts = trajectories.filter(({ outcome }) => outcome !== 'goal');

const progress = (seconds, best, deaths) => ({
  type: 'progress',
  query: 'any',
  seconds,
  steps: String(seconds * 100000),
  cells: String(seconds * 50),
  closest: 20 - seconds,
  best,
  deaths,
});

// Returns all settings of the page that only its reader may change.
const kept = (page) =>
  page.evaluate(() => {
    const { app, store, stage, list } = { app: window.obby, ...window.obby };
    const { tick, playing, outcome, sort, boxes, isolate, query } = store.state;
    const { position, quaternion } = stage.rig.camera;
    return {
      ...{ tick, playing, outcome, sort, isolate, query, boxes: JSON.stringify(boxes) },
      chosen: app.path()?.serial,
      ghost: app.ghost()?.serial,
      camera: [...position.toArray(), ...quaternion.toArray()].map((v) => v.toFixed(3)).join(),
      scroll: list.rows.scrollTop,
      focus: document.activeElement.dataset.path,
    };
  });

test('there are enough trajectories to send', () => {
  assert.ok(solutions.length >= 3 && attempts.length >= 20, `${solutions.length} and more`);
});

test('counts grow until the stream ends, keeping the selection', async ({ browser }) => {
  const out = join(options.out, 'live-at-the-end.html');
  const viewer = new Viewer(options.viewer, ['-o', out]);
  const address = await viewer.address;
  const { page, trouble, requests, pieces } = await openLive(browser, address);
  await page.waitForFunction(() => document.querySelector('.live .name')?.textContent === 'Live');
  assert.match(await page.locator('.live').innerText(), /Waiting for the first level/);

  viewer.write(header, level, query);
  await started(page);
  await page.waitForFunction(() => window.obby.query());
  await page.evaluate(() => window.obby.store.set({ attempts: true }));
  viewer.write(progress(1, attempts[0], [attempts[1]]));
  await trajectoriesAre(page, 2);
  assert.match(await page.locator('.detail').innerText(), /Searching[\s\S]*Closest to goal\s+19.0 studs/i);
  await page.locator('.detail summary').click();
  assert.match(await page.locator('.detail').innerText(), /Simulated ticks\s+100 k/);
  viewer.write(progress(3, attempts[2], [attempts[3], attempts[1]]));
  await trajectoriesAre(page, 3);
  assert.match(await page.locator('.detail').innerText(), /Simulated ticks\s+300 k/);
  assert.match(await page.locator('.detail').innerText(), /Places explored\s+150/);
  await page.evaluate(() => {
    window.drawn = window.obby.stage.pathView;
  });
  viewer.write(progress(4, attempts[2], [attempts[3], attempts[1]]));
  await page.locator('.detail .numbers', { hasText: '400 k' }).waitFor();
  assert.ok(await page.evaluate(() => window.drawn === window.obby.stage.pathView), 'numbers only');
  await options.picture(page, 'live-searching');

  viewer.write(...attempts.slice(0, 10));
  // One of them is the closest attempt, shown while nothing is solved.
  await trajectoriesAre(page, 11);
  await page.locator('.path').nth(4).click();
  await set(page, { tick: 12.5, ghost: 2, outcome: attempts[0].outcome, sort: 'time' });
  await page.evaluate(() => window.obby.stage.rig.restore([5, 30, 40, 0.4, -0.6, 30]));
  await frames(page, 3);
  await page.evaluate(() => {
    window.obby.list.rows.scrollTop = 7;
    document.querySelector('.path:last-child').focus({ preventScroll: true });
  });
  const before = await kept(page);
  assert.ok(before.chosen > 0 && before.ghost > 0 && before.focus !== undefined);
  for (let i = 10; i < 20; i += 5) {
    viewer.write(...attempts.slice(i, i + 5));
    await trajectoriesAre(page, i + 6);
    assert.deepEqual(await kept(page), before, `after ${i + 5} attempts`);
  }
  // A superseded attempt stays selected until the page selects the newest solution.
  await set(page, { outcome: '', sort: 'found', ghost: -1 });
  await page.locator('.path', { hasText: 'Closest' }).click();
  const closest = (await kept(page)).chosen;
  await page.locator('.live label').click();
  await set(page, { playing: true, loop: true });
  viewer.write(result, solutions[0]);
  await page.waitForFunction(() => window.obby.path()?.kind === 'solution');
  assert.notEqual((await kept(page)).chosen, closest);
  assert.equal((await state(page)).playing, true);
  await page.locator('.live label').click();
  const chosen = (await kept(page)).chosen;
  viewer.write(...solutions.slice(1));
  await trajectoriesAre(page, 20 + solutions.length);
  assert.equal((await kept(page)).chosen, chosen);
  assert.equal(await page.locator('.detail .verdict').innerText(), 'Solved');
  await set(page, { playing: false }); // playback redraws every frame

  viewer.write({ type: 'end', records: String(viewer.records) });
  viewer.end();
  await page.waitForFunction(() => document.querySelector('.live .name').textContent === 'Ended');
  await frames(page);
  await options.picture(page, 'live-ended');

  // A page that opens late shows the same, and the page file does, too.
  const late = await openLive(browser, address);
  await started(late.page);
  const file = await openReport(browser, out);
  const list = (opened) =>
    opened.page.evaluate(() =>
      window.obby.report.queries.map(({ paths, trajectories, index, running, ...facts }) => [
        JSON.stringify(facts),
        paths.map(({ kind, ticks, outcome, part }) => `${kind} ${ticks} ${outcome} ${part}`).sort(),
      ]),
    );
  assert.deepEqual(await list({ page }), await list(file));
  assert.deepEqual(await list(late), await list(file));
  assert.equal(await mark(late.page), 'Ended');

  // The level was sent once, and no trajectory twice.
  const levels = pieces.filter((piece) => piece.levels.length);
  assert.equal(levels.length, 1);
  const serials = pieces.flatMap((piece) =>
    piece.queries.flatMap((each) => each.trajectories.map(({ serial }) => serial)),
  );
  assert.equal(new Set(serials).size, serials.length);
  const sent = pieces.reduce((sum, piece) => sum + piece.bytes, 0);
  const { pieces: whole } = late;
  assert.ok(sent < 1.5 * whole[0].bytes, `${sent} bytes in pieces, ${whole[0].bytes} at once`);

  const origin = new URL(address).origin;
  assert.deepEqual(
    [...requests, ...late.requests].filter(
      (url) => !url.startsWith(`${origin}/`) && url !== 'data:,',
    ),
    [],
  );
  assert.deepEqual([...trouble, ...late.trouble], []);
  for (const each of [page, late.page, file.page]) await each.context().close();
  assert.equal(await viewer.stop(), 130);
});

test('the first solution is shown at once and gives way to the improved one', async ({ browser }) => {
  const viewer = new Viewer(options.viewer);
  const { page, trouble } = await openLive(browser, await viewer.address);
  viewer.write(header, level, query, progress(1, attempts[0], []));
  await started(page);
  await trajectoriesAre(page, 1);
  assert.ok(['closest', undefined].includes(await page.evaluate(() => window.obby.path()?.kind)));
  viewer.write({ type: 'progress', query: 'any', seconds: 0.5, solution: solutions.at(-1) });
  await page.waitForFunction(() => window.obby.path()?.provisional);
  await frames(page, 2);
  assert.equal(await page.locator('.detail .verdict').innerText(), 'Solved, being improved');
  assert.match(await page.locator('.detail .numbers').first().innerText(), /Play time so far/i);
  assert.match(await page.locator('.path').first().innerText(), /first found/);
  assert.match(await page.locator('.head').innerText(), /1 of 1 query solved/);
  await options.picture(page, 'live-improving');
  await set(page, { tick: 10 });
  viewer.write(result, solutions[0]);
  await page.waitForFunction(() => window.obby.path() && !window.obby.path().provisional);
  await trajectoriesAre(page, 1);
  assert.equal((await state(page)).tick, 10, 'the clock stays');
  assert.equal(await page.locator('.detail .verdict').innerText(), 'Solved');

  // A cleared selection stays cleared.
  await set(page, { path: -1 });
  viewer.write(solutions[1]);
  await trajectoriesAre(page, 2);
  assert.equal((await state(page)).path, -1);
  assert.deepEqual(trouble, []);
  await page.context().close();
  await viewer.stop();
});

test('a stream that ends before the final answer keeps the first solution', async ({ browser }) => {
  const viewer = new Viewer(options.viewer);
  const { page } = await openLive(browser, await viewer.address);
  viewer.write(header, level, query);
  viewer.write({ type: 'progress', query: 'any', seconds: 0.5, solution: solutions[0] });
  await started(page);
  await trajectoriesAre(page, 1);
  viewer.end();
  await page.waitForFunction(() => document.querySelector('.live .name').textContent === 'Cut short');
  assert.equal(
    await page.locator('.detail .verdict').innerText(),
    'Solved, but the final answer is missing',
  );
  await page.context().close();
  await viewer.stop();
});

test('a page that loses the server catches up', async ({ browser }) => {
  const viewer = new Viewer(options.viewer);
  const { page } = await openLive(browser, await viewer.address);
  viewer.write(header, level, query, attempts[0]);
  await started(page);
  await trajectoriesAre(page, 1);
  const cdp = await page.context().newCDPSession(page);
  await cdp.send('Network.enable');
  await page.context().setOffline(true);
  // Going offline does not close an open connection, so the test closes it, as a broken network
  // would.
  await page.evaluate(() => window.obby.live.feed.events.close());
  await page.evaluate(() => window.obby.live.feed.events.onerror());
  await page.waitForFunction(() => /lost/.test(document.querySelector('.live .name').textContent));
  viewer.write(attempts[1], attempts[2]);
  await page.waitForTimeout(1500);
  assert.equal(await page.evaluate(() => window.obby.query().paths.length), 1);
  await page.context().setOffline(false);
  await trajectoriesAre(page, 3);
  await page.waitForFunction(() => document.querySelector('.live .name').textContent === 'Live');
  await page.context().close();
  await viewer.stop();
});

test('a truncated stream and an invalid record are reported', async ({ browser }) => {
  const viewer = new Viewer(options.viewer, ['--live-exit']);
  const { page, trouble } = await openLive(browser, await viewer.address);
  viewer.write(header, level, query, attempts[0], { type: 'trajectory', query: 5 });
  await started(page);
  const name = page.locator('.live .name');
  await name.filter({ hasText: 'Cut short' }).waitFor();
  assert.match(await page.locator('.note').innerText(), /stopped at an error: stdin:5: query/);
  assert.match(viewer.errors, /^obby-view: stdin:5: query/m);
  await trajectoriesAre(page, 1);
  assert.deepEqual(trouble, []);
  await page.context().close();
  viewer.end();
  assert.equal(await viewer.ended, 2); // the last page has closed
});

test('an empty stream is reported as empty', async ({ browser }) => {
  const viewer = new Viewer(options.viewer);
  const { page } = await openLive(browser, await viewer.address);
  viewer.end();
  await page.locator('.live p', { hasText: 'There is nothing to show' }).waitFor();
  await page.context().close();
  await viewer.stop();
});

test('a running search shows its growth', async ({ browser }) => {
  const input = join(options.levels, 'several-routes.jsonl');
  const solver = spawn(
    options.solver,
    ['--query', kUnsolved, '--time-limit', String(kTimeLimit), '--attempts', '30', input],
    { stdio: ['ignore', 'pipe', 'inherit'] },
  );
  const viewer = new Viewer(options.viewer, ['--query', kUnsolved]);
  solver.stdout.pipe(viewer.process.stdin);
  const { page, trouble } = await openLive(browser, await viewer.address);
  await started(page);
  const numbers = [];
  while (numbers.length < 4 && (await mark(page)) === 'Live') {
    const steps = await page.evaluate(() => Number(window.obby.query()?.progress?.steps ?? 0));
    if (steps > 0 && steps !== numbers.at(-1)) numbers.push(steps);
    await page.waitForTimeout(50);
  }
  assert.equal(numbers.length, 4, `steps: ${numbers.join(', ')}`);
  assert.deepEqual(
    numbers,
    [...numbers].sort((a, b) => a - b),
  );
  solver.kill('SIGINT'); // it still writes its findings and the end of the stream
  await page.waitForFunction(() => document.querySelector('.live .name').textContent === 'Ended');
  await frames(page);
  await options.picture(page, 'live-search');
  assert.deepEqual(trouble, []);
  await page.context().close();
  await viewer.stop();
});

await run();
