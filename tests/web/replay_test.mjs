// The page replays what the simulator did. The player in the picture must be at the positions of
// `obby-solve --paths`, which another program computes.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Path } from '../../web/src/path.js';
import { arrive, openReport } from './browser.mjs';
import { harness } from './harness.mjs';

const kMaxStuds = 1e-3; // max difference on each axis
const { options, test, run } = harness();

// Maps a level name to the solver's options.
const kSolved = Object.entries({
  'several-routes': ['--query', 'any', '--solutions', '3'],
  'conveyor-and-pad': [],
  carousel: [],
});
const kDoor = 'button-door';

// Returns the trajectories of a level with their points, and the file of their stream.
function solved([level, words]) {
  const stream = join(options.out, `replay-${level}.jsonl`);
  const input = join(options.levels, `${level}.jsonl`);
  const asked = ['--paths=1', '--max-steps', '3000000', ...words];
  execFileSync(options.solver, [...asked, input, '-o', stream], { stdio: 'inherit' });
  const records = readFileSync(stream, 'utf8')
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
  return { level, stream, paths: records.filter((record) => record.type === 'trajectory') };
}

// Writes one page with all of them and a level without answers. Returns its file.
function pageOf(answers) {
  const file = join(options.out, 'replay.html');
  const streams = answers.map(({ stream }) => stream);
  const door = join(options.levels, `${kDoor}.jsonl`);
  execFileSync(options.viewer, [...streams, door, '-o', file], { stdio: 'inherit' });
  return file;
}

const answers = kSolved.map(solved);

// Shows a query of a level. Queries of different levels may have the same id.
const open = (page, level, query) =>
  page.evaluate(
    ([name, id]) => {
      const { report, store } = window.obby;
      const isIt = (each) => each.id === id && report.levels[each.level].name === name;
      store.set({ query: report.queries.findIndex(isIt) });
    },
    [level, query],
  );

// Returns the max distance of the drawn player from the recorded points on any axis, the number
// of points, the trajectory's ticks, and whether the jumps agree.
async function compare(page, level, record) {
  const { query, index = 0, path } = record;
  await open(page, level, query);
  const kind = record.outcome === 'goal' ? 'solution' : 'attempt';
  const asked = { index, kind, step: path.step, points: path.points, jumps: path.jumpTicks };
  return page.evaluate(({ index: which, kind: sort, step, points, jumps }) => {
    const { obby } = window;
    const shown = obby.query().paths.find((each) => each.kind === sort && each.index === which);
    let max = 0;
    points.forEach((point, i) => {
      obby.stage.showTick(shown, Math.min(i * step, shown.ticks));
      const at = obby.stage.avatar.group.position.toArray();
      for (let k = 0; k < 3; k++) max = Math.max(max, Math.abs(at[k] - point[k]));
    });
    const sameJumps = JSON.stringify(shown.jumpTicks) === JSON.stringify(jumps ?? []);
    return { max, count: points.length, ticks: shown.ticks, sameJumps };
  }, asked);
}

for (const { level, paths } of answers) {
  test(`${level}: the drawn player matches the simulator`, async ({ page }) => {
    assert.ok(paths.length > 0, 'nothing was solved');
    let [worst, total] = [0, 0];
    for (const path of paths) {
      const { max, count, ticks, sameJumps } = await compare(page, level, path);
      assert.ok(count > ticks / path.path.step, `${count} points for ${ticks} ticks`);
      assert.ok(max <= kMaxStuds, `${max} studs`);
      assert.ok(sameJumps, 'jumps differ');
      worst = Math.max(worst, max);
      total += count;
    }
    assert.ok(paths.some((path) => path.outcome === 'goal'));
    console.log(
      `     ${paths.length} trajectories, ${total} points, at most ${worst.toExponential(1)} studs apart`,
    );
  });
}

test('a bridge that a button builds is absent before', async ({ page }) => {
  await open(page, kDoor, 'whole');
  await arrive(page);
  const seen = await page.evaluate(() => {
    const { levelView } = window.obby.stage;
    const alphaOf = (part) => {
      const [{ mesh, at }] = levelView.slots[part];
      return mesh.geometry.attributes.aAlpha.getX(at);
    };
    return levelView.level.vanish.map(({ part, inverted }) => [Boolean(inverted), alphaOf(part)]);
  });
  assert.ok(seen.some(([inverted]) => inverted) && seen.some(([inverted]) => !inverted));
  for (const [inverted, alpha] of seen) assert.equal(alpha < 0.2, inverted, seen.join(' '));
});

test('the page raised no error', async ({ trouble }) => assert.deepEqual(trouble, []));

// Returns a path as obby-view thins even motion: every eighth tick, and the last.
function thinned() {
  const encode = (array) => Buffer.from(array.buffer).toString('base64');
  const ticks = [0, 8, 10];
  return new Path({
    stride: 8,
    ticks: 10,
    position: encode(Float32Array.from(ticks.flatMap((tick) => [3 * tick, tick, 4 * tick]))),
    yaw: encode(Uint16Array.from(ticks, (tick) => 1000 * tick)),
    state: encode(Uint8Array.from([0, 1, 2])),
    runs: '',
  });
}

