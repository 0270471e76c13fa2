// Checks the declarations of the plugin's types: types of other modules exist, constructors set all
// required fields, and members of `self` and of typed parameters are declared. It does not infer
// types; no npm package has a Luau type checker.
// node types_test.mjs; exits 1 on a mismatch.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { built, luauFiles, src } from './harness/luau.mjs';

// Splits at commas outside brackets. The ">" of "->" is not a bracket.
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

// Returns name -> rest for each entry "name: rest" or "name = rest"; other entries are ignored.
function entriesOf(text) {
  const entries = new Map();
  for (const piece of atCommas(text)) {
    const [, name, rest] = /^(\w+)\s*[:=]\s*([\s\S]*)$/.exec(piece) ?? [];
    if (name) entries.set(name, rest);
  }
  return entries;
}

// Returns the text between the brace at `open` and the matching brace.
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

// Returns the plugin's type that a text names, with its members, or null for all other types.
function typeNamed(module, text) {
  const [, alias, name] = /^(?:(\w+)\.)?(\w+)(?:<.*>)?\??$/.exec(text?.trim() ?? '') ?? [];
  if (!name) return null;
  const home = alias ? modules.get(module.requires.get(alias)) : module;
  const type = home?.types.get(name);
  if (!type) return null;
  if (type.of) return typeNamed(home, type.of);
  if (type.fields) return { name, home, members: type.fields };
  const members = new Map(home.types.get(type.data).fields);
  const methods = new RegExp(`^function ${type.table}\\.(\\w+)\\(`, 'gm');
  for (const [, method] of home.text.matchAll(methods))
    members.set(method, 'a method');
  return { name, home, members };
}

// Checks the members of a chain "a.b:c" up to the first that does not have a type of the plugin.
function follow(module, text, steps, where) {
  let type = typeNamed(module, text);
  for (const step of steps) {
    if (!type) return;
    check(type.members.has(step), module, `${where}: ${type.name} has no ${step}`);
    type = typeNamed(type.home, type.members.get(step));
  }
}

// Checks the members of a function's typed parameters. A parameter that the body shadows is ignored.
function checkFunction(module, name, parameters, body) {
  for (const [parameter, type] of entriesOf(parameters)) {
    const declared = `(?:local|for) (?:(?!\\bin\\b)[\\w, ])*\\b${parameter}\\b`;
    const again = new RegExp(`${declared}|function\\([^)]*\\b${parameter}\\b`);
    if (parameter !== 'self' && again.test(body)) continue;
    const uses = new RegExp(`(?<![\\w.:])${parameter}((?:[.:]\\w+)+)`, 'g');
    for (const [, chain] of body.matchAll(uses))
      follow(module, type, chain.split(/[.:]/).slice(1), `${name}: ${parameter}${chain}`);
  }
}

const constructors =
  /local data: Data = \{|setmetatable\((\{[^{}]*(?:\{\}[^{}]*)*\}) :: Data,/g;
for (const module of modules.values()) {
  const { text, requires, types } = module;
  check(!/\bself: any\b/.test(text), module, 'self has the type any');
  for (const [, alias, name] of text.matchAll(/(?<![\w.])(\w+)\.([A-Z]\w*[a-z]\w*)\b/g)) {
    const home = modules.get(requires.get(alias));
    if (home) check(home.exported.has(name), module, `${alias} exports no type ${name}`);
  }
  for (const found of text.matchAll(constructors)) {
    if (found[1] === '{}') continue; // the type itself
    const given = entriesOf(braced(text, text.indexOf('{', found.index)));
    const { fields } = types.get('Data');
    for (const name of given.keys()) check(fields.has(name), module, `Data has no ${name}`);
    for (const [name, type] of fields) {
      const isFree = type.endsWith('?') || type === 'any';
      check(isFree || given.has(name), module, `the constructor does not set ${name}`);
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
