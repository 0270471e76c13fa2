// Runs a live test of the plugin's Luau with the built bridge and solver, in real time:
// node live.mjs BIN LEVELS NAME.
import { start } from './harness/luau.mjs';
import { Native } from './harness/native.mjs';
import { report } from './harness/report.mjs';

const [bin, levels, name] = process.argv.slice(2);
const LONGEST = 600; // max seconds of one test, enough for a slow machine with other work
async function play(luau, native, index) {
  const from = performance.now();
  const seconds = () => (performance.now() - from) / 1000;
  await luau.call('start', index);
  for (;;) {
    while (native.queue.length > 0) await luau.call('deliver', ...native.queue.shift());
    const next = await luau.call('step', seconds());
    if (await luau.call('done')) return luau.call('failure');
    const late = `not done after ${LONGEST} s`;
    if (seconds() > LONGEST) return [late, await luau.call('failure')].filter(Boolean).join('\n');
    await native.pause(next < 0 ? 1 : Math.min(next, 1));
  }
}

const native = new Native(bin, levels);
let passed = false;
try {
  const luau = await start(native.table());
  const path = `live/${name}_test.luau`;
  passed = await report(luau, `live ${name}`, path, (index) => play(luau, native, index));
} finally {
  await native.close();
}
process.exit(passed ? 0 : 1);
