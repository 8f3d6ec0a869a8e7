// Runs the parts of a page's script that need no browser in Node.js: frames, camera and colours. They are
// compared with oracle.json, which the run file's own reader wrote, and with formulas.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

const folder = process.argv[2];
const page = readFileSync(`${folder}/view.html`, "utf8");
const oracle = JSON.parse(readFileSync(`${folder}/oracle.json`, "utf8"));

/** The text of an element of the page. */
const elements = {};
for (const [, id, text] of page.matchAll(/<script id="(\w+)"[^>]*>(.*?)<\/script>/gs)) {
  elements[id] = { textContent: text };
}
globalThis.document = { getElementById: (id) => elements[id] };

// The script is made of files that begin alike; the first four ask the browser for nothing else.
const script = page.match(/<script type="module">(.*?)<\/script>/s)[1];
const files = script.split("// SPDX-License-Identifier: MIT\n").slice(1, 5);
const { facts, unpackSections, Film, Camera, poseMatrix, coloursOf, stateWord } = new Function(
  `${files.join("")}; return { facts, unpackSections, Film, Camera, poseMatrix, coloursOf, stateWord };`)();

const sections = await unpackSections();
const film = new Film(sections);
const near = (a, b, error, what) => assert.ok(Math.abs(a - b) <= error, `${what}: ${a}, not ${b}`);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);

/** What the frame has to show, with the states of the page: 3 waits. */
function wanted(frame) {
  const { centres = [], radii = [], states = [], waiting = [], speeds = [] } = frame;
  return { centres, radii, groups: frame.groups ?? [],
    states: (states ?? []).map((state, i) => waiting[i] ? 3 : state),
    speeds: (speeds ?? []).map((speed, i) => waiting[i] ? 0 : Math.min(speed, facts.film.fastest)) };
}

/** A place of the film in the world, as snapshot.hpp says. */
function inWorld(id, pose) {
  const p = [0, 1, 2].map((axis) => facts.film.step * film.places[3 * id + axis]);
  return [0, 1, 2].map((row) =>
    facts.origin[row] + pose[9 + row] + dot(pose.slice(3 * row, 3 * row + 3), p));
}

/** A point of unit space, moved by a matrix that lies column by column. */
const moved = (m, p) => [0, 1, 2].map((row) =>
  m[row] * p[0] + m[4 + row] * p[1] + m[8 + row] * p[2] + m[12 + row]);

function checkFrame(index) {
  film.seek(index);
  const frame = oracle.frames[index];
  const shown = wanted(frame);
  const n = shown.states.length;
  assert.equal(film.spheres, n);
  assert.deepEqual(Array.from(film.states.subarray(0, n)), shown.states);
  assert.deepEqual(Array.from(film.values.group.subarray(0, n)), shown.groups);
  assert.deepEqual(Array.from(film.polygons), frame.polygons);
  assert.equal(film.times[index], frame.time);
  const count = (state) => shown.states.filter((each) => each === state).length;
  assert.deepEqual(Array.from(film.countsAt(index)),
    [count(0), count(1), count(2), dot(frame.polygons, frame.polygons)]);
  const pose = film.pose();
  for (let i = 0; i < n; ++i) {
    near(film.values.radius[i] * facts.film.radius_step, shown.radii[i], facts.film.radius_step / 2, "radius");
    near(film.values.speed[i] / 255 * facts.film.fastest, shown.speeds[i], facts.film.fastest / 509, "speed");
    // Rounded along the mesh's axes, so by half a step along each, whichever way they are turned.
    const world = inWorld(i, pose);
    for (let axis = 0; axis < 3; ++axis) {
      near(world[axis], shown.centres[i][axis], facts.film.step / 2 * Math.sqrt(3), "place");
    }
    // The matrix for the shaders moves the place to the same point of unit space.
    const unit = (p) => p.map((x, axis) => (x - facts.centre[axis]) * facts.scale_of_unit);
    const place = [0, 1, 2].map((axis) => facts.origin[axis] + facts.film.step * film.places[3 * i + axis]);
    moved(poseMatrix(pose), unit(place)).forEach((x, axis) =>
      near(x, unit(world)[axis], 1e-12, "place in the picture"));
  }
}

// Forwards, then in an order that leads back to marks.
const frames = oracle.frames.length;
for (let index = 0; index < frames; ++index) {
  checkFrame(index);
}
for (let i = 0; i < frames; ++i) {
  checkFrame((i * 37 + 5) % frames);
}

// The frame of a time is the last one that is not later.
for (let index = 0; index < frames; ++index) {
  const { time } = oracle.frames[index];
  const last = oracle.frames.findLastIndex((frame) => frame.time <= time);
  assert.equal(film.frameAt(time), last);
  assert.equal(film.frameAt((time + (oracle.frames[last + 1]?.time ?? time + 1)) / 2), last);
}

// Colours are the bytes red, green, blue, 255, in this order in memory.
film.seek(frames - 1);
const look = facts.looks[facts.look];
const colourBytesOf = (by) => {
  const colourOf = coloursOf(film, by, look);
  return new Uint8Array(Uint32Array.from({ length: film.spheres }, (_, id) => colourOf(id)).buffer);
};
const names = ["running", "frozen", "discarded", "running"];
let bytes = colourBytesOf("state");
for (let i = 0; i < film.spheres; ++i) {
  assert.deepEqual(Array.from(bytes.subarray(4 * i, 4 * i + 4)),
    [...look[names[film.states[i]]].slice(0, 3), 255]);
}
const ofGroups = facts.colours.find(({ by }) => by === "group");
bytes = colourBytesOf("group");
for (let i = 0; i < film.spheres; ++i) {
  const share = Math.min(1, film.values.group[i] / ofGroups.high);
  assert.deepEqual(Array.from(bytes.subarray(4 * i, 4 * i + 3)),
    facts.scale[Math.round(255 * share)].slice(0, 3));
}

// In a window of any shape the whole object is in the picture, and touches its margin on one side.
const points = oracle.vertices.flatMap((vertex) =>
  vertex.map((x, axis) => (x - facts.centre[axis]) * facts.scale_of_unit));
const still = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
for (const aspect of [0.4, 1, 2.5]) {
  const camera = new Camera(points);
  camera.resize(aspect);
  const { view, projection } = camera.look(still);
  let widest = 0;
  for (let i = 0; i < points.length && facts.poses.length === 0; i += 3) {
    const [x, y, z] = moved(view, points.slice(i, i + 3));
    assert.ok(z < 0, "behind the camera");
    widest = Math.max(widest, Math.abs(projection[0] * x / z), Math.abs(projection[5] * y / z));
  }
  assert.ok(facts.poses.length > 0 || Math.abs(widest - 0.96) < 0.001, `${widest} at ${aspect}`);
}
console.log(`${frames} frames in two orders`);

// A quarter about z turns the axis of stripes from x to y: 127 times it are bytes above the state.
const half = Math.SQRT1_2;
const quarter = { states: [1, 2], values: { qx: [0, 0], qy: [0, 0], qz: [0, half], qw: [1, half] } };
const bytesOf = (word) => [word & 255, word << 16 >> 24, word << 8 >> 24, word >> 24];
assert.deepEqual(bytesOf(stateWord(quarter, 0)), [1, 102, 46, 61]);
assert.deepEqual(bytesOf(stateWord(quarter, 1)), [2, -46, 102, 61]);
assert.equal(stateWord({ states: [2], values: {} }, 0), 2);
