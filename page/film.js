// SPDX-License-Identifier: MIT
// The frames of the run, as docs/run-file.md describes them. Each says what has changed since the one
// before, so that a frame is reached from the nearest mark before it, where everything was kept.

const kRunning = 0;
const kFrozen = 1;
const kDiscarded = 2;
const kWaits = 3; // for its fall to begin: not drawn
const kHasPose = 1; // in the flags of a frame
const kIsRepeated = 2;
const kStill = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
const kCheckpoints = 16;

/** An array as long as that, with what was in it. */
function grown(array, length) {
  if (array.length >= length) {
    return array;
  }
  const longer = new array.constructor(Math.max(length, 2 * array.length));
  longer.set(array);
  return longer;
}

class Film {
  constructor(sections) {
    this.numbers = facts.film.frames;
    this.frames = this.numbers.length;
    this.readFacts(sections);
    this.columns = Object.entries(facts.film.columns); // [name, when it changes]
    this.carried = Object.entries(facts.film.carried); // [name, its stream and whether it counts]
    const names = this.columns.map(([name]) => name);
    const streams = this.carried.map(([, { stream }]) => stream);
    this.cursors = {};
    for (const name of ["changes", "state", "x", "y", "z", ...names, ...streams]) {
      this.cursors[name] = new Cursor(sections[name] ?? []);
    }
    this.at = -1; // frame that is shown
    this.spheres = 0;
    this.places = new Int32Array(0); // x, y, z of each
    this.gone = new Int32Array(0); // since the frame before
    this.states = new Uint8Array(0);
    this.values = Object.fromEntries(names.map((name) => [name, new Int32Array(0)]));
    for (const [name, { whole }] of this.carried) {
      this.values[name] = whole ? new Uint32Array(0) : new Float32Array(0);
    }
    this.polygons = new Uint8Array(facts.triangles);
    this.renewed = {}; // x, y, z and values of the last one that was
    this.checkpoints = [];
    this.checkpointEvery = Math.max(8, Math.ceil(this.frames / kCheckpoints));
  }

  /** Of each frame its time, its pose, its counts and whether it shows the state of the one before. */
  readFacts(sections) {
    const frames = new Cursor(sections.frames);
    const [times, poses] = [sections.times, sections.poses ?? []].map((bytes) =>
      Array.from(numbersOf(Float64Array, bytes)).reverse());
    this.times = [];
    this.poses = [];
    this.repeats = [];
    this.counts = []; // steps, set, running, frozen, discarded and discarded polygons
    for (let i = 0; i < this.frames; ++i) {
      const flags = frames.count();
      this.repeats.push(flags === kIsRepeated);
      const isNew = flags !== kIsRepeated;
      this.times.push(isNew ? times.pop() : this.times[i - 1]);
      this.counts.push(isNew ? Array.from({ length: 6 }, (_, k) =>
        (this.counts[i - 1]?.[k] ?? 0) + frames.difference()) : this.counts[i - 1]);
      this.poses.push(!isNew ? this.poses[i - 1]
        : flags === kHasPose ? Array.from({ length: 12 }, () => poses.pop()) : kStill);
    }
  }

  /** Running, frozen, discarded and discarded polygons of a frame. */
  countsAt(frame) {
    return this.counts[frame].slice(2);
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
    const checkpoint = Math.min(Math.floor(frame / this.checkpointEvery), this.checkpoints.length - 1);
    if (frame < this.at || this.at < checkpoint * this.checkpointEvery) {
      this.restore(this.checkpoints[checkpoint]);
    }
    while (this.at < frame) {
      this.next();
    }
  }

  next() {
    if (!this.repeats[++this.at]) {
      this.readState(this.cursors.changes);
    }
    if (this.at % this.checkpointEvery === 0 && this.at / this.checkpointEvery === this.checkpoints.length) {
      this.checkpoints.push(this.kept());
    }
  }

