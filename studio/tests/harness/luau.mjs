// Luau in this process: plugin sources and tests are compiled as they lie on disk, and what they
// ask of the outside goes through `native`. One call into Luau at a time: its own coroutines do
// the rest.
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { LuauState } from 'luau-web';

export const tests = dirname(dirname(fileURLToPath(import.meta.url)));
export const src = join(dirname(tests), 'src');
const course = join(dirname(dirname(tests)), 'levels', 'calibration', 'course.jsonl');
// The modules that the build makes, as tests have them.
export const built = {
  'version.luau': 'return table.freeze({ version = "0.0.0-test", protocol = 1 })',
  'courseText.luau': `return table.freeze({ text = [==[${readFileSync(course, 'utf8')}]==] })`,
};
const entry = 'init.server.luau';

export function luauFiles(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((file) => file.isFile() && file.name.endsWith('.luau'))
    .map((file) => relative(folder, join(file.parentPath ?? file.path, file.name)))
    .sort();
}

export async function start(native) {
  const state = await LuauState.createAsync({});
  // A function that makes the chunk anew: what is compiled stays for good, and the room is small.
  native.compile = (path) => {
    const name = path.replace(/^src\//, '');
    const made = path.startsWith('src/') && built[name];
    const file = path.startsWith('src/') ? join(src, name) : join(tests, path);
    const text = made || readFileSync(file, 'utf8');
    return state.loadstring(`return function(...) ${text}\nend`, path, true);
  };
  native.sources = [...luauFiles(src).filter((name) => name !== entry), ...Object.keys(built)]
    .map((name) => name.slice(0, -'.luau'.length))
    .join('\n');
  const [make] = await native.compile('harness/boot.luau')();
  const [boot] = await make(native);
  return { call: async (name, ...values) => (await boot.get(name)(...values))[0] };
}
