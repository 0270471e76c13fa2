// Decodes base64 of little-endian values into typed arrays.

/** @import {Base64} from './types/page_data.js' */

/**
 * @param {string | null | undefined} text
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function bytes(text) {
  // Newer browsers have a much faster native function.
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text || '');
  const binary = atob(text || '');
  const out = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) out[i] = binary.charCodeAt(i);
  return out;
}

/** @param {Base64<Float32Array>} text */
export const floats = (text) => new Float32Array(bytes(text).buffer);

/** @param {Base64<Int16Array>} text */
export const shorts = (text) => new Int16Array(bytes(text).buffer);

/** @param {Base64<Uint32Array>} text */
export const longs = (text) => new Uint32Array(bytes(text).buffer);

/** @param {Base64<Uint16Array>} text */
export const words = (text) => new Uint16Array(bytes(text).buffer);
