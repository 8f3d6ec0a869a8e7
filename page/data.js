// SPDX-License-Identifier: MIT
// What the page holds: facts as JSON, shaders as text, and sections of bytes.
// All files of this folder are joined into one script, in the order of src/page/assemble.cpp.

const part = (id) => document.getElementById(id);
const facts = JSON.parse(part("facts").textContent);
const shaders = JSON.parse(part("shaders").textContent);

/** What cannot be shown, and why, in a sentence for the reader. */
class Unable extends Error {}

/** The bytes of base64 text, in pieces: a string of all of them would take the memory twice. */
function piecesOfBase64(text) {
  const pieces = [];
  const length = 1 << 20; // a multiple of four digits
  for (let at = 0; at < text.length; at += length) {
    const letters = atob(text.slice(at, at + length));
    const bytes = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; ++i) {
      bytes[i] = letters.charCodeAt(i);
    }
    pieces.push(bytes);
  }
  return pieces;
}

/** The sections of the page by their names: { x: Uint8Array, ... }. */
async function unpackSections() {
  if (typeof DecompressionStream === "undefined") {
    throw new Unable("This browser cannot unpack the run: it lacks DecompressionStream. " +
      "The page needs Chrome or Edge from version 111, Firefox from 113, or Safari from 16.4.");
  }
  const text = part("sections").textContent;
  part("sections").textContent = "";
  const stream = new Blob(piecesOfBase64(text)).stream()
    .pipeThrough(new DecompressionStream("deflate"));
  const all = await new Response(stream).arrayBuffer();
  const sections = {};
  let at = 0;
  for (const [name, size] of facts.sections) {
    sections[name] = new Uint8Array(all, at, size);
    at += size;
  }
  return sections;
}

/** A section as numbers of a typed array, which wants them where it can address them. */
function numbersOf(Type, bytes) {
  return new Type(bytes.slice().buffer);
}

/** Reads counts and differences: seven bits a byte, the lowest first; signs are folded in. */
class Cursor {
  constructor(bytes, at = 0) {
    this.bytes = bytes;
    this.at = at;
  }

  count() {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = this.bytes[this.at++];
      value |= (byte & 127) << shift;
      if (byte < 128) {
        return value >>> 0;
      }
    }
  }

  difference() {
    const folded = this.count();
    return (folded >>> 1) ^ -(folded & 1);
  }

  /** A number of four bytes. */
  float() {
    this.at += 4;
    return new DataView(this.bytes.buffer, this.bytes.byteOffset).getFloat32(this.at - 4, true);
  }

  /** A count, and for each id its distance from the one before. */
  ids() {
    const ids = new Uint32Array(this.count());
    let id = 0;
    for (let i = 0; i < ids.length; ++i) {
      id += this.count();
      ids[i] = id;
    }
    return ids;
  }
}
