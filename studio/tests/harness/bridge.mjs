// Runs the built bridge for live tests. Its state folder outlives a restart.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';

export class Bridges {
  constructor(bin) {
    this.bin = bin;
    this.folder = mkdtempSync(join(tmpdir(), 'obby-studio-'));
    this.running = null;
  }

  // Starts the bridge. Returns its port and, if the options contain --pair, the code.
  async start(port, options) {
    const command = ['--port', String(port), '--state-dir', join(this.folder, 'state'), ...options];
    const program = join(this.bin, 'obby-bridge');
    const child = spawn(program, command, { stdio: ['ignore', 'pipe', 'inherit'] });
    this.running = child;
    const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
    const first = (await lines.next()).value ?? '';
    const where = /http:\/\/127\.0\.0\.1:(\d+)/.exec(first);
    if (!where) throw new Error(`obby-bridge did not start: ${first}`);
    const offers = options.includes('--pair');
    const code = offers ? (await lines.next()).value.split(': ').pop().trim() : '';
    return { port: Number(where[1]), code };
  }

  async stop(signal = 'SIGTERM') {
    const child = this.running;
    this.running = null;
    if (!child || child.exitCode !== null) return;
    const ended = new Promise((resolve) => child.once('exit', resolve));
    child.kill(signal);
    await ended;
  }

  async close() {
    await this.stop();
    rmSync(this.folder, { recursive: true, force: true });
  }
}
