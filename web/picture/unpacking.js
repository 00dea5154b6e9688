// Reads the compressed data of the page: the core, and the numbers of surfaces.

/**
 * Decodes base64 and decompresses it.
 * @param {string} text @param {CompressionFormat} format
 * @returns {Promise<Uint8Array>}
 */
export async function inflated(text, format) {
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(format));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * The integers that src/page/packing.h wrote.
 * @template {Int16Array | Uint16Array | Uint32Array} Integers
 * @param {string} text @param {new (buffer: ArrayBufferLike) => Integers} Kind @param {number} width of a row
 * @returns {Promise<Integers>}
 */
export async function unpacked(text, Kind, width) {
  const integers = new Kind((await inflated(text, 'deflate')).buffer);
  for (let i = width; i < integers.length; ++i) integers[i] += integers[i - width];
  return integers;
}
