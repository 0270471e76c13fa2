// Writes lib/engine/api/classes.txt, the members of the engine's classes and the items of its
// enums, from the type definitions of @rbxts/types (MIT), which studio/ installs. The tests of the
// plugin import its functions.
//   node scripts/engine-classes.mjs
//   BasePart PVInstance           class and base class
//    Anchored b  Size Vector3     properties, with their type: b boolean, n number, s string, @X enum X, = instance
//    .Touched  :ApplyImpulse  !OnInvoke   events, methods, callbacks
//   enum Material Plastic=256 ...
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

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

// The declarations `readonly Name: Type;`, `get Name(): Type;`, `Name(...): Type;` and `Name<T>(...): Type;`.
const declaration = /^ {4}(?:readonly |(get) )?(\w+)\??(<|\(\)?)?:? ?([^\n]*)/gm;
function membersOf(body, classes) {
  const words = [];
  for (const [, accessor, name, opening, rest] of body.matchAll(declaration)) {
    if (name.startsWith('_nominal') || name === 'set') continue;
    const type = rest.replace(/;$/, '');
    if (opening && !accessor) words.push(`:${name}`);
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

// Classes of old places that the typings no longer list.
const former = { FlagStand: 'Part', HopperBin: 'BackpackItem', Status: 'Model' };

// Returns the lines of the classes that the files declare, and of all enums.
export function classLines(files) {
  const all = new Map();
  for (const file of files)
    for (const [name, own] of interfaces(read(file))) {
      const other = all.get(name);
      all.set(name, other ? { base: other.base ?? own.base, body: other.body + own.body } : own);
    }
  const baseOf = (name) => all.get(name)?.base?.replace(/<.*/, '');
  const isRoot = (name) => name === 'Object' || name === 'Instance';
  const isClass = (name) => isRoot(name) || (baseOf(name) && isClass(baseOf(name)));
  for (const [name, base] of Object.entries(former)) all.set(name, { base, body: '' });
  const classes = new Set([...all.keys()].filter(isClass).sort());
  const lines = [];
  for (const name of classes) {
    lines.push(`${name} ${baseOf(name) ?? '-'}`);
    for (const word of membersOf(all.get(name).body, classes)) lines.push(` ${word}`);
  }
  return [...lines, ...enumsOf(read('generated/enums.d.ts'))];
}

// Returns "Class.Property" for each property that scripts may only read.
export function readOnlyProperties(files) {
  const pattern = /^ {4}readonly (\w+)\??: (?!RBXScriptSignal)/gm;
  const own = ([name, { body }]) => [...body.matchAll(pattern)].map(([, property]) => `${name}.${property}`);
  return files.flatMap((file) => [...interfaces(read(file))].flatMap(own));
}

// Returns the names of the classes that Instance.new makes.
export function creatableClasses() {
  const { body } = interfaces(read('generated/None.d.ts')).get('CreatableInstances');
  return membersOf(body, new Set()).map((word) => word.split(' ')[0]);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const lines = classLines(['generated/None.d.ts', 'roblox.d.ts']);
  writeFileSync(new URL('lib/engine/api/classes.txt', root), `${lines.join('\n')}\n`);
}
