// Saves what the page shows: a picture, a film of the playback, or a trajectory's samples.
import { drawStill, stillCanvas } from './still.js';
import { plural, seconds } from '../ui/dom.js';

/** @import {App} from '../app.js' */
/** @import {Path} from '../path.js' */
/** @import {Level} from '../types/report.js' */

/**
 * Returns a file's name from the report's title, the query and an ending.
 * @param {App} app
 * @param {string} ending
 */
export function fileName(app, ending) {
  const words = [app.report.title, app.query()?.id].filter(Boolean).join(' ');
  const safe = words.replace(/[^\p{L}\p{N}]+/gu, '-').replace(/^-|-$/g, '');
  return `${safe.slice(0, 80) || 'obby'}.${ending}`;
}

/**
 * @param {Blob} blob
 * @param {string} name
 */
export function download(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

/** @param {App} app */
export function savePicture(app) {
  const target = stillCanvas(app);
  drawStill(app, target);
  target.toBlob((blob) => {
    if (!blob) return;
    download(blob, fileName(app, 'png'));
    app.status.say(`Saved a picture of ${target.width} × ${target.height} pixels`);
  }, 'image/png');
}

/**
 * Returns the samples of a trajectory for other programs. Positions are those of the feet in studs.
 * @param {Path} path
 * @param {Level | undefined} level
 */
export function pathData(path, level) {
  const round = (/** @type {number} */ value) => Number(value.toFixed(4));
  return {
    query: path.query.id,
    outcome: path.outcome,
    tickRate: level?.tickRate ?? 60,
    jumpTicks: path.jumpTicks,
    samples: Array.from({ length: path.samples }, (_, i) => ({
      tick: path.tickOf(i),
      position: [...path.points.subarray(3 * i, 3 * i + 3)].map(round),
      yaw: round((path.yaw[i] / 65536) * 2 * Math.PI),
    })),
  };
}

/**
 * Copies a text. Pages from a file may lack the clipboard's interface.
 * @param {string} text
 */
async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const field = document.createElement('textarea');
    field.value = text;
    document.body.append(field);
    field.select();
    const done = document.execCommand('copy');
    field.remove();
    if (!done) throw new Error('the browser refused');
  }
}

/** @param {App} app */
export async function copyPath(app) {
  const path = app.path();
  if (!path) return app.status.say('Select a trajectory first');
  try {
    await copy(JSON.stringify(pathData(path, app.level())));
    const time = seconds(path.ticks / app.playback.rateOf());
    app.status.say(`Copied ${plural(path.samples, 'sample')} (${time} s) as JSON`);
  } catch (error) {
    app.status.say(`Could not copy: ${error instanceof Error ? error.message : error}`);
  }
}
