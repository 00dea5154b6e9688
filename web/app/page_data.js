// What twrench page writes into the page: see src/page/page_json.h.
import { surfaceOf } from '../picture/surface.js';
import { inflated } from '../picture/unpacking.js';
import { byId } from './dom.js';

/**
 * @typedef {object} PageData
 * @property {string} [source] What to write on the command line for the scene.
 * @property {string[]} [source_options] Options that belong to it, if it is a mesh.
 * @property {Record<string, any>} scene Its values, with the keys of scene files.
 * @property {Record<string, any>} [source_scene] Its values before the command line changed them.
 * @property {number[]} inertia Body axes, g cm^2, row by row.
 * @property {import("../picture/surface.js").Surface} surface
 * @property {Record<string, any>} themes
 * @property {{moment: number[], moment_ratio: number, omega: number[], step: number[], tolerance: number[], time: number[]}} limits
 */

/** @returns {Promise<PageData>} */
export async function readPageData() {
  const data = JSON.parse(byId('scene').textContent ?? '');
  return { ...data, surface: await surfaceOf(data.surface) };
}

/** The bytes of the core. @returns {Promise<Uint8Array>} */
export const readCore = () => inflated((byId('core').textContent ?? '').trim(), 'gzip');
