// Series as packed.h packs them.
function packedBytes(text) {
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return bytes.buffer;
}

function unpacked(packed) {
  const parts = new Int16Array(packedBytes(packed.data)), values = new Float64Array(parts.length);
  for (let i = 0; i < parts.length; i++)
    values[i] = parts[i] === -32768 ? NaN : packed.offset + parts[i] * packed.unit;
  return values;
}
