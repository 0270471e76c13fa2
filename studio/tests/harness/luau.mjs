// Runs Luau in this process. Plugin sources and tests are compiled from disk, and call Node
// through `native`. Only one call into Luau runs at a time; concurrency uses Luau's coroutines.
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { LuauState } from 'luau-web';
import * as classes from './classes.mjs';

export const tests = dirname(dirname(fileURLToPath(import.meta.url)));
export const src = join(dirname(tests), 'src');
const root = dirname(dirname(tests));
const api = join(root, 'lib', 'engine', 'api'); // the twin of the engine
const course = join(root, 'levels', 'calibration', 'course.jsonl');
// The tests' version of the modules that the build generates.
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
  // Compiles a function that creates the chunk, so that a file is compiled only once. Compiled code
  // is never freed, and the VM's memory is small.
  native.compile = (path) => {
    const [, top, name] = /^(src\/|api\/)?(.*)$/.exec(path);
    const made = top === 'src/' && built[name];
    const folder = { 'src/': src, 'api/': api }[top] ?? tests;
    const text = made || readFileSync(join(folder, name), 'utf8');
    return state.loadstring(`return function(...) ${text}\nend`, path, true);
  };
  Object.assign(native, classes);
  native.sources = [...luauFiles(src).filter((name) => name !== entry), ...Object.keys(built)]
    .map((name) => name.slice(0, -'.luau'.length))
    .join('\n');
  const [make] = await native.compile('harness/boot.luau')();
  const [boot] = await make(native);
  return { call: async (name, ...values) => (await boot.get(name)(...values))[0] };
}
