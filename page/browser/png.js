// PNG without a library: the browser's own (de)compression, and filters. Used for textures, so that their values do not
// pass through a canvas, and for downloads.
//   source   W3C, Portable Network Graphics (PNG) Specification, 2nd ed. (2003)

const signature = [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10];
const mostPixels = 2 ** 28;

async function through(stream, bytes) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

export const isPng = (bytes) => signature.every((byte, i) => bytes[i] === byte);

function chunksOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const chunks = [];
  for (let at = 8; at + 12 <= bytes.length;) {
    const length = view.getUint32(at);
    if (at + 12 + length > bytes.length) throw new Error("the file is truncated");
    chunks.push({
      name: String.fromCharCode(...bytes.subarray(at + 4, at + 8)),
      data: bytes.subarray(at + 8, at + 8 + length),
    });
    at += 12 + length;
  }
  return chunks;
}

function paeth(a, b, c) {
  const p = a + b - c,
    pa = Math.abs(p - a),
    pb = Math.abs(p - b),
    pc = Math.abs(p - c);
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

/// Takes the filters away; returns rows of bytes without the byte that names the filter.
function unfiltered(raw, rowBytes, height, step) {
  const rows = new Uint8Array(rowBytes * height);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (rowBytes + 1)];
    if (filter > 4) throw new Error("a row has an unknown filter");
    for (let x = 0; x < rowBytes; ++x) {
      const at = y * rowBytes + x;
      const left = x >= step ? rows[at - step] : 0,
        up = y > 0 ? rows[at - rowBytes] : 0;
      const both = x >= step && y > 0 ? rows[at - rowBytes - step] : 0;
      const guess = [0, left, up, (left + up) >> 1, filter === 4 ? paeth(left, up, both) : 0][filter];
      rows[at] = raw[y * (rowBytes + 1) + 1 + x] + guess;
    }
  }
  return rows;
}

/// A PNG as binary PPM of 8 or 16 bits, its values untouched; alpha is dropped, as raypro does. Null for interlaced
/// files, which are left to the browser.
export async function ppmOfPng(bytes) {
  const chunks = chunksOf(bytes),
    header = chunks[0];
  if (header?.name !== "IHDR" || header.data.length !== 13) throw new Error("the file does not start with its header");
  const view = new DataView(header.data.buffer, header.data.byteOffset);
  const width = view.getUint32(0),
    height = view.getUint32(4);
  const [depth, kind, , , interlaced] = header.data.subarray(8);
  if (interlaced) return null;
  if (width === 0 || height === 0 || width * height > mostPixels) throw new Error("the image is too large, or empty");
  const channels = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 }[kind];
  if (!channels || ![1, 2, 4, 8, 16].includes(depth)) throw new Error("the header is damaged");
  const packed = new Blob(chunks.filter((chunk) => chunk.name === "IDAT").map((chunk) => chunk.data));
  const raw = await through(new DecompressionStream("deflate"), await packed.arrayBuffer());
  const rowBytes = Math.ceil((width * channels * depth) / 8);
  if (raw.length < (rowBytes + 1) * height) throw new Error("the file is truncated");
  const rows = unfiltered(raw, rowBytes, height, Math.max(1, (channels * depth) / 8));
  const palette = chunks.find((chunk) => chunk.name === "PLTE")?.data;
  if (kind === 3 && !palette) throw new Error("the palette is missing");
  const wide = depth === 16 ? 2 : 1,
    isColor = kind === 2 || kind === 6;
  const head = new TextEncoder().encode(`P6\n${width} ${height}\n${wide === 2 ? 65535 : 255}\n`);
  const ppm = new Uint8Array(head.length + 3 * wide * width * height);
  ppm.set(head);
  const most = (1 << Math.min(depth, 8)) - 1;
  const value = (y, i) => {
    // of less than 8 bits, as it is
    if (depth >= 8) return rows[y * rowBytes + i];
    const bit = i * depth;
    return (rows[y * rowBytes + (bit >> 3)] >> (8 - depth - (bit & 7))) & most;
  };
  for (let y = 0, to = head.length; y < height; ++y)
    for (let x = 0; x < width; ++x)
      for (let c = 0; c < 3; ++c)
        for (let byte = 0; byte < wide; ++byte) {
          if (kind === 3) ppm[to++] = palette[3 * value(y, x) + c] ?? 0;
          else if (depth < 8) ppm[to++] = (value(y, x) * 255) / most;
          else ppm[to++] = rows[y * rowBytes + (x * channels + (isColor ? c : 0)) * wide + byte];
        }
  return ppm;
}

const crcs = Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n >>> 0;
});
const crcOf = (bytes) => ~bytes.reduce((crc, byte) => crcs[(crc ^ byte) & 255] ^ (crc >>> 8), ~0) >>> 0;

function chunk(name, data) {
  const bytes = new Uint8Array(12 + data.length),
    view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  bytes.set(new TextEncoder().encode(name), 4);
  bytes.set(data, 8);
  view.setUint32(8 + data.length, crcOf(bytes.subarray(4, 8 + data.length)));
  return bytes;
}

/// The rgba pixels of an opaque image as a PNG that keeps `settings`, ASCII, as raypro's do.
export async function pngOfRgba(rgba, width, height, settings = {}) {
  const raw = new Uint8Array((3 * width + 1) * height);
  for (let y = 0, to = 0, from = 0; y < height; ++y) {
    raw[to++] = 0;
    for (let x = 0; x < width; ++x, from += 4) for (let c = 0; c < 3; ++c) raw[to++] = rgba[from + c];
  }
  const header = new Uint8Array(13),
    view = new DataView(header.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  header.set([8, 2, 0, 0, 0], 8);
  const texts = Object.entries(settings).map(([key, value]) =>
    chunk("tEXt", new TextEncoder().encode(key + "\0" + value.replace(/[^\n\x20-\x7e]/g, "?"))),
  );
  return new Blob(
    [
      new Uint8Array(signature),
      chunk("IHDR", header),
      ...texts,
      chunk("IDAT", await through(new CompressionStream("deflate"), raw)),
      chunk("IEND", new Uint8Array(0)),
    ],
    { type: "image/png" },
  );
}
