// The elements of page.html that the script fills.

/** @param {string} id */
export function byId(id) {
  const element = document.getElementById(id);
  if (!element) throw new Error(`the page has no element ${id}`);
  return element;
}

export const canvas = () => /** @type {HTMLCanvasElement} */ (byId('view'));
export const dialog = () => /** @type {HTMLDialogElement} */ (byId('help'));
