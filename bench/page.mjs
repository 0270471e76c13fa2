// Measures the viewer page with reports of several sizes, in milliseconds: from navigation until
// the first picture is shown, and from each change until the next picture is drawn. Each is the
// minimum of three, in a headless browser without a GPU. Targets for 5,000 parts and 1,000
// trajectories of ten seconds: 5,000 ms to open, 1,000 ms for a change.
//   bench/page.mjs [--json]     run by scripts/bench page, which builds the page
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { launch, newPage, openReport } from '../tests/web/browser.mjs';
import { change, kChanges, writeLargePage } from '../tests/web/large_page.mjs';

const kSizes = [
  [500, 250],
  [2000, 1000],
  [4000, 2000],
  [5000, 1000],
];
const kAttempts = 3;
const kWhole = { density: 1 }; // full pictures, as a user sees them
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
  let min = Infinity;
  for (let i = 0; i < kAttempts; i++) min = Math.min(min, await body(i));
  return min;
}

// Runs in the page before everything else. `firstShown`: ms from navigation until the first picture
// is on the screen. Drawing only hands the picture to the GPU, which may then take longer than
// everything before it. So the function reads a pixel, which waits for the picture, and then waits
// for the next frame.
function noteFirstShown() {
  const look = () => {
    const { obby } = window;
    if (obby?.firstDrawn === undefined) return requestAnimationFrame(look);
    const gl = obby.stage.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return requestAnimationFrame(() => (window.firstShown = performance.now()));
  };
  requestAnimationFrame(look);
}

async function timeToOpen(browser, file) {
  const page = await newPage(browser, { offline: true, ...kWhole });
  await page.addInitScript(noteFirstShown);
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => window.firstShown > 0);
  const taken = await page.evaluate(() => window.firstShown);
  await page.context().close();
  return taken;
}

async function measure(browser, empty, [parts, trajectories]) {
  const name = `parts${parts}ways${trajectories}`;
  const file = join(out, `${name}.html`);
  writeLargePage(empty, file, parts, trajectories);
  add(name, 'open', await best(() => timeToOpen(browser, file)));
  const { page } = await openReport(browser, file, kWhole);
  for (const [metric, values] of Object.entries(kChanges)) {
    add(name, metric, await best((i) => change(page, values(i))));
  }
  await page.context().close();
}

// Ends with the exit code that tells scripts/bench that the subject of the measurement is missing.
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
