// Shows the input during the current tick, relative to the camera, with speed and height. At the
// start the player stands and no key is pressed.
import { decimal, el } from './dom.js';

/** @import {Path} from '../path.js' */

export class Hud {
  /** @param {HTMLElement} root */
  constructor(root) {
    this.root = root;
    /** @type {Record<string, HTMLElement>} */
    this.keys = {};
    const key = (/** @type {string} */ name, /** @type {string} */ label) => {
      this.keys[name] = el('span', { class: `cap ${name}`, text: label });
      return this.keys[name];
    };
    this.speed = el('b', {});
    this.height = el('b', {});
    this.jumps = el('b', {});
    root.append(
      el(
        'div',
        { class: 'keys' },
        key('w', 'W'),
        key('a', 'A'),
        key('s', 'S'),
        key('d', 'D'),
        key('jump', 'Space'),
      ),
      el(
        'dl',
        {},
        el('dt', { text: 'Speed' }),
        el('dd', {}, this.speed, ' studs/s'),
        el('dt', { text: 'Height' }),
        el('dd', {}, this.height, ' studs'),
        el('dt', { text: 'Jumps' }),
        el('dd', {}, this.jumps),
      ),
    );
    root.hidden = true;
  }

  hide() {
    this.root.hidden = true;
  }

  /**
   * @param {Path | undefined} path
   * @param {number} tick
   * @param {number} tickRate
   * @param {number} cameraYaw
   */
  show(path, tick, tickRate, cameraYaw) {
    this.root.hidden = !path;
    if (!path) return;
    const action = path.actionBefore(tick);
    const pressed = new Set(action.jump ? ['jump'] : []);
    if (action.walk) {
      // Angle of the move direction, left of the camera's direction, in eighths of a turn.
      const turns = action.heading / 65536 - cameraYaw / (2 * Math.PI);
      const eighth = ((Math.round(turns * 8) % 8) + 8) % 8;
      for (const name of [
        ['w'],
        ['w', 'a'],
        ['a'],
        ['a', 's'],
        ['s'],
        ['s', 'd'],
        ['d'],
        ['d', 'w'],
      ][eighth])
        pressed.add(name);
    }
    for (const [name, cap] of Object.entries(this.keys))
      cap.classList.toggle('down', pressed.has(name));
    const pose = path.poseAt(tick);
    this.speed.textContent = decimal(Math.hypot(...pose.perTick) * tickRate);
    this.height.textContent = decimal(pose.y);
    this.jumps.textContent = String(path.jumpTicks.filter((at) => at <= tick).length);
  }
}
