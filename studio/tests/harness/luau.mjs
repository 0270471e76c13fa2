// Luau in this process: plugin sources and tests are compiled as they lie on disk, and what they
// ask of the outside goes through `native`. One call into Luau at a time: its own coroutines do
// the rest.
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { LuauState } from 'luau-web';

export const tests = dirname(dirname(fileURLToPath(import.meta.url)));
export const src = join(dirname(tests), 'src');
// The module that the build makes, as tests have it.
export const built = {
  'version.luau': 'return table.freeze({ version = "0.0.0-test", protocol = 1 })',
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
  native.compile = (path) => {
    const name = path.replace(/^src\//, '');
    const made = path.startsWith('src/') && built[name];
    const file = path.startsWith('src/') ? join(src, name) : join(tests, path);
    return state.loadstring(made || readFileSync(file, 'utf8'), path, true);
  };
  native.sources = [...luauFiles(src).filter((name) => name !== entry), ...Object.keys(built)]
    .map((name) => name.slice(0, -'.luau'.length))
    .join('\n');
  const [boot] = await native.compile('harness/boot.luau')(native);
  return { call: async (name, ...values) => (await boot.get(name)(...values))[0] };
}
