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

// The script is made of files that begin alike; the first seven ask the browser for nothing else.
const script = page.match(/<script type="module">(.*?)<\/script>/s)[1];
const files = script.split("// SPDX-License-Identifier: MIT\n").slice(1, 8);
const { facts, unpackSections, Cursor, Film, Camera, Hidden, SphereOcclusion, SphereGrid, StudioShadows, poseMatrix,
  colourSpheres, stateWord } = new Function(`${files.join("")}; return { facts, unpackSections, Cursor, Film, Camera, Hidden,
    SphereOcclusion, SphereGrid, StudioShadows, poseMatrix, colourSpheres, stateWord };`)();

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
const colours = new Uint32Array(film.spheres);
const look = facts.looks[facts.look];
colourSpheres(film, "state", look, colours);
const names = ["running", "frozen", "discarded", "running"];
const bytes = new Uint8Array(colours.buffer);
for (let i = 0; i < film.spheres; ++i) {
  assert.deepEqual(Array.from(bytes.subarray(4 * i, 4 * i + 4)),
    [...look[names[film.states[i]]].slice(0, 3), 255]);
}
const ofGroups = facts.colours.find(({ by }) => by === "group");
colourSpheres(film, "group", look, colours);
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

// Nothing is left out that a ray meets first, in whichever point of a pixel; and most of a heap is.
function checkHidden(cut, size) {
  let seed = 1;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const count = 3000;
  const spheres = new Float32Array(4 * count).map((_, k) =>
    k % 4 === 3 ? 0.02 + 0.06 * random() : 2 * random() - 1);
  const view = [1, 0, 0, 0, 0, 0.8, -0.6, 0, 0, 0.6, 0.8, 0, 0, 0.1, -4, 1];
  const projection = [2.1, 0, 0, 0, 0, 2.8, 0, 0, 0.1, -0.05, -1.5, -1, 0, 0, -6, 0];
  const planes = cut ? [0, 0, 1, 4, 0, 0, 1, 4] : null; // nearer than 4 is taken away
  const hidden = new Hidden();
  const seen = new Set(hidden.seenOf(spheres, count, { view, projection }, size, planes));
  assert.ok(seen.size < (size[0] > 200 ? 0.7 : 0.9) * count && seen.size > 0.05 * count, `${seen.size} of ${count} are seen`);
  const centres = Array.from({ length: count }, (_, i) => moved(view, spheres.subarray(4 * i, 4 * i + 3)));
  for (let ray = 0; ray < 4000; ++ray) {
    const x = (2 * random() - 1 + projection[8]) / projection[0];
    const y = (2 * random() - 1 + projection[9]) / projection[5];
    const along = [x, y, -1];
    let nearest = Infinity;
    let first = -1;
    for (let i = 0; i < count; ++i) {
      const radius = spheres[4 * i + 3];
      const a = dot(along, along);
      const b = dot(along, centres[i]);
      const left = b * b - a * (dot(centres[i], centres[i]) - radius * radius);
      const [enter, leave] = left > 0 ? [(b - Math.sqrt(left)) / a, (b + Math.sqrt(left)) / a] : [1, 0];
      const at = cut ? Math.max(enter, 4) : enter; // -z > 4 stays
      if (at < leave && at < nearest) {
        nearest = at;
        first = i;
      }
    }
    assert.ok(first < 0 || seen.has(first), `sphere ${first} is left out, and ray ${ray} meets it`);
  }
}
for (const size of [[320, 240], [128, 96]]) {
  checkHidden(false, size);
  checkHidden(true, size);
}

// One that begins behind another, and bulges out of it before its middle, is seen beside it.
const bulge = new Hidden().seenOf(Float32Array.of(0, 0, 0, 1, 0.34, 0, 0.485, 0.5), 2,
  { view: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -40, 1],
    projection: [21, 0, 0, 0, 0, 28, 0, 0, 0, 0, -1, -1, 0, 0, -2, 0] }, [320, 240], null);
assert.equal(bulge.length, 2);

// What keeps light off is found as if all spheres were looked at, and what is remembered is as if it were found
// anew, whatever has come, gone or moved since, and in whichever part of the frames it was asked for.
class LooksAtAll extends SphereGrid {
  eachAround(sphere, close, ray, farthest, wide, visit) {
    this.inCells.forEach((at) => visit(at));
  }
}

