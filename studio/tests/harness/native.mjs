// Node's services for live tests: requests, sockets, bridges, files. The answer to a call arrives
// later with the call's id. Bytes are sent as hexadecimal digits, because texts between Luau and
// Node are UTF-8.
import { execFile } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Bridges } from './bridge.mjs';
import { openSocket } from './websocket.mjs';

export class Native {
  constructor(bin, levels) {
    this.bin = bin;
    this.bridges = new Bridges(bin);
    this.levels = levels;
    this.queue = [];
    this.wake = () => {};
    this.sockets = new Map();
  }

  arrive(...values) {
    this.queue.push(values);
    this.wake();
  }

  async request(id, url, method, headers, body) {
    try {
      const answer = await fetch(url, {
        method,
        headers: JSON.parse(headers),
        body: body ? Buffer.from(body, 'hex') : undefined,
      });
      this.arrive(id, true, answer.status, await answer.text());
    } catch (error) {
      this.arrive(id, false, 0, `HttpError: ${error.cause?.code ?? error.message}`);
    }
  }

  open(id, url, headers) {
    const socket = openSocket(url, JSON.parse(headers), {
      opened: (status) => this.arrive(id, 'opened', status),
      message: (text) => this.arrive(id, 'message', text),
      error: (status, text) => this.arrive(id, 'error', status, text),
      closed: () => this.arrive(id, 'closed'),
    });
    this.sockets.set(id, socket);
  }

  // Runs a built tool with the given input. Answers with the output lines that match `keep`,
  // because the VM's memory is small.
  tool(id, name, options, input, keep) {
    const command = join(this.bin, name);
    const wanted = (line) => new RegExp(keep).test(line);
    const done = (error, out) =>
      this.arrive(id, !error, 0, error?.message ?? out.split('\n').filter(wanted).join('\n'));
    const words = options.split(' ').filter(Boolean);
    execFile(command, words, { maxBuffer: 64 << 20 }, done).stdin.end(input);
  }

  // Returns the functions that Luau can call.
  table() {
    return {
      request: (...values) => void this.request(...values),
      open: (...values) => this.open(...values),
      say: (id, text) => this.sockets.get(id)?.send(text),
      shut: (id) => this.sockets.get(id)?.close(),
      drop: () => this.sockets.forEach((socket) => socket.drop()),
      startBridge: (id, port, options) =>
        void this.bridges.start(port, options.split(' ').filter(Boolean)).then(
          ({ port: taken, code }) => this.arrive(id, true, taken, code),
          (error) => this.arrive(id, false, 0, error.message),
        ),
      stopBridge: (id, signal) =>
        void this.bridges.stop(signal).then(() => this.arrive(id, true, 0, '')),
      tool: (...values) => this.tool(...values),
      levelFile: (name) => readFileSync(join(this.levels, name)).toString('hex'),
    };
  }

  // Waits until something arrives, for at most `seconds`.
  async pause(seconds) {
    if (this.queue.length > 0) return;
    let timer;
    await new Promise((resolve) => {
      this.wake = resolve;
      timer = setTimeout(resolve, seconds * 1000);
    });
    clearTimeout(timer);
    this.wake = () => {};
  }

  async close() {
    this.sockets.forEach((socket) => socket.drop());
    await this.bridges.close();
  }
}
