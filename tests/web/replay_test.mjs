// What the page replays is what the simulator did: the player in the picture stands where `obby-solve --paths` says,
// which another program computed.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { openReport } from './browser.mjs';
import { harness } from './harness.mjs';

const kMostStuds = 1e-3; // between the two, in each axis
const { options, test, run } = harness();

// Trajectories of a level with their points, and the page of the same stream.
function solved(level, words) {
  const stream = join(options.out, `replay-${level}.jsonl`);
  const page = join(options.out, `replay-${level}.html`);
  const input = join(options.levels, `${level}.jsonl`);
  execFileSync(options.solver, ['--paths=1', ...words, input, '-o', stream], { stdio: 'inherit' });
  execFileSync(options.viewer, [stream, '-o', page], { stdio: 'inherit' });
  const records = readFileSync(stream, 'utf8')
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
  return { page, paths: records.filter((record) => record.type === 'trajectory') };
}

// Largest difference between the player in the picture and the points, and how many were compared.
async function compare(page, record) {
  const { query, index = 0, path } = record;
  const kind = record.outcome === 'goal' ? 'solution' : 'attempt';
  const asked = { query, index, kind, step: path.step, points: path.points, jumps: path.jumpTicks };
  return page.evaluate(({ query: id, index: which, kind: sort, step, points, jumps }) => {
    const { obby } = window;
    obby.store.set({ query: obby.report.queries.findIndex((each) => each.id === id) });
    const shown = obby.query().paths.find((each) => each.kind === sort && each.index === which);
    let most = 0;
    points.forEach((point, i) => {
      obby.stage.showTick(shown, Math.min(i * step, shown.ticks));
      const at = obby.stage.avatar.group.position.toArray();
      for (let k = 0; k < 3; k++) most = Math.max(most, Math.abs(at[k] - point[k]));
    });
    const sameJumps = JSON.stringify(shown.jumpTicks) === JSON.stringify(jumps ?? []);
    return { most, count: points.length, ticks: shown.ticks, sameJumps };
  }, asked);
}

for (const [level, ...words] of [
  ['several-routes', '--query', 'any', '--solutions', '3'],
  ['conveyor-and-pad'],
  ['carousel'],
]) {
  test(`${level}: the player in the picture is where the simulator had them`, async ({
    browser,
  }) => {
    const { page: file, paths } = solved(level, ['--max-steps', '3000000', ...words]);
    assert.ok(paths.length > 0, 'nothing was solved');
    const { page, trouble } = await openReport(browser, file);
    let [worst, total] = [0, 0];
    for (const path of paths) {
      const { most, count, ticks, sameJumps } = await compare(page, path);
      assert.ok(count > ticks / path.path.step, `${count} points for ${ticks} ticks`);
      assert.ok(most <= kMostStuds, `${most} studs`);
      assert.ok(sameJumps, 'jumps differ');
      worst = Math.max(worst, most);
      total += count;
    }
    assert.ok(paths.some((path) => path.outcome === 'goal'));
    console.log(
      `     ${paths.length} ways, ${total} points, at most ${worst.toExponential(1)} studs apart`,
    );
    assert.deepEqual(trouble, []);
    await page.context().close();
  });
}

await run();
