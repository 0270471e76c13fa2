// Compares the engine's API as used by the plugin and the mock with the published API (npm
// @rbxts/types, made from the engine's own dump): classes, their members, and items of enums.
// node api_test.mjs; exits 1 on a mismatch.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { luauFiles, src, start } from './harness/luau.mjs';

const include = fileURLToPath(new URL('include', import.meta.resolve('@rbxts/types/package.json')));
const read = (name) => readFileSync(join(include, name), 'utf8').replace(/\/\*[\s\S]*?\*\//g, '');

// Members that the typings lack, although the engine documents them and plugins use them.
const beyond = new Set([
  'PluginAction.ActionId',
  'PluginAction.Text',
  'PluginGui.Title',
  'PluginToolbarButton.ClickableWhenViewportHidden',
  'PluginToolbarButton.Enabled',
  'PluginToolbarButton.Icon',
  'Selection.SelectionChanged',
]);

function interfaces(texts) {
  const all = new Map();
  for (const text of texts) {
    for (const [, name, bases, body] of text.matchAll(
      /^\s*(?:declare )?interface (\w+)(?:<[^{]*?>)?(?: extends ([\w, <>]+))? \{\n([\s\S]*?)\n\t?\}/gm,
    )) {
      const known = all.get(name) ?? { bases: [], members: new Set() };
      for (const base of (bases ?? '').split(',')) known.bases.push(base.replace(/<.*/, '').trim());
      const members = body.matchAll(/^\s*(?:readonly |[gs]et )?(\w+)\??\s*[:(<]/gm);
      for (const [, member] of members) known.members.add(member);
      all.set(name, known);
    }
  }
  return all;
}

const api = interfaces(['generated/None.d.ts', 'generated/PluginSecurity.d.ts', 'roblox.d.ts'].map(read));

function has(className, member) {
  const known = api.get(className);
  if (!known) return false;
  return known.members.has(member) || known.bases.some((base) => has(base, member));
}

const enumText = read('generated/enums.d.ts');
function hasItem(name, item) {
  const block = new RegExp(`namespace ${name} \\{[\\s\\S]*?\\n(?:    |\\t)\\}`).exec(enumText);
  return Boolean(block) && new RegExp(`interface ${item} `).test(block[0]);
}

let problems = 0;
function check(ok, what) {
  if (ok || beyond.has(what)) return;
  problems += 1;
  console.log(`not in the API: ${what}`);
}

// Checks the mock's classes, too. A misspelt property in the mock would hide one in the plugin.
const luau = await start({});
const listed = (await luau.call('classes')).split('\n').filter(Boolean);
for (const line of listed) {
  const [className, member] = line.split('.');
  check(member ? has(className, member) : api.has(className), line);
}

// The members of Host that are services.
const services = {
  game: 'DataModel',
  gui: 'CoreGui',
  history: 'ChangeHistoryService',
  players: 'Players',
  replicated: 'ReplicatedStorage',
  http: 'HttpService',
  plugin: 'Plugin',
  run: 'RunService',
  selection: 'Selection',
  serialization: 'SerializationService',
  storage: 'ServerStorage',
  tags: 'CollectionService',
  test: 'StudioTestService',
  workspace: 'Workspace',
};
let items = 0;
for (const file of luauFiles(src)) {
  const text = readFileSync(join(src, file), 'utf8');
  for (const [use, name, item] of text.matchAll(/\bEnum\.(\w+)\.(\w+)/g)) {
    items += 1;
    check(hasItem(name, item), use);
  }
  for (const [, item] of text.matchAll(/\bguide\.(\w+)/g)) {
    items += 1;
    check(hasItem('StudioStyleGuideColor', item), `Enum.StudioStyleGuideColor.${item}`);
  }
  for (const [, service, method] of text.matchAll(/host\.(\w+)\s*(?:::\s*\w+\))?\s*:\s*(\w+)\(/g)) {
    items += 1;
    check(has(services[service], method), `${services[service]}.${method}`);
  }
}
console.log(`${listed.length} classes and members, ${items} uses: ${problems} are not in the API`);
process.exit(problems === 0 && listed.length > 0 && items > 0 ? 0 : 1);
