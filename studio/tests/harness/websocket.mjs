// A WebSocket client over node:http, for texts. Unlike Node's own client it sends custom headers.
import { randomBytes } from 'node:crypto';
import { request } from 'node:http';

const TEXT = 1;
const CLOSE = 8;
const LONGEST_SHORT = 125; // max payload bytes whose count fits into the frame's second byte

function frame(opcode, payload) {
  const mask = randomBytes(4);
  const long = payload.length > LONGEST_SHORT;
  const head = Buffer.alloc(long ? 4 : 2);
  head[0] = 0x80 | opcode;
  head[1] = 0x80 | (long ? 126 : payload.length);
  if (long) head.writeUInt16BE(payload.length, 2);
  return Buffer.concat([head, mask, payload.map((byte, i) => byte ^ mask[i % 4])]);
}

// Returns the first complete frame of `data`, or null.
function parse(data) {
  if (data.length < 2) return null;
  let size = data[1] & 127;
  let at = 2;
  if (size === 126) [size, at] = [data.length < 4 ? Infinity : data.readUInt16BE(2), 4];
  else if (size === 127) {
    [size, at] = [data.length < 10 ? Infinity : Number(data.readBigUInt64BE(2)), 10];
  }
  if (data.length < at + size) return null;
  return { opcode: data[0] & 15, payload: data.subarray(at, at + size), end: at + size };
}

// on: opened(status), message(text), error(status, text), closed().
export function openSocket(url, headers, on) {
  const { hostname, port, pathname, search } = new URL(url);
  const key = randomBytes(16).toString('base64');
  const outgoing = request({
    host: hostname,
    port,
    path: pathname + search,
    headers: {
      ...headers,
      Connection: 'Upgrade',
      Upgrade: 'websocket',
      'Sec-WebSocket-Version': 13,
      'Sec-WebSocket-Key': key,
    },
  });
  let socket = null;
  outgoing.on('response', (response) => {
    response.resume();
    on.error(response.statusCode, response.statusMessage);
  });
  outgoing.on('error', (error) => on.error(0, `HttpError: ${error.code}`));
  outgoing.on('upgrade', (response, stream, head) => {
    socket = stream;
    let data = head;
    const read = () => {
      for (let next = parse(data); next; next = parse(data)) {
        data = data.subarray(next.end);
        if (next.opcode === TEXT) on.message(next.payload.toString());
        else if (next.opcode === CLOSE) stream.end(frame(CLOSE, next.payload));
      }
    };
    stream.on('data', (bytes) => {
      data = Buffer.concat([data, bytes]);
      read();
    });
    stream.on('error', () => {});
    stream.on('close', () => on.closed());
    on.opened(response.statusCode);
    read();
  });
  outgoing.end();
  return {
    send: (text) => socket?.write(frame(TEXT, Buffer.from(text))),
    close: () => (socket ? socket.end(frame(CLOSE, Buffer.from([3, 232]))) : outgoing.destroy()),
    // Ends the connection without a close frame, as a network failure does.
    drop: () => socket?.destroy(),
  };
}