function checkOcclusion(cut) {
  let seed = 7;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const count = 150;
  const ids = Uint32Array.from({ length: count }, (_, i) => 2 * i + 1);
  const spheres = new Float32Array(4 * count).map((_, k) =>
    k % 4 === 3 ? 0.03 + 0.05 * random() : 1.2 * random() - 0.6);
  const states = new Uint8Array(count).map(() => 3 * random());
  const remembers = new SphereOcclusion();
  let kept = 0;
  let dark = 0;
  for (let frame = 0; frame < 60; ++frame) {
    for (let change = 0; change < 3 && frame > 0; ++change) {
      const i = Math.floor(count * random());
      states[i] = (states[i] + 1) % 3; // comes to rest, is discarded or runs
      spheres[4 * i + change] += states[i] === 0 ? 0.1 : 0;
    }
    const isCut = (at) => cut && spheres[4 * at] > 0.3 + 0.004 * frame;
    remembers.follow(ids, spheres, states, count, isCut);
    kept += remembers.known.reduce((sum, one) => sum + one, 0);
    const anew = new SphereOcclusion();
    anew.follow(ids, spheres, states, count, isCut);
    Object.setPrototypeOf(anew.grid, LooksAtAll.prototype);
    for (let i = frame % 2; i < count; i += 2) {
      const sphere = spheres.subarray(4 * i, 4 * i + 4);
      const light = Array.from(remembers.lightOf(ids[i], sphere));
      assert.deepEqual(light, Array.from(anew.lightOf(ids[i], sphere)), `sphere ${i} in frame ${frame}`);
      dark += light[3] > 0 ? 1 : 0;
    }
  }
  assert.ok(dark > 1000, `only ${dark} have neighbours`);
  assert.ok(cut || kept > 500, `only ${kept} lights are remembered`);
}
checkOcclusion(false);
checkOcclusion(true);

// Lights are those of pictures, but for the last digit: C++ rounds to floats on the way.
const studio = JSON.parse(readFileSync(`${folder}/studio.json`, "utf8"));
function checkLights({ lamp, cut_from: cutFrom, spheres, states, lights }) {
  const before = facts.studio.lamp;
  facts.studio.lamp = lamp;
  const flat = Float32Array.from(spheres.flat());
  const ids = Uint32Array.from(spheres.keys());
  const occlusion = new SphereOcclusion();
  occlusion.follow(ids, flat, Uint8Array.from(states), ids.length, (at) => flat[4 * at] > cutFrom);
  const apart = [];
  for (const id of ids) {
    const light = Array.from(occlusion.lightOf(id, flat.subarray(4 * id, 4 * id + 4)));
    const [told, open] = lights[id];
    const wanted = [...told.flat(), ...open.slice(0, 2)];
    apart.push(Math.max(...wanted.map((number, i) => Math.abs(number - (i < 48 ? light[i] : light[i] & 255)))));
  }
  facts.studio.lamp = before;
  // Two neighbours that weigh the same to the last digit may change places.
  assert.ok(apart.filter((most) => most > 1).length <= 2, `${apart.filter((most) => most > 1).length} lights differ`);
}
checkLights(studio.light);

// Walls are dark where they are in pictures, also in a frame in which spheres that rest in the end still fall.
function checkContacts({ eye, frames: some }) {
  const shadows = Object.create(StudioShadows.prototype);
  shadows.contacts = shadows.readContacts(new Cursor(sections.walls));
  for (const { index, shadows: wanted } of some) {
    film.seek(index);
    const corners = shadows.cornersOfContacts({ eyeOfObject: eye }, film, () => true);
    const ours = [];
    for (let at = 0; at < corners.length; at += 54) {
      const vertex = (k) => corners.slice(at + 9 * k, at + 9 * k + 9);
      const [a, b, z] = [vertex(0), vertex(1), vertex(5)];
      ours.push([...[0, 1, 2].map((i) => (a[i] + z[i]) / 2), ...[0, 1, 2].map((i) => (b[i] - a[i]) / 2),
        ...a.slice(5)]);
    }
    const dark = (shadow) => shadow[9] > 0.05;
    const isLike = (one) => (other) => one.every((x, i) => Math.abs(x - other[i]) < (i < 6 ? 0.002 : 0.04));
    console.log(`${wanted.filter(dark).length} walls are dark in frame ${index}`);
    assert.ok(wanted.filter(dark).length > 0, "nothing to compare");
    for (const [some, others] of [[wanted, ours], [ours, wanted]]) {
      const alone = some.filter(dark).filter((one) => !others.some(isLike(one)));
      assert.equal(alone.length, 0, `${alone.length} of ${some.length} shadows in frame ${index}: ${alone[0]}`);
    }
  }
}
if (studio.contacts) {
  checkContacts(studio.contacts);
}

// A quarter about z turns the axis of stripes from x to y: 127 times it are bytes above the state.
const half = Math.SQRT1_2;
const quarter = { states: [1, 2], values: { qx: [0, 0], qy: [0, 0], qz: [0, half], qw: [1, half] } };
const bytesOf = (word) => [word & 255, word << 16 >> 24, word << 8 >> 24, word >> 24];
assert.deepEqual(bytesOf(stateWord(quarter, 0)), [1, 102, 46, 61]);
assert.deepEqual(bytesOf(stateWord(quarter, 1)), [2, -46, 102, 61]);
assert.equal(stateWord({ states: [2], values: {} }, 0), 2);
