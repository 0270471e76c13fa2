// Formats the Luau files with StyLua. `node format.mjs` rewrites them; with --check it fails if a
// file would change.
import { spawnSync } from 'node:child_process';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';

const stylua = fileURLToPath(import.meta.resolve('@johnnymorganz/stylua-bin/run.js'));
const options = { cwd: dirname(fileURLToPath(import.meta.url)), stdio: 'inherit' };
const command = [stylua, ...process.argv.slice(2), 'src', 'tests'];
process.exit(spawnSync(process.execPath, command, options).status ?? 1);
