// SPDX-License-Identifier: MIT
// The frames of the run. Each says what has changed since the one before, so that a frame is reached
// from the nearest mark before it, where everything was kept.

const kRunning = 0;
const kFrozen = 1;
const kDiscarded = 2;
const kHidden = 3; // waits for its fall to begin
const kMarks = 16;

/** An array as long as that, with what was in it. */
function grown(array, length) {
  if (array.length >= length) {
    return array;
  }
  const longer = new array.constructor(Math.max(length, 2 * array.length));
  longer.set(array);
  return longer;
}

/** The same arrays once more. */
const copied = (arrays) =>
  Object.fromEntries(Object.entries(arrays).map(([name, array]) => [name, array.slice()]));

class Film {
  constructor(sections) {
    this.times = numbersOf(Float64Array, sections.times);
    this.poses = numbersOf(Float64Array, sections.poses);
    this.numbers = facts.film.frames;
    this.frames = this.times.length;
    this.counts = Film.readCounts(sections, this.frames);
    this.cursors = {};
    for (const name of ["changes", "groups", "radii", "states", "x", "y", "z", "speeds", "columns"]) {
      this.cursors[name] = new Cursor(sections[name]);
    }
    this.at = -1; // frame that is shown
    this.spheres = 0;
    this.places = new Int32Array(0); // x, y, z of each
    this.gone = new Int32Array(0); // since the frame before
    this.radii = new Int32Array(0);
    this.groups = new Uint32Array(0);
    this.states = new Uint8Array(0);
    this.speeds = new Uint8Array(0);
    this.columns = {}; // carried ones by their names
    for (const { name, whole } of facts.film.columns) {
      this.columns[name] = whole ? new Uint32Array(0) : new Float32Array(0);
    }
    this.polygons = new Uint8Array(facts.triangles);
    this.renewed = [0, 0, 0, 0, 0]; // x, y, z, radius, group of the last one that was
    this.marks = [];
    this.markEvery = Math.max(8, Math.ceil(this.frames / kMarks));
  }

  /** Running, frozen, discarded and discarded polygons of each frame. */
  static readCounts(sections, frames) {
    const cursor = new Cursor(sections.counts);
    const changes = new Uint32Array(4 * frames);
    for (let i = 0; cursor.at < cursor.bytes.length; ++i) {
      changes[i] = cursor.count();
    }
    return changes;
  }

  countsAt(frame) {
    return this.counts.subarray(4 * frame, 4 * frame + 4);
  }

  /** The last frame that is not later than a time. */
  frameAt(time) {
    let low = 0;
    let high = this.frames - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.times[middle] <= time + 1e-12) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  seek(frame) {
    const mark = Math.min(Math.floor(frame / this.markEvery), this.marks.length - 1);
    if (frame < this.at || this.at < mark * this.markEvery) {
      this.restore(this.marks[mark]);
    }
    while (this.at < frame) {
      this.next();
    }
  }

  next() {
    const { changes } = this.cursors;
    ++this.at;
    if (changes.count() === 1) { // otherwise it shows the state of the frame before
      this.readState(changes);
    }
    if (this.at % this.markEvery === 0 && this.at / this.markEvery === this.marks.length) {
      this.marks.push(this.kept());
    }
  }

  readState(changes) {
    const before = this.spheres;
    this.resize(changes.count());
    const ran = this.states.slice(0, this.spheres);
    ran.fill(kHidden, Math.min(before, this.spheres));
    this.renew(changes.ids(), ran);
    for (const id of changes.ids()) {
      this.states[id] = this.cursors.states.count();
    }
    this.move(ran);
    for (const id of changes.ids()) {
      this.polygons[id] ^= 1;
    }
    this.fillColumns();
  }

  /** What has changed in carried columns. */
  fillColumns() {
    const { columns: cursor } = this.cursors;
    for (const { name, whole } of facts.film.columns) {
      const values = this.columns[name];
      const bits = new Uint32Array(values.buffer);
      for (const id of cursor.ids()) {
        bits[id] = whole ? values[id] + cursor.difference() : cursor.bits();
      }
    }
  }

  renew(ids, ran) {
    const { x, y, z, radii, groups, states } = this.cursors;
    const last = this.renewed;
    for (const id of ids) {
      last[0] += x.difference();
      last[1] += y.difference();
      last[2] += z.difference();
      last[3] += radii.difference();
      last[4] += groups.difference();
      this.places.set([last[0], last[1], last[2]], 3 * id);
      this.gone.fill(0, 3 * id, 3 * id + 3);
      this.radii[id] = last[3];
      this.groups[id] = last[4];
      this.states[id] = states.count();
      this.speeds[id] = 0;
      ran[id] = 255; // its place is known
    }
  }

  /** What runs, or ran until now, is expected to go on as before. */
  move(ran) {
    const axes = [this.cursors.x, this.cursors.y, this.cursors.z];
    for (let id = 0; id < this.spheres; ++id) {
      const runs = this.states[id] === kRunning;
      if (ran[id] !== 255 && (runs || ran[id] === kRunning)) {
        for (let axis = 0; axis < 3; ++axis) {
          const gone = this.gone[3 * id + axis] + axes[axis].difference();
          this.places[3 * id + axis] += gone;
          this.gone[3 * id + axis] = runs ? gone : 0;
        }
      }
      this.speeds[id] = runs ? this.speeds[id] + this.cursors.speeds.difference() : 0;
    }
  }

  resize(spheres) {
    this.places = grown(this.places, 3 * spheres);
    this.gone = grown(this.gone, 3 * spheres);
    this.radii = grown(this.radii, spheres);
    this.groups = grown(this.groups, spheres);
    this.states = grown(this.states, spheres);
    this.speeds = grown(this.speeds, spheres);
    for (const [name, values] of Object.entries(this.columns)) {
      this.columns[name] = grown(values, spheres).fill(0, Math.min(spheres, this.spheres));
    }
    this.spheres = spheres;
  }

  kept() {
    const mark = { at: this.at, spheres: this.spheres, cursors: {} };
    for (const name of ["places", "gone", "radii", "groups", "states", "speeds", "polygons",
      "renewed"]) {
      mark[name] = this[name].slice();
    }
    mark.columns = copied(this.columns);
    for (const [name, cursor] of Object.entries(this.cursors)) {
      mark.cursors[name] = cursor.at;
    }
    return mark;
  }

  restore(mark) {
    const { cursors, columns, ...rest } = mark;
    this.columns = copied(columns);
    for (const [name, value] of Object.entries(rest)) {
      this[name] = typeof value === "number" ? value : value.slice();
    }
    for (const [name, at] of Object.entries(cursors)) {
      this.cursors[name].at = at;
    }
  }

  /** The pose of the object in this frame: the rotation row by row and its offset. */
  pose() {
    return Array.from(this.poses.subarray(12 * this.at, 12 * this.at + 12));
  }
}