test('a thinned trajectory continues evenly to its end', () => {
  const path = thinned();
  const near = (is, wanted, what) => assert.ok(Math.abs(is - wanted) < 1e-3, `${what}: ${is}`);
  for (let tick = 0; tick <= 10; tick += 0.5) {
    const { x, y, z, yaw, state, perTick } = path.poseAt(tick);
    [x, y, z].forEach((value, k) => near(value, [3, 1, 4][k] * tick, `axis ${k} at ${tick}`));
    near((yaw / (2 * Math.PI)) * 65536, 1000 * tick, `yaw at ${tick}`);
    near(path.travelled(tick), 5 * tick, `travelled at ${tick}`);
    if (tick > 0) perTick.forEach((value, k) => near(value, [3, 1, 4][k], `speed at ${tick}`));
    assert.equal(state, tick < 8 ? 0 : tick < 10 ? 1 : 2);
  }
  const { x, y, z } = path.poseAt(10);
  assert.deepEqual([x, y, z], path.end());
  assert.deepEqual(
    [0, 1, 2].map((sample) => path.tickOf(sample)),
    [0, 8, 10],
  );
});

test('base64 is decoded natively and only as needed', () => {
  const own = Uint8Array.fromBase64;
  let read = 0;
  try {
    Uint8Array.fromBase64 = (text) => {
      read += 1;
      return Uint8Array.from(Buffer.from(text, 'base64'));
    };
    const path = thinned();
    assert.equal(read, 1, 'the points');
    assert.equal('position' in path, false, 'their text is not kept');
    const { points, yaw, state } = path;
    assert.deepEqual([read, path.yaw === yaw], [3, true]);
    Uint8Array.fromBase64 = undefined;
    const slow = thinned();
    assert.deepEqual([slow.points, slow.yaw, slow.state], [points, yaw, state]);
    assert.equal(read, 3);
  } finally {
    Uint8Array.fromBase64 = own;
  }
});

// Returns the max difference between the positions of parts in the picture and in a recording of
// the same manoeuvre. Each of the recording's frames is a tick.
async function compareParts(page, recording) {
  return page.evaluate(({ name, parts, frames }) => {
    const { obby } = window;
    obby.store.set({ query: obby.report.queries.findIndex((each) => each.id === name) });
    const [shown] = obby.query().paths;
    const { levelView } = obby.stage;
    const Matrix = levelView.group.matrix.constructor;
    let [max, moved] = [0, 0];
    const begin = parts.map(() => null);
    frames.forEach((frame, tick) => {
      if (tick > shown.ticks) return;
      obby.stage.showTick(shown, tick);
      parts.forEach((part, k) => {
        const { mesh, at } = levelView.slots[part][0];
        const matrix = new Matrix();
        mesh.getMatrixAt(at, matrix);
        const is = matrix.elements.slice(12, 15);
        const truth = frame.poses[k].position;
        begin[k] ??= truth;
        is.forEach((value, axis) => {
          max = Math.max(max, Math.abs(value - truth[axis]));
          if (levelView.bodies.has(part))
            moved = Math.max(moved, Math.abs(truth[axis] - begin[k][axis]));
        });
      });
    });
    return { max, moved, count: frames.length, bodies: shown.bodies.length };
  }, recording);
}

// Returns the parts that the pointer hits at the centre of a part, before and after the trajectory
// has moved it.
async function pickedWhereItIs(page, part) {
  return page.evaluate((which) => {
    const { obby } = window;
    const { stage } = obby;
    const [shown] = obby.query().paths;
    return [0, shown.ticks].map((tick) => {
      stage.showTick(shown, tick);
      const at = stage.levelView.centreOf(which);
      stage.rig.frameBox(new stage.bounds.constructor(at, at).expandByScalar(6), { yaw: 0.5, pitch: -1.2 }, true);
      stage.rig.camera.updateMatrixWorld();
      const seen = at.project(stage.rig.camera);
      const x = ((seen.x + 1) / 2) * stage.width;
      return obby.pointer.picker.part([x, ((1 - seen.y) / 2) * stage.height]);
    });
  }, part);
}

test('a pushed box matches a recording of the simulator', async ({
  browser,
}) => {
  const course = join(options.levels, 'calibration', 'course.jsonl');
  const file = join(options.out, 'replay-course.html');
  execFileSync(options.viewer, [course, '-o', file], { stdio: 'inherit' });
  const recording = execFileSync(options.calibrator, ['--rehearse', '-q'], {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
  })
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line))
    .find((record) => record.type === 'recording' && record.name === 'push the box');
  const { page, trouble } = await openReport(browser, file);
  const parts = recording.parts.map((path) => Number(path.replace('part:', '')));
  const found = await compareParts(page, { ...recording, parts });
  assert.ok(found.bodies > 0, 'nothing is pushed');
  assert.ok(found.moved > 4, `pushed ${found.moved} studs`);
  assert.ok(found.max <= kMaxStuds, `${found.max} studs`);
  console.log(`     ${found.count} frames, at most ${found.max.toExponential(1)} studs apart`);
  const box = await page.evaluate(() => window.obby.report.levels[0].bodies[0]);
  assert.deepEqual(await pickedWhereItIs(page, box), [box, box]);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

await run(pageOf(answers));
