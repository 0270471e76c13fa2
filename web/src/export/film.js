// Records the playback as a WebM film: from the start of the loop's range, or of the trajectory, to
// its end, at the playback's speed. While it records, each picture of the page is one of the film,
// so that a slow computer takes longer but drops no pictures.
import { rangeOf } from '../playback.js';
import { plural } from '../ui/dom.js';
import { download, fileName } from './save.js';
import { drawStill, stillCanvas } from './still.js';
import { webm } from './webm.js';

/** @import {App} from '../app.js' */
/** @import {Coded} from './webm.js' */

const kRate = 30; // pictures a second
const kBits = 0.1; // per pixel of a picture
const kBetweenKeys = 60; // pictures
const kHold = 15; // times that the last picture is repeated
const kMaxQueue = 6; // pictures that wait for the encoder
const kVp8 = { encoder: 'vp8', file: 'V_VP8' };
const kVp9 = { encoder: 'vp09.00.51.08', file: 'V_VP9' }; // level 5.1: up to 4K

export class Film {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {VideoEncoder | null} */
    this.encoder = null;
    /** @type {Coded[]} */
    this.pictures = [];
    this.count = 0; // pictures given to the encoder
    this.end = 0; // tick
    this.loop = false; // the loop's switch before the recording
    this.canvas = stillCanvas(app);
    this.codec = kVp8;
    this.chooseCodec();
    app.store.on(['query', 'path'], () => this.cancel());
    app.store.on(['playing'], ({ playing }) => {
      if (this.encoder && !playing) this.finish();
    });
  }

  // True if the browser can encode films.
  static possible() {
    return typeof VideoEncoder !== 'undefined' && typeof VideoFrame !== 'undefined';
  }

  // VP9 looks better at the same size, but not all browsers encode it.
  async chooseCodec() {
    if (!Film.possible()) return;
    const config = { codec: kVp9.encoder, width: 1280, height: 720, framerate: kRate };
    const { supported } = await VideoEncoder.isConfigSupported(config);
    if (supported) this.codec = kVp9;
  }

  get running() {
    return this.encoder !== null;
  }

  // True if the page must wait with its next picture.
  get busy() {
    return (this.encoder?.encodeQueueSize ?? 0) > kMaxQueue;
  }

  // Seconds between two pictures.
  get step() {
    return 1 / kRate;
  }

  toggle() {
    if (this.encoder) this.cancel();
    else this.start();
  }

  start() {
    const { store, playback, status } = this.app;
    const { from, to } = rangeOf(store.state, playback.lengthOf());
    if (to <= 0) return status.say('There is nothing to play');
    this.canvas = stillCanvas(this.app);
    this.pictures = [];
    this.count = 0;
    this.end = to;
    this.loop = store.state.loop;
    this.encoder = new VideoEncoder({
      output: (chunk) => {
        const data = new Uint8Array(chunk.byteLength);
        chunk.copyTo(data);
        this.pictures.push({ data, ms: chunk.timestamp / 1000, isKey: chunk.type === 'key' });
      },
      error: (error) => {
        this.cancel();
        status.say(`Could not record: ${error.message}`);
      },
    });
    const { width, height } = this.canvas;
    const bitrate = Math.round(kBits * width * height * kRate);
    this.encoder.configure({ codec: this.codec.encoder, width, height, bitrate, framerate: kRate });
    this.app.measure(); // a film has no panels
    const note = 'Recording a film. Pause to end it';
    store.set({ tick: from, playing: true, loop: false, status: note });
  }

  // Called after each picture of the page.
  drawn() {
    if (!this.encoder) return;
    drawStill(this.app, this.canvas);
    this.encode();
    if (this.app.store.state.tick >= this.end) this.app.store.set({ playing: false });
  }

  encode() {
    if (this.encoder?.state !== 'configured') return;
    const frame = new VideoFrame(this.canvas, { timestamp: (1e6 * this.count) / kRate });
    this.encoder.encode(frame, { keyFrame: this.count % kBetweenKeys === 0 });
    frame.close();
    this.count += 1;
  }

  async finish() {
    const { encoder } = this;
    for (let i = 0; i < kHold; i++) this.encode();
    this.release();
    await encoder?.flush();
    encoder?.close();
    const { width, height } = this.canvas;
    const ms = (1000 * this.count) / kRate;
    const bytes = webm(this.pictures, { width, height, codec: this.codec.file, ms });
    const blob = new Blob([bytes], { type: 'video/webm' });
    download(blob, fileName(this.app, 'webm'));
    const size = `${Math.ceil(bytes.length / 1000)} kB`;
    this.app.status.say(`Saved a film of ${plural(Math.round(ms / 1000), 'second')} (${size})`);
  }

  // Gives the page its clock back.
  release() {
    this.encoder = null;
    this.app.measure();
    this.app.store.set({ playing: false, loop: this.loop, status: '' });
  }

  cancel() {
    const { encoder } = this;
    if (!encoder) return;
    this.release();
    if (encoder.state !== 'closed') encoder.close();
  }
}
