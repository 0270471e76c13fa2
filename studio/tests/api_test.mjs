// Compares the engine's API as used by the plugin and the mock with the published API
// (harness/classes.mjs): methods of services, items of enums, properties with defaults.
// node api_test.mjs; exits 1 on a mismatch.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { enumItems, member } from './harness/classes.mjs';
import { luauFiles, src, start } from './harness/luau.mjs';

let problems = 0;
function check(ok, what) {
  if (ok) return;
  problems += 1;
  console.log(`not in the API: ${what}`);
}
const hasItem = (name, item) => ` ${enumItems(name)}`.includes(` ${item}=`);

// A misspelt property with a default in the mock would have no effect.
const luau = await start({});
const listed = (await luau.call('defaults')).split('\n').filter(Boolean);
for (const line of listed) check(member(...line.split('.')), line);

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
    check(member(services[service], method) === ':', `${services[service]}.${method}`);
  }
}
console.log(`${listed.length} defaults, ${items} uses: ${problems} are not in the API`);
process.exit(problems === 0 && listed.length > 0 && items > 0 ? 0 : 1);
