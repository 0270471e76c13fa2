// The plugin's types, as far as they can be checked without a Luau type checker, which no package
// has: types of other modules exist, constructors give every field that must be there, and
// whatever is asked of `self` and of parameters whose type is the plugin's own is a member of it.
// node types_test.mjs; exits 1 on a mismatch.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { built, luauFiles, src } from './harness/luau.mjs';

// Splits at commas that are in no bracket; "->" closes none.
function atCommas(text) {
  const pieces = [''];
  let depth = 0;
  for (const [token] of text.matchAll(/->|[\s\S]/g)) {
    if ('({<['.includes(token)) depth += 1;
    if (')}>]'.includes(token)) depth -= 1;
    if (token === ',' && depth === 0) pieces.push('');
    else pieces[pieces.length - 1] += token;
  }
  return pieces.map((piece) => piece.trim()).filter(Boolean);
}

// Name -> the rest, of "name: rest" or "name = rest"; nothing of a list or a map.
function entriesOf(text) {
  const entries = new Map();
  for (const piece of atCommas(text)) {
    const [, name, rest] = /^(\w+)\s*[:=]\s*([\s\S]*)$/.exec(piece) ?? [];
    if (name) entries.set(name, rest);
  }
  return entries;
}

// What stands between the brace at `open` and its own.
function braced(text, open) {
  let depth = 0;
  for (let i = open; i < text.length; i++) {
    if (text[i] === '{') depth += 1;
    if (text[i] === '}' && --depth === 0) return text.slice(open + 1, i);
  }
  throw new Error(`a brace is never closed: ${text.slice(open, open + 40)}`);
}

// requires: alias -> module; types: name -> {fields} | {of: another type's text}.
function readModule(file) {
  const text = readFileSync(join(src, file), 'utf8').replace(/--\[\[[\s\S]*?\]\]|--.*$/gm, '');
  const requires = new Map();
  for (const [, alias, path] of text.matchAll(/^local (\w+) = require\(script\.(\S+)\)$/gm)) {
    // A script's Parent is the folder that its file is in; the entry is the root folder itself.
    const names = path.split('.');
    let folder = file === 'init.server.luau' ? '' : file;
    for (; names[0] === 'Parent'; names.shift()) folder = dirname(folder);
    requires.set(alias, `${join(folder, ...names)}.luau`);
  }
  const types = new Map();
  const exported = new Set();
  for (const found of text.matchAll(/^(export )?type (\w+)(?:<\w+>)? = /gm)) {
    const [, isExported, name] = found;
    if (isExported) exported.add(name);
    const at = found.index + found[0].length;
    const rest = text.slice(at);
    const [, data, table] = /^typeof\(setmetatable\(\{\} :: (\w+), (\w+)\)\)/.exec(rest) ?? [];
    if (table) types.set(name, { data, table });
    else if (rest[0] === '{') types.set(name, { fields: entriesOf(braced(text, at)) });
    else types.set(name, { of: rest.split('\n')[0] });
  }
  return { file, text, requires, types, exported };
}

const modules = new Map(luauFiles(src).map((file) => [file, readModule(file)]));
let [checked, problems] = [0, 0];
function check(ok, module, what) {
  checked += 1;
  if (ok) return;
  problems += 1;
  console.log(`${module.file}: ${what}`);
}

// The plugin's own type that a text names, and its members; null: it is another's, or no name.
function typeNamed(module, text) {
  const [, alias, name] = /^(?:(\w+)\.)?(\w+)(?:<.*>)?\??$/.exec(text?.trim() ?? '') ?? [];
  if (!name) return null;
  const home = alias ? modules.get(module.requires.get(alias)) : module;
  const type = home?.types.get(name);
  if (!type) return null;
  if (type.of) return typeNamed(home, type.of);
  if (type.fields) return { name, home, members: type.fields };
  const members = new Map(home.types.get(type.data).fields);
  for (const [, method] of home.text.matchAll(new RegExp(`^function ${type.table}\\.(\\w+)\\(`, 'gm')))
    members.set(method, 'a method');
  return { name, home, members };
}

// Follows "a.b:c" from a value of the type, as far as types are the plugin's own.
function follow(module, text, steps, where) {
  let type = typeNamed(module, text);
  for (const step of steps) {
    if (!type) return;
    check(type.members.has(step), module, `${where}: ${type.name} has no ${step}`);
    type = typeNamed(type.home, type.members.get(step));
  }
}

// Parameters, and what is asked of them in the function's body. One whose name is given to something
// else in there is left out.
function checkFunction(module, name, parameters, body) {
  for (const [parameter, type] of entriesOf(parameters)) {
    const declared = `(?:local|for) (?:(?!\\bin\\b)[\\w, ])*\\b${parameter}\\b`;
    const again = new RegExp(`${declared}|function\\([^)]*\\b${parameter}\\b`);
    if (parameter !== 'self' && again.test(body)) continue;
    for (const [, chain] of body.matchAll(new RegExp(`(?<![\\w.:])${parameter}((?:[.:]\\w+)+)`, 'g')))
      follow(module, type, chain.split(/[.:]/).slice(1), `${name}: ${parameter}${chain}`);
  }
}

for (const module of modules.values()) {
  const { text, requires, types } = module;
  check(!/\bself: any\b/.test(text), module, 'self is of no type');
  for (const [, alias, name] of text.matchAll(/(?<![\w.])(\w+)\.([A-Z]\w*[a-z]\w*)\b/g)) {
    const home = modules.get(requires.get(alias));
    if (home) check(home.exported.has(name), module, `${alias} exports no type ${name}`);
  }
  for (const found of text.matchAll(/local data: Data = \{|setmetatable\((\{[^{}]*(?:\{\}[^{}]*)*\}) :: Data,/g)) {
    if (found[1] === '{}') continue; // the type itself
    const given = entriesOf(braced(text, text.indexOf('{', found.index)));
    const { fields } = types.get('Data');
    for (const name of given.keys()) check(fields.has(name), module, `Data has no ${name}`);
    for (const [name, type] of fields) {
      const isFree = type.endsWith('?') || type === 'any';
      check(isFree || given.has(name), module, `the constructor gives no ${name}`);
    }
  }
  const functions = /^(?:local )?function ([\w.]+)\(([\s\S]*?)\)(?:: [^\n]*)?\n([\s\S]*?)\nend$/gm;
  for (const [, name, parameters, body] of text.matchAll(functions))
    checkFunction(module, name, parameters, body);
}
for (const module of modules.values())
  for (const path of module.requires.values())
    check(modules.has(path) || path in built, module, `there is no module ${path}`);
console.log(`${checked} names, ${problems} are not declared`);
process.exit(problems === 0 && checked > 0 ? 0 : 1);
