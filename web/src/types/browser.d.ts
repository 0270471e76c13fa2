// What newer browsers have and TypeScript does not know yet, and the page's own name for the console.
import type { App } from '../app.js';

declare global {
  interface Uint8ArrayConstructor {
    fromBase64?(text: string): Uint8Array<ArrayBuffer>;
  }
  interface Window {
    obby?: App;
  }
}
