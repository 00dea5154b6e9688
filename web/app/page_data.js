// Reads the data that twrench page writes into the page: see src/page/page_json.h.
import { surfaceOf } from '../picture/surface.js';
import { inflated, unpacked } from '../picture/unpacking.js';
import { byId } from './dom.js';

/** @import { Section } from '../article/types' */
/** @import { PageData } from './types' */

/** @returns {Promise<PageData>} */
export async function readPageData() {
  const data = JSON.parse(byId('scene').textContent ?? '');
  const { recording } = data;
  if (recording) {
    const halves = await unpacked(recording.rows, Uint32Array, 16); // of the eight doubles of a row
    recording.rows = new Float64Array(halves.buffer);
  }
  return { ...data, surface: await surfaceOf(data.surface) };
}

/** The sections of the article (article/article.json). @returns {Promise<Section[]>} */
export async function readArticle() {
  return JSON.parse(new TextDecoder().decode(await inflated((byId('article-data').textContent ?? '').trim(), 'gzip')));
}

/** The bytes of the core. @returns {Promise<Uint8Array>} */
export const readCore = () => inflated((byId('core').textContent ?? '').trim(), 'gzip');
