// Runs test files in simulated time. `node run.mjs NAME...` runs each NAME_test.luau in its own
// process, since a VM is limited to 17 MB. Exits 1 if a test fails.
import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { start } from './harness/luau.mjs';
import { report } from './harness/report.mjs';

async function runFile(name) {
  const luau = await start({});
  return report(luau, name, `${name}_test.luau`, async (index) => {
    await luau.call('start', index);
    return luau.call('simulate');
  });
}

const names = process.argv.slice(2);
const self = fileURLToPath(import.meta.url);
const runApart = (name) =>
  spawnSync(process.execPath, [self, name], { stdio: 'inherit' }).status === 0;
const passed = names.length === 1 ? await runFile(names[0]) : names.map(runApart).every(Boolean);
process.exit(passed && names.length > 0 ? 0 : 1);
