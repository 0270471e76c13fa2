// Functions of newer browsers that TypeScript does not know yet, and the page's global variable.
import type { App } from '../app.js';

declare global {
  interface Uint8ArrayConstructor {
    fromBase64?(text: string): Uint8Array<ArrayBuffer>;
  }
  interface Window {
    obby?: App;
  }
}
