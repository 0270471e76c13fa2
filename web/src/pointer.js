// The pointer over the picture: hover notes, selection by clicks, and boxes drawn by a drag.
import { boxOf } from './choice.js';
import { ROLES } from './data.js';
import { causeOf, ROLE_STYLE } from './palette.js';
import { Picker } from './scene/picker.js';
import { el, seconds } from './ui/dom.js';

/** @import {Vector3} from 'three' */
/** @import {App} from './app.js' */
/** @import {At} from './scene/picking.js' */
/** @import {FilterBox} from './types/report.js' */

const kBoxBelow = 1; // studs that a drawn box extends below the floor
const kBoxAbove = 12;
const kRest = 200; // ms until a part under the pointer gets a note
const kMaxNotes = 3;
const kBeside = 14; // pixels from the pointer to the note

export class Pointer {
  /**
   * @param {App} app
   * @param {HTMLCanvasElement} canvas
   * @param {HTMLElement} tip
   */
  constructor(app, canvas, tip) {
    this.app = app;
    this.canvas = canvas;
    this.tip = tip;
    this.store = app.store;
    this.picker = new Picker(app.stage);
    /** @type {PointerEvent | null} */
    this.moved = null;
    /** @type {{event: PointerEvent, since: number} | null} */
    this.rest = null; // rest position and its time
    /** @type {{x: number, y: number} | null} */
    this.down = null;
    /** @type {Vector3 | null} */
    this.corner = null; // first corner of the box in progress
    /** @type {readonly FilterBox[]} */
    this.before = []; // all boxes but the one in progress
    canvas.addEventListener('pointerdown', (event) => this.press(event));
    canvas.addEventListener('pointerup', (event) => this.release(event));
    canvas.addEventListener('blur', () => canvas.classList.remove('pressed'));
    canvas.addEventListener('pointermove', (event) => {
      this.moved = event.buttons ? null : event;
      // Only a move with the left button held draws the box.
      if (this.corner && event.buttons & 1) this.drawTo(event, this.corner);
    });
    canvas.addEventListener('pointerleave', () => {
      this.moved = null;
      this.rest = null;
      this.store.set({ hoverPath: -1 });
      tip.hidden = true;
    });
    this.store.on(['drawing'], ({ drawing }) => {
      app.stage.rig.input.locked = drawing;
      canvas.style.cursor = drawing ? 'crosshair' : '';
      if (!drawing) this.corner = null;
    });
  }

  /** @param {PointerEvent} event */
  press(event) {
    this.canvas.classList.add('pressed'); // hides the focus ring, which focus() would show
    this.canvas.focus({ preventScroll: true });
    if (this.corner) this.store.set({ boxes: this.before }); // the previous drag did not end
    this.down = null;
    this.corner = null;
    // A second finger controls the camera.
    if (!this.app.level() || !event.isPrimary) return;
    this.down = { x: event.clientX, y: event.clientY };
    if (!this.store.state.drawing || event.button !== 0) return;
    this.corner = this.picker.point(this.inCanvas(event));
    this.before = this.store.state.boxes;
  }

  /** @param {PointerEvent} event */
  release(event) {
    const { down } = this;
    const still = down && Math.hypot(event.clientX - down.x, event.clientY - down.y) < 4;
    this.down = null;
    this.corner = null;
    if (!down || event.button !== 0) return; // for the camera
    if (this.store.state.drawing) this.store.set({ drawing: Boolean(still) });
    else if (still) this.click(event);
  }

  /**
   * Draws the box from the first corner to the pointer, at the height of that corner.
   * @param {PointerEvent} event
   * @param {Vector3} corner
   */
  drawTo(event, corner) {
    const to = this.picker.pointAtHeight(this.inCanvas(event), corner.y);
    if (!to) return;
    const box = boxOf(
      [corner.x, corner.y - kBoxBelow, corner.z],
      [to.x, corner.y + kBoxAbove, to.z],
    );
    this.store.set({ boxes: [...this.before, box] });
  }

  /** @param {PointerEvent} event */
  click(event) {
    const { state } = this.store;
    const at = this.inCanvas(event);
    if (state.measuring) {
      const point = this.picker.point(at);
      if (point) this.app.ruler.add(point.toArray());
      return;
    }
    const hit = this.picker.path(state, at);
    if (hit && event.shiftKey) {
      this.store.set({ ghost: hit.path === state.path ? -1 : hit.path });
    } else if (hit) {
      const same = state.path === hit.path;
      this.store.set({
        path: hit.path,
        tick: hit.tick,
        playing: same && state.playing,
      });
    } else {
      const part = this.picker.part(at);
      this.store.set({ part: part === state.part ? -1 : part });
    }
  }

  /**
   * @param {MouseEvent} event
   * @returns {At}
   */
  inCanvas(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  /**
   * Runs once a frame. A trajectory gets its note at once, a part only when the pointer rests.
   * @param {number} now
   */
  hover(now) {
    const event = this.moved;
    this.moved = null;
    const { drawing, measuring } = this.store.state;
    if (!this.app.level() || drawing || measuring) return;
    if (event) {
      const hit = this.hoverPath(event);
      this.rest = hit ? null : { event, since: now };
    } else if (this.rest && now - this.rest.since > kRest) {
      this.hoverPart(this.rest.event);
      this.rest = null;
    }
  }

  /** @param {PointerEvent} event */
  hoverPath(event) {
    const { app } = this;
    const query = app.query();
    const hit = query && this.picker.path(this.store.state, this.inCanvas(event));
    this.store.set({ hoverPath: hit ? hit.path : -1 });
    this.canvas.style.cursor = hit ? 'pointer' : '';
    this.tip.hidden = !hit;
    if (!hit) return false;
    const path = query.paths[hit.path];
    const rate = app.playback.rateOf();
    const at = `at ${seconds(hit.tick / rate)} of ${seconds(path.ticks / rate)} s`;
    this.tell(event, path.mismatch ? 'Replay mismatch' : causeOf(path, app.level()), [at]);
    return true;
  }

  /**
   * Shows the part's name and role, and the importer's reason for the role.
   * @param {PointerEvent} event
   */
  hoverPart(event) {
    const level = this.app.level();
    const part = this.picker.part(this.inCanvas(event));
    if (!level || part < 0) return;
    const name = level.names[part]?.split('/').pop() || `Part ${part}`;
    const notes = (level.notes[part] ?? []).slice(0, kMaxNotes);
    this.tell(event, name, [ROLE_STYLE[ROLES[level.role[part]]].label, ...notes]);
  }

  /**
   * @param {PointerEvent} event
   * @param {string} title
   * @param {string[]} lines
   */
  tell(event, title, lines) {
    this.tip.replaceChildren(
      el('strong', { text: title }),
      ...lines.map((text) => el('span', { text })),
    );
    this.tip.hidden = false;
    // Places the note next to the pointer, within the window.
    const { width, height } = this.tip.getBoundingClientRect();
    const x = Math.max(0, Math.min(event.clientX + kBeside, innerWidth - width));
    const y = Math.max(0, Math.min(event.clientY + kBeside, innerHeight - height));
    this.tip.style.transform = `translate(${x}px, ${y}px)`;
  }
}
