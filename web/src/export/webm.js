// Writes encoded pictures as a WebM file (https://www.webmproject.org/docs/container/): one video
// track, with a cluster for each key picture.

/**
 * @typedef {object} Coded an encoded picture
 * @property {Uint8Array} data
 * @property {number} ms its time
 * @property {boolean} isKey
 */

/** @typedef {Uint8Array | (Uint8Array | number[])[]} Body */

const kClock = 1000000; // nanoseconds of a unit of time

/** @param {string} text */
const ascii = (text) => new TextEncoder().encode(text);

/**
 * Returns an unsigned number, most significant byte first, without leading zeros.
 * @param {number} value
 */
function unsigned(value) {
  const bytes = [];
  for (let rest = value; rest > 0 || !bytes.length; rest = Math.floor(rest / 256))
    bytes.unshift(rest % 256);
  return Uint8Array.from(bytes);
}

/** @param {number} value */
function double(value) {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, value);
  return bytes;
}

/**
 * @param {(Uint8Array | number[])[]} parts
 */
function joined(parts) {
  const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

/**
 * Returns an element: its id, its size in eight bytes, and its body.
 * @param {number} id
 * @param {Body} body
 */
function element(id, body) {
  const bytes = body instanceof Uint8Array ? body : joined(body);
  const size = [0x01, 0, 0, 0, 0, 0, 0, 0];
  unsigned(bytes.length).forEach((byte, i, all) => {
    size[8 - all.length + i] = byte;
  });
  return joined([unsigned(id), size, bytes]);
}

const header = () =>
  element(0x1a45dfa3, [
    element(0x4286, [[1]]), // version
    element(0x42f7, [[1]]),
    element(0x42f2, [[4]]), // max length of an id
    element(0x42f3, [[8]]), // ... and of a size
    element(0x4282, ascii('webm')),
    element(0x4287, [[4]]),
    element(0x4285, [[2]]),
  ]);

/**
 * @param {Coded[]} pictures the first is a key picture; less than 30 s
 */
function cluster(pictures) {
  const [{ ms: start }] = pictures;
  const blocks = pictures.map(({ data, ms, isKey }) => {
    const after = Math.round(ms - start);
    return element(0xa3, [[0x81, after >> 8, after & 255, isKey ? 0x80 : 0], data]);
  });
  return element(0x1f43b675, [element(0xe7, unsigned(Math.round(start))), ...blocks]);
}

/**
 * Returns the file.
 * @param {Coded[]} pictures in order; the first is a key picture
 * @param {{width: number, height: number, codec: string, ms: number}} film `codec`: a WebM name
 *   such as V_VP9; `ms`: duration
 */
export function webm(pictures, { width, height, codec, ms }) {
  /** @type {Coded[][]} */
  const groups = [];
  for (const picture of pictures) {
    if (picture.isKey) groups.push([]);
    groups.at(-1)?.push(picture);
  }
  const info = element(0x1549a966, [
    element(0x2ad7b1, unsigned(kClock)),
    element(0x4d80, ascii('obby-view')),
    element(0x5741, ascii('obby-view')),
    element(0x4489, double(ms)),
  ]);
  const size = element(0xe0, [element(0xb0, unsigned(width)), element(0xba, unsigned(height))]);
  const track = element(0xae, [
    element(0xd7, [[1]]), // number
    element(0x73c5, [[1]]),
    element(0x83, [[1]]), // video
    element(0x86, ascii(codec)),
    size,
  ]);
  const tracks = element(0x1654ae6b, track);
  return joined([header(), element(0x18538067, [info, tracks, ...groups.map(cluster)])]);
}
