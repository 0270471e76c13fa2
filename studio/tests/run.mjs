// Runs test files in simulated time: node run.mjs NAME... runs NAME_test.luau. Exits 1 if a test fails.
import { start } from './harness/luau.mjs';

const version = 'return table.freeze({ version = "0.0.0-test", protocol = 1 })';
let failed = 0;
let ran = 0;

async function runFile(name) {
  const luau = await start({}, { 'version.luau': version });
  const titles = (await luau.call('open', `${name}_test.luau`)).split('\n').filter(Boolean);
  for (const [index, title] of titles.entries()) {
    await luau.call('start', index + 1);
    const problem = await luau.call('simulate');
    ran += 1;
    if (problem) failed += 1;
    console.log(`${problem ? 'FAILED' : 'ok    '} ${name}: ${title}`);
    if (problem) console.log(`    ${problem.replaceAll('\n', '\n    ')}`);
  }
}

for (const name of process.argv.slice(2)) await runFile(name);
console.log(`${ran - failed} of ${ran} tests passed`);
process.exit(failed === 0 && ran > 0 ? 0 : 1);
