// The parts of a level as a tree of folders, by the paths of their names.

/** @import {Level} from './types/report.js' */

/**
 * `count`: parts in the folder and below.
 * @typedef {{name: string, count: number, folders: Map<string, Folder>, parts: number[]}} Folder
 */

/**
 * @param {string} name
 * @returns {Folder}
 */
const folder = (name) => ({ name, count: 0, folders: new Map(), parts: [] });

/**
 * Returns the root. A chain of folders with nothing else in them is one folder.
 * @param {Level} level
 * @returns {Folder}
 */
export function partTree(level) {
  const root = folder('');
  for (let part = 0; part < level.count; part++) {
    const path = (level.names[part] ?? '').split('/').slice(0, -1);
    let at = root;
    at.count += 1;
    for (const name of path) {
      const next = at.folders.get(name) ?? folder(name);
      at.folders.set(name, next);
      next.count += 1;
      at = next;
    }
    at.parts.push(part);
  }
  return merged(root);
}

/**
 * @param {Folder} at
 * @returns {Folder}
 */
function merged(at) {
  const [only] = at.folders.values();
  if (at.name && at.folders.size === 1 && !at.parts.length)
    return merged({ ...only, name: `${at.name}/${only.name}` });
  at.folders = new Map([...at.folders].map(([key, child]) => [key, merged(child)]));
  return at;
}

/**
 * Returns the parts whose names, roles or tags contain all words of a text.
 * @param {Level} level
 * @param {string} text
 * @param {(part: number) => string} more further text of a part
 */
export function foundParts(level, text, more) {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const found = [];
  for (let part = 0; part < level.count; part++) {
    const all = `${level.names[part] ?? ''} ${more(part)}`.toLowerCase();
    if (words.every((word) => all.includes(word))) found.push(part);
  }
  return found;
}
