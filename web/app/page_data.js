// What twrench page writes into the page: see src/page/page_json.h.

/**
 * @typedef {object} PageData
 * @property {string} [source] What to write on the command line for the scene.
 * @property {Record<string, any>} scene Its values, with the keys of scene files.
 * @property {Record<string, any>} [source_scene] Its values before the command line changed them.
 * @property {number[]} inertia Body axes, g cm^2, row by row.
 * @property {any} surface See picture/surface.js.
 * @property {Record<string, any>} themes
 * @property {{moment: number[], moment_ratio: number, omega: number[], step: number[], tolerance: number[], time: number[]}} limits
 */

/** @returns {PageData} */
export function readPageData() {
  return JSON.parse(document.getElementById('scene')?.textContent ?? '{}');
}

/**
 * The bytes of the core: compressed and in base64, as they stand in the page.
 * @returns {Promise<Uint8Array>}
 */
export async function readCore() {
  const element = document.getElementById('core');
  const text = atob((element?.textContent ?? '').trim());
  const bytes = Uint8Array.from(text, (character) => character.charCodeAt(0));
  const format = /** @type {CompressionFormat} */ (element?.dataset.compression ?? 'gzip');
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(format));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
