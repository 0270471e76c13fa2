// Records the playback as a WebM film: from the start of the loop's range, or of the trajectory, to
// its end, at the playback's speed.
import { rangeOf } from '../playback.js';
import { seconds } from '../ui/dom.js';
import { download, fileName } from './save.js';
import { drawStill, stillCanvas } from './still.js';

/** @import {App} from '../app.js' */

const kFrames = 30; // per second
const kBits = 8e6; // per second
const kHold = 400; // ms for which the last picture is held
const kTypes = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];

export class Film {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {MediaRecorder | null} */
    this.recorder = null;
    this.canvas = stillCanvas(app);
    this.end = 0; // tick
    this.loop = false; // the loop's switch before the recording
    this.isKept = true;
    app.store.on(['query', 'path'], () => this.stop(false));
    app.store.on(['playing'], ({ playing }) => {
      if (this.recorder && !playing) this.finish();
    });
  }

  // True if the browser can record films.
  static possible() {
    return (
      typeof MediaRecorder !== 'undefined' &&
      kTypes.some((type) => MediaRecorder.isTypeSupported(type))
    );
  }

  get running() {
    return this.recorder !== null;
  }

  toggle() {
    if (this.recorder) this.stop(false);
    else this.start();
  }

  start() {
    const { store, playback } = this.app;
    const { from, to } = rangeOf(store.state, playback.lengthOf());
    if (to <= 0) return this.app.status.say('There is nothing to play');
    this.canvas = stillCanvas(this.app);
    drawStill(this.app, this.canvas); // a stream needs a first picture
    this.end = to;
    this.isKept = true;
    this.loop = store.state.loop;
    const mimeType = kTypes.find((type) => MediaRecorder.isTypeSupported(type));
    const recorder = new MediaRecorder(this.canvas.captureStream(kFrames), {
      mimeType,
      videoBitsPerSecond: kBits,
    });
    /** @type {Blob[]} */
    const pieces = [];
    recorder.addEventListener('dataavailable', ({ data }) => pieces.push(data));
    recorder.addEventListener('stop', () => this.save(pieces));
    recorder.start();
    this.recorder = recorder;
    this.app.measure(); // a film has no panels
    const status = 'Recording a film. Pause to end it';
    store.set({ tick: from, playing: true, loop: false, status });
  }

  // Called after each picture of the page.
  drawn() {
    if (!this.recorder) return;
    drawStill(this.app, this.canvas);
    if (this.app.store.state.tick >= this.end) this.app.store.set({ playing: false });
  }

  finish() {
    setTimeout(() => this.stop(true), kHold);
  }

  /** @param {boolean} keep */
  stop(keep) {
    if (!this.recorder) return;
    this.isKept = keep;
    this.recorder.stop();
    this.recorder = null;
    this.app.measure();
    this.app.store.set({ playing: false, loop: this.loop, status: '' });
  }

  /** @param {Blob[]} pieces */
  save(pieces) {
    if (!this.isKept) return;
    const blob = new Blob(pieces, { type: 'video/webm' });
    download(blob, fileName(this.app, 'webm'));
    const time = seconds(this.end / this.app.playback.rateOf());
    this.app.status.say(`Saved a film up to ${time} s (${Math.ceil(blob.size / 1000)} kB)`);
  }
}
