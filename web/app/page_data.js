// Reads the data that twrench page writes into the page: see src/page/page_json.h.
import { surfaceOf } from '../picture/surface.js';
import { inflated } from '../picture/unpacking.js';
import { byId } from './dom.js';

/** @import { PageData } from './types' */

/** @returns {Promise<PageData>} */
export async function readPageData() {
  const data = JSON.parse(byId('scene').textContent ?? '');
  return { ...data, surface: await surfaceOf(data.surface) };
}

/** The bytes of the core. @returns {Promise<Uint8Array>} */
export const readCore = () => inflated((byId('core').textContent ?? '').trim(), 'gzip');
