// Writes lib/engine/api/classes.txt, the members of the engine's classes and the items of its
// enums, from the type definitions of @rbxts/types (MIT), which studio/ installs:
//   node scripts/engine-classes.mjs
//   BasePart PVInstance           class and base class
//    Anchored b  Size Vector3     properties, with their type: b boolean, n number, s string, @X enum X, = instance
//    .Touched  :ApplyImpulse  !OnInvoke   events, methods, callbacks
//   enum Material Plastic=256 ...
import { readFileSync, writeFileSync } from 'node:fs';

const root = new URL('..', import.meta.url);
const types = new URL('studio/node_modules/@rbxts/types/include/', root);
const read = (name) => readFileSync(new URL(name, types), 'utf8');
const bare = (text) => text.replace(/\/\*[\s\S]*?\*\//g, '');

function interfaces(text) {
  const found = new Map();
  const pattern = /^(?:export )?interface (\w+)(?:<[^>{]*>)?(?: extends ([\w<>, ]+?))? \{\n([\s\S]*?)^\}/gm;
  for (const [, name, base, body] of bare(text).matchAll(pattern)) found.set(name, { base, body });
  return found;
}

const plain = { boolean: 'b', number: 'n', string: 's' };
function typeCode(type, classes) {
  const [first] = type.split('|').map((part) => part.trim());
  if (plain[first]) return plain[first];
  if (first.startsWith('Enum.')) return `@${first.slice(5).split('.')[0]}`;
  if (first === 'ContentId') return 's';
  return classes.has(first) ? '=' : first.replace(/\W.*/s, '') || 'unknown';
}

function membersOf(body, classes) {
  const words = [];
  for (const [, name, rest] of body.matchAll(/^ {4}(?:readonly )?(\w+)\??(\(|: [^\n]*)/gm)) {
    if (name.startsWith('_nominal')) continue;
    const type = rest.startsWith(': ') ? rest.slice(2).replace(/;$/, '') : '';
    if (rest === '(') words.push(`:${name}`);
    else if (type.startsWith('RBXScriptSignal')) words.push(`.${name}`);
    else if (type.startsWith('(') || type === 'Callback') words.push(`!${name}`);
    else words.push(`${name} ${typeCode(type, classes)}`);
  }
  return [...new Set(words)].sort();
}

function enumsOf(text) {
  const lines = [];
  for (const [, name, body] of bare(text).matchAll(/^ {4}export namespace (\w+) \{\n([\s\S]*?)^ {4}\}/gm)) {
    const items = [...body.matchAll(/Name: "(\w+)";\s+Value: (-?\d+);/g)].map(([, item, value]) => `${item}=${value}`);
    lines.push(`enum ${name} ${items.join(' ')}`);
  }
  return lines;
}

const all = interfaces(read('generated/None.d.ts'));
for (const [name, own] of interfaces(read('roblox.d.ts'))) {
  const other = all.get(name);
  all.set(name, other ? { base: other.base ?? own.base, body: other.body + own.body } : own);
}
const classes = new Map();
const isClass = (name) => name === 'Object' || name === 'Instance' || (all.get(name)?.base && isClass(all.get(name).base.replace(/<.*/, '')));
for (const [name, own] of all) if (isClass(name)) classes.set(name, own);
const lines = [];
for (const [name, { base, body }] of [...classes].sort(([a], [b]) => (a < b ? -1 : 1))) {
  lines.push(`${name} ${base ? base.replace(/<.*/, '') : '-'}`);
  for (const word of membersOf(body, classes)) lines.push(` ${word}`);
}
lines.push(...enumsOf(read('generated/enums.d.ts')));
writeFileSync(new URL('lib/engine/api/classes.txt', root), `${lines.join('\n')}\n`);
