// Starts obby-view --live, feeds it records, and opens its page with a count of what must not happen.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { frames, newPage } from './browser.mjs';

// Records of a level that is solved, in order, without header and end.
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

  // What obby-view ends with after Ctrl-C.
  async stop() {
    this.process.kill('SIGINT');
    return this.ended;
  }
}

// `prepare`: is given the page before it has loaded anything.
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

// Waits until the page lists so many trajectories of the chosen query.
export async function trajectoriesAre(page, count) {
  await page
    .waitForFunction((n) => window.obby.query()?.paths.length === n, count)
    .catch(async () => {
      const found = await page.evaluate(() => window.obby.query()?.paths.length);
      assert.equal(found, count, 'trajectories listed');
    });
  await frames(page, 2);
}
