// The engine's classes and enums as published (npm @rbxts/types, made from the engine's own dump),
// with the members that only plugins may use.
import { classLines, creatableClasses, readOnlyProperties } from '../../../scripts/engine-classes.mjs';

// Members that the typings lack, although the engine documents them and plugins use them.
const beyond = `
PluginAction Instance
 ActionId s
 Text s
PluginGui LayerCollector
 Title s
PluginToolbarButton Instance
 ClickableWhenViewportHidden b
 Enabled b
 Icon s
Selection Instance
 .SelectionChanged`;

const files = ['generated/None.d.ts', 'generated/PluginSecurity.d.ts', 'roblox.d.ts'];
const classes = new Map(); // name -> { base, members: name -> code }
const enums = new Map(); // name -> 'Plastic=256 Neon=288'
let open;
for (const line of [...classLines(files), ...beyond.trim().split('\n')]) {
  const [first, ...rest] = line.trim().split(' ');
  const kind = /^[:.!]/.exec(first)?.[0];
  if (line[0] === ' ') open.members.set(kind ? first.slice(1) : first, kind ?? rest[0]);
  else if (first === 'enum') enums.set(rest[0], rest.slice(1).join(' '));
  else classes.set(first, (open = classes.get(first) ?? { base: rest[0], members: new Map() }));
}

// Returns the base class: '-' for the root, '' if there is no such class.
export const baseClass = (name) => classes.get(name)?.base ?? '';

// Returns the member's code as in lib/engine/api/classes.txt; '' if the class has no such member.
export function member(className, name) {
  const known = classes.get(className);
  return known ? known.members.get(name) ?? member(known.base, name) : '';
}

const readOnly = new Set(readOnlyProperties(files));
export const isReadOnly = (className, name) =>
  readOnly.has(`${className}.${name}`) ||
  (classes.has(className) && isReadOnly(classes.get(className).base, name));

export const enumItems = (name) => enums.get(name) ?? '';

const creatable = new Set(creatableClasses());
export const isCreatable = (name) => creatable.has(name);
