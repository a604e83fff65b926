/// Decompression of the data that the page has as compressed bytes (docs/results.md).

/// The bytes of a text: base64 of a stream of zlib.
export async function unpackedBytes(text) {
  const compressed = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
  const stream = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/// The numbers of a column: two bytes each, from 0 for the smallest number to 65535 for the largest.
export async function unpackedNumbers({from, to, values}) {
  const bytes = await unpackedBytes(values);
  const numbers = new Float64Array(bytes.length / 2);
  for (let i = 0; i < numbers.length; ++i) {
    numbers[i] = from + (to - from) * (bytes[2 * i] + 256 * bytes[2 * i + 1]) / 65535;
  }
  return numbers;
}
