// Compares the output of Luau programs in Luau's own VM with that of the emitted Lua 5.1:
// node oracle.mjs LUAU_RUN [FILE...]. Without files, it runs all of luau/. Exits with 1 if any
// output differs.
import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const self = fileURLToPath(import.meta.url);
const here = dirname(self);
const packages = join(here, '..', '..', 'studio', 'node_modules');
const { LuauState } = await import(pathToFileURL(join(packages, 'luau-web', 'src', 'index.js')));
const kBatch = 20;

// Collects the printed lines. The prefix must be a single line, so that errors state the
// program's own lines.
const before = `local lines = {} local function print(...)
  local values = { n = select("#", ...), ... }
  for i = 1, values.n do values[i] = tostring(values[i]) end
  lines[#lines + 1] = table.concat(values, " ") .. "\\n" end
  local ok, problem = pcall(function(...) `.replaceAll('\n', ' ');
const after = `\nend) return table.concat(lines), if ok then "" else tostring(problem)`;

async function run(state, file) {
  try {
    const program = state.loadstring(before + readFileSync(file, 'utf8') + after, 'script', true);
    const [printed, problem] = await program();
    return problem === '' ? printed : `${printed}error: ${problem}`;
  } catch (problem) {
    return `error: ${problem.message ?? problem}`;
  }
}

// Runs a few files in each process. A process has one VM, which never frees its 17 MB.
function inLuau(files) {
  if (files.length > kBatch) return [...inLuau(files.slice(0, kBatch)), ...inLuau(files.slice(kBatch))];
  const { stdout } = spawnSync(process.execPath, [self, '--luau', ...files], { encoding: 'utf8' });
  const answers = stdout.replaceAll('[string \\"script\\"]:', 'script:').split('\n');
  return files.map((_, i) => JSON.parse(answers[i] || '"error: the VM died"'));
}

function emitted(program, file) {
  const { stdout, stderr } = spawnSync(program, [file], { encoding: 'utf8' });
  return stderr === '' ? stdout : `${stdout}error: ${stderr}`;
}

const [program, ...chosen] = process.argv.slice(2);
if (program === '--luau') {
  const state = await LuauState.createAsync({});
  for (const file of chosen) console.log(JSON.stringify(await run(state, file)));
  process.exit(0);
}
const folder = join(here, 'luau');
const files = chosen.length > 0 ? chosen : readdirSync(folder).sort().map((f) => join(folder, f));
const answers = inLuau(files);
let different = 0;
for (const [i, file] of files.entries()) {
  const found = emitted(program, file);
  if (answers[i] === found && !found.includes('error:') && found !== '') continue;
  different += 1;
  console.log(`${file}\n--- Luau\n${answers[i]}\n--- emitted\n${found}`);
}
console.log(`${files.length} programs, ${different} of them different`);
process.exit(different > 0 || files.length === 0 ? 1 : 0);
