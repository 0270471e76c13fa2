// How long the viewer page takes with reports of several sizes, in milliseconds: from navigation to the first picture, and
// from each change to the next picture. The least of three; a headless browser without a GPU draws it. Aims, for 2,000 parts
// and 1,000 ways of ten seconds: 3,000 ms to open, 1,000 ms for a change.
//   bench/page.mjs [--json]     by scripts/bench page, which builds the page
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { launch, openReport } from '../tests/web/browser.mjs';
import { change, kChanges, writeLargePage } from '../tests/web/large_page.mjs';

const kSizes = [
  [500, 250],
  [2000, 1000],
  [4000, 2000],
];
const kAttempts = 3;
const kWhole = { density: 1 }; // pictures as a reader has them
const kBrowsers = ['chromium', 'chromium-browser', 'google-chrome'];

const repository = dirname(dirname(fileURLToPath(import.meta.url)));
const out = join(repository, 'build/bench');
const template = join(repository, 'build/release/web/page.html');
const words = process.argv.slice(2);
const unknown = words.find((word) => word !== '--json');
if (unknown !== undefined) {
  console.error(`bench_page: unknown argument ${unknown}\nusage: scripts/bench page [--json]`);
  process.exit(2);
}
const json = words.length > 0;

function add(caseName, metric, value) {
  const row = { bench: 'page', case: caseName, metric, value: Math.round(10 * value) / 10, unit: 'ms' };
  if (json) console.log(JSON.stringify(row));
  else console.log('page'.padEnd(10), caseName.padEnd(24), metric.padEnd(28), value.toFixed(0).padStart(12), 'ms');
}

async function best(body) {
  let least = Infinity;
  for (let i = 0; i < kAttempts; i++) least = Math.min(least, await body(i));
  return least;
}

async function measure(browser, empty, [parts, ways]) {
  const name = `parts${parts}ways${ways}`;
  const file = join(out, `${name}.html`);
  writeLargePage(empty, file, parts, ways);
  const open = await best(async () => {
    const { page } = await openReport(browser, file, kWhole);
    const taken = await page.evaluate(() => window.obby.firstDrawn);
    await page.context().close();
    return taken;
  });
  add(name, 'open', open);
  const { page } = await openReport(browser, file, kWhole);
  for (const [metric, values] of Object.entries(kChanges)) {
    add(name, metric, await best((i) => change(page, values(i))));
  }
  await page.context().close();
}

// Ends with what scripts/bench takes for: what is to be measured is not there.
function leave(why) {
  console.error(`bench_page: ${why}`);
  return process.exit(77);
}

function findBrowser() {
  const { stdout } = spawnSync('sh', ['-c', kBrowsers.map((name) => `command -v ${name}`).join(' || ')]);
  const program = stdout.toString().trim();
  return program || leave(`no ${kBrowsers.join(', ')} here; scripts/setup browser installs one`);
}

if (!existsSync(template)) leave('the page was not built; cmake --preset release says why');
mkdirSync(out, { recursive: true });
const browser = await launch(join(repository, 'web'), findBrowser());
const empty = readFileSync(template, 'utf8');
for (const size of kSizes) await measure(browser, empty, size);
await browser.close();
