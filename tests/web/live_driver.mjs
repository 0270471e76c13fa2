// Starts obby-view --live, feeds it records, and opens its page. Collects errors and requests.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { frames, newPage } from './browser.mjs';

// Returns the records that the solver writes for a level, in order.
export function recordsOf(solver, ...words) {
  return execFileSync(solver, words, { maxBuffer: 1 << 28 })
    .toString()
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
}

export class Viewer {
  constructor(program, words = []) {
    this.process = spawn(program, ['--live', ...words], { stdio: ['pipe', 'ignore', 'pipe'] });
    this.errors = '';
    this.records = 0; // written
    this.ended = new Promise((done) => {
      this.process.on('exit', (code, signal) => done(signal ?? code));
    });
    this.address = new Promise((done, fail) => {
      this.process.stderr.on('data', (chunk) => {
        this.errors += chunk;
        const found = /^obby-view: (http:\S+)$/m.exec(this.errors);
        if (found) done(found[1]);
      });
      this.process.on('exit', () => fail(new Error(this.errors)));
    });
  }

  write(...records) {
    this.records += records.length;
    this.process.stdin.write(records.map((record) => `${JSON.stringify(record)}\n`).join(''));
  }

  end() {
    this.process.stdin.end();
  }

  // Interrupts obby-view as Ctrl-C would. Returns its exit code or signal.
  async stop() {
    this.process.kill('SIGINT');
    return this.ended;
  }
}

// `prepare`: called with the page before it loads anything.
export async function openLive(browser, address, prepare = async () => {}) {
  const page = await newPage(browser);
  const trouble = [];
  const requests = [];
  const pieces = []; // answers of /data
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) trouble.push(message.text());
  });
  page.on('pageerror', (error) => trouble.push(`exception: ${error.stack}`));
  page.on('request', (request) => requests.push(request.url()));
  page.on('response', async (response) => {
    if (new URL(response.url()).pathname !== '/data') return;
    const text = await response.text().catch(() => '');
    if (text) pieces.push({ bytes: text.length, ...JSON.parse(text) });
  });
  await prepare(page);
  await page.goto(address);
  return { page, trouble, requests, pieces };
}

// Waits until the selected query has `count` trajectories.
export async function trajectoriesAre(page, count) {
  await page
    .waitForFunction((n) => window.obby.query()?.paths.length === n, count)
    .catch(async () => {
      const found = await page.evaluate(() => window.obby.query()?.paths.length);
      assert.equal(found, count, 'trajectories listed');
    });
  await frames(page, 2);
}
