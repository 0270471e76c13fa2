// The plugin's Luau against the built bridge and solver, in real time: node live.mjs BIN LEVELS NAME...
import { start } from './harness/luau.mjs';
import { Native } from './harness/native.mjs';

const [bin, levels, ...names] = process.argv.slice(2);
const LONGEST = 90; // seconds for one test
const version = 'return table.freeze({ version = "0.0.0-test", protocol = 1 })';

async function play(luau, native, index) {
  const from = performance.now();
  const seconds = () => (performance.now() - from) / 1000;
  await luau.call('start', index);
  for (;;) {
    while (native.queue.length > 0) await luau.call('deliver', ...native.queue.shift());
    const next = await luau.call('step', seconds());
    if (await luau.call('done')) return luau.call('failure');
    if (seconds() > LONGEST) return `not done after ${LONGEST} s`;
    await native.pause(next < 0 ? 1 : Math.min(next, 1));
  }
}

let failed = 0;
let ran = 0;
for (const name of names) {
  const native = new Native(bin, levels);
  try {
    const luau = await start(native.table(), { 'version.luau': version });
    const titles = (await luau.call('open', `live/${name}_test.luau`)).split('\n').filter(Boolean);
    for (const [index, title] of titles.entries()) {
      const problem = await play(luau, native, index + 1);
      ran += 1;
      if (problem) failed += 1;
      console.log(`${problem ? 'FAILED' : 'ok    '} live ${name}: ${title}`);
      if (problem) console.log(`    ${problem.replaceAll('\n', '\n    ')}`);
    }
  } finally {
    await native.close();
  }
}
console.log(`${ran - failed} of ${ran} tests passed`);
process.exit(failed === 0 && ran > 0 ? 0 : 1);
