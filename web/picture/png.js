// PNG files of opaque pictures in RGB, like the film's frames; a canvas would write RGBA.

const crcTable = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

/** @param {Uint8Array} bytes */
function crc(bytes) {
  let c = 0xffffffff;
  for (const byte of bytes) c = crcTable[(c ^ byte) & 255] ^ (c >>> 8);
  return ~c >>> 0;
}

/** @param {string} type @param {Uint8Array} data */
function chunk(type, data) {
  const bytes = new Uint8Array(data.length + 12),
    view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  bytes.set(new TextEncoder().encode(type), 4);
  bytes.set(data, 8);
  view.setUint32(data.length + 8, crc(bytes.subarray(4, data.length + 8)));
  return bytes;
}

/** @param {Uint8Array<ArrayBuffer>} bytes @returns {Promise<Uint8Array>} in zlib's format */
async function deflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * The RGB rows of a PNG, each with the filter "up", from RGBA pixels that start at the bottom left.
 * @param {Uint8Array} pixels @param {number} width @param {number} height
 */
function filteredRows(pixels, width, height) {
  const rows = new Uint8Array(height * (3 * width + 1));
  let out = 0;
  for (let y = height - 1; y >= 0; --y) {
    rows[out++] = y === height - 1 ? 0 : 2;
    for (let x = 0; x < width; ++x) {
      const at = 4 * (y * width + x),
        above = at + 4 * width;
      for (let c = 0; c < 3; ++c) rows[out++] = pixels[at + c] - (y === height - 1 ? 0 : pixels[above + c]);
    }
  }
  return rows;
}

/**
 * @param {Uint8Array} pixels RGBA, row by row from the bottom left, as WebGL reads them
 * @param {number} width @param {number} height
 * @returns {Promise<Blob>}
 */
export async function pngOf(pixels, width, height) {
  const header = new Uint8Array(13),
    view = new DataView(header.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  header.set([8, 2], 8);
  const data = await deflated(filteredRows(pixels, width, height));
  const signature = Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10);
  const parts = [signature, chunk('IHDR', header), chunk('IDAT', data), chunk('IEND', new Uint8Array())];
  return new Blob(/** @type {BlobPart[]} */ (parts), { type: 'image/png' });
}