  readState(changes) {
    const before = this.spheres;
    this.resize(changes.count());
    const ran = this.states.slice(0, this.spheres);
    ran.fill(kWaits, Math.min(before, this.spheres));
    this.renew(changes.ids(), ran);
    for (const id of changes.ids()) {
      this.states[id] = this.cursors.state.count();
    }
    this.move(ran);
    for (const id of changes.ids()) {
      this.polygons[id] ^= 1;
    }
    this.readValues();
  }

  /** The number that follows the one of the sphere renewed before. */
  ofRenewed(name) {
    this.renewed[name] = (this.renewed[name] ?? 0) + this.cursors[name].difference();
    return this.renewed[name];
  }

  renew(ids, ran) {
    for (const id of ids) {
      this.places[3 * id] = this.ofRenewed("x");
      this.places[3 * id + 1] = this.ofRenewed("y");
      this.places[3 * id + 2] = this.ofRenewed("z");
      this.gone.fill(0, 3 * id, 3 * id + 3);
      for (const [name, changes] of this.columns) {
        this.values[name][id] = changes === "never" ? this.ofRenewed(name) : 0;
      }
      this.states[id] = this.cursors.state.count();
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
    }
  }

  readValues() {
    for (const [name, { stream, whole }] of this.carried) {
      const values = this.values[name];
      const cursor = this.cursors[stream];
      for (const id of cursor.ids()) {
        values[id] = whole ? values[id] + cursor.difference() : cursor.float();
      }
    }
    for (const [name, changes] of this.columns) {
      const values = this.values[name];
      for (let id = 0; changes === "running" && id < this.spheres; ++id) {
        const runs = this.states[id] === kRunning;
        values[id] = runs ? values[id] + this.cursors[name].difference() : 0;
      }
    }
  }

  resize(spheres) {
    this.places = grown(this.places, 3 * spheres);
    this.gone = grown(this.gone, 3 * spheres);
    this.states = grown(this.states, spheres);
    for (const [name] of this.columns) {
      this.values[name] = grown(this.values[name], spheres);
    }
    for (const [name] of this.carried) {
      this.values[name] = grown(this.values[name], spheres).fill(0, Math.min(spheres, this.spheres));
    }
    this.spheres = spheres;
  }

  kept() {
    const checkpoint = { cursors: {} };
    for (const name of ["at", "spheres", "places", "gone", "states", "values", "polygons", "renewed"]) {
      checkpoint[name] = structuredClone(this[name]);
    }
    for (const [name, cursor] of Object.entries(this.cursors)) {
      checkpoint.cursors[name] = cursor.at;
    }
    return checkpoint;
  }

  restore(checkpoint) {
    const { cursors, ...rest } = checkpoint;
    Object.assign(this, structuredClone(rest));
    for (const [name, at] of Object.entries(cursors)) {
      this.cursors[name].at = at;
    }
  }

  /** The pose of the object in this frame: the rotation row by row and its offset. */
  pose() {
    return this.poses[this.at];
  }
}

/** A sphere's state, and above it an axis that turns with it, as src/render/picture/sphere_draw_list.cpp has it. */
function stateWord({ states, values: { qx, qy, qz, qw } }, id) {
  if (!(qx && qy && qz && qw)) {
    return states[id];
  }
  const around = [qx[id], qy[id], qz[id]];
  const twice = scaled(cross(around, facts.stripe_axis), 2);
  const axis = normalized(sum(facts.stripe_axis, sum(scaled(twice, qw[id]), cross(around, twice))));
  return axis.reduce((word, x, i) => word | (Math.round(127 * x) & 255) << 8 * (i + 1), states[id]) >>> 0;
}

/** Puts centre and radius of a sphere of the film into an array, from a place on. */
function putInUnitSpace({ places, values }, id, spheres, at) {
  const { film: { step, radius_step: radiusStep }, scale_of_unit: scale, origin, centre } = facts;
  for (let axis = 0; axis < 3; ++axis) {
    spheres[at + axis] = scale * (origin[axis] - centre[axis] + step * places[3 * id + axis]);
  }
  spheres[at + 3] = scale * radiusStep * values.radius[id];
}
