// SPDX-License-Identifier: MIT
// What keeps light from spheres in the studio: all that are at rest and that no cut takes away, as in
// src/render/picture/sphere_occlusion.cpp, whose numbers are in facts.studio. Lengths are in unit space.

const kListed = 12; // neighbours that a sphere is told of
const kTexels = kListed + 1; // of a sphere: they, and what all others let through

class SphereOcclusion {
  constructor() {
    this.keepers = new Float32Array(0); // by id: centre and radius, which is 0 where no light is kept off
    this.before = new Float32Array(0); // the same until follow was called
    this.known = new Uint8Array(0); // by id: whether its light is that of now
    this.lights = new Int8Array(0); // by id: 4 * kTexels numbers
    this.length = 0; // of what is known by id
  }

  /** Takes the spheres of a frame, of which `isCut` takes those away for which it is true. */
  follow(ids, spheres, states, count, isCut) {
    const length = count > 0 ? Math.max(this.length, ids[count - 1] + 1) : this.length;
    [this.before, this.keepers] = [grown(this.keepers, 4 * length), grown(this.before, 4 * length)];
    this.keepers.fill(0);
    this.known = grown(this.known, length);
    this.lights = grown(this.lights, 4 * kTexels * length);
    this.length = length;
    for (let at = 0; at < count; ++at) {
      if (states[at] !== kRunning && !isCut(at)) {
        for (let k = 0; k < 4; ++k) {
          this.keepers[4 * ids[at] + k] = spheres[4 * at + k];
        }
      } else {
        this.known[ids[at]] = 0; // forget finds only what keeps light off itself
      }
    }
    this.forget();
  }

  /** Forgets the light of spheres that others keep it from which have come, or gone. */
  forget() {
    const { before, keepers } = this;
    const changed = [];
    for (let at = 0; at < 4 * this.length; at += 4) {
      if (before[at] !== keepers[at] || before[at + 1] !== keepers[at + 1] ||
        before[at + 2] !== keepers[at + 2] || before[at + 3] !== keepers[at + 3]) {
        changed.push(...[before, keepers].map((array) => array.subarray(at, at + 4)).filter((s) => s[3] > 0));
        this.known[at / 4] = 0;
      }
    }
    if (changed.length === 0) {
      return;
    }
    this.grid = new SphereGrid(keepers, this.length);
    if (changed.length > this.length / 8) {
      this.known.fill(0);
      return;
    }
    const { reach, lamp, lamp_reach: lampReach } = facts.studio;
    for (const sphere of changed) {
      // The other way round than in lightOf: who would find this one there.
      const { largest } = this.grid;
      this.grid.eachAround(sphere, (1 + reach) * largest + sphere[3], scaled(lamp, -1), lampReach * largest,
        largest + sphere[3], (at) => { this.known[at / 4] = 0; });
    }
  }

  /** The light of a sphere as numbers of a texture: kTexels times four. */
  lightOf(id, sphere) {
    const from = 4 * kTexels * id;
    const light = this.lights.subarray(from, from + 4 * kTexels);
    if (this.known[id] === 0) {
      this.find(sphere, light);
      this.known[id] = 1;
    }
    return light;
  }

  find(sphere, light) {
    light.fill(0);
    const near = this.neighboursOf(sphere);
    const byte = (share) => Math.round(127 * Math.min(1, Math.max(-1, share)));
    near.slice(0, kListed).forEach(({ way, radius }, i) => {
      // What is too large to be told is brought nearer: it hides as much.
      const size = Math.max(...way.map(Math.abs), radius, facts.studio.occluder_range);
      light.set([...way, radius].map((number) => byte(number / size)), 4 * i);
    });
    let sky = 1;
    let left = 1;
    for (const { way, radius, ahead } of near.slice(kListed)) {
      const squared = dot(way, way);
      sky *= 1 - 0.25 * Math.min(radius * radius / squared, 1);
      if (ahead > 0) {
        left *= 1 - lampHidden(ahead, Math.sqrt(Math.max(squared - ahead * ahead, 0)), radius);
      }
    }
    light.set([sky, left].map((share) => Math.round(255 * share)), 4 * kListed);
  }

  /** What hides anything from a sphere, that which hides most first. Lengths in its radius. */
  neighboursOf(sphere) {
    const near = [];
    if (!this.grid) {
      return near;
    }
    const { keepers } = this;
    const { reach, lamp, lamp_reach: lampReach, lamp_softness: softness } = facts.studio;
    const [x, y, z, own] = sphere;
    const { largest } = this.grid;
    this.grid.eachAround(sphere, (1 + reach) * own + largest, lamp, lampReach * own, own + largest, (at) => {
      const a = (keepers[at] - x) / own;
      const b = (keepers[at + 1] - y) / own;
      const c = (keepers[at + 2] - z) / own;
      const radius = keepers[at + 3] / own;
      const squared = a * a + b * b + c * c;
      const ahead = a * lamp[0] + b * lamp[1] + c * lamp[2];
      const wide = 1 + radius + softness * Math.max(ahead, 0);
      let weight = squared < (1 + reach + radius) ** 2 ? radius * radius / squared : 0;
      if (ahead > 0 && ahead < lampReach && squared - ahead * ahead < wide * wide) {
        weight += 0.5 * radius * radius / (1 + ahead);
      }
      if (weight > 0 && squared > 1e-6) { // else it is itself
        near.push({ weight, way: [a, b, c], radius, ahead });
      }
    });
    return near.sort((a, b) => b.weight - a.weight);
  }
}

/** Of the lamp that a neighbour hides, seen from the sphere as a whole. */
function lampHidden(ahead, beside, radius) {
  const spread = 1 + facts.studio.lamp_softness * ahead;
  return Math.min(1, Math.max(0, (radius + spread - beside) / (2 * spread))) *
    Math.min(radius * radius / (spread * spread) * 1.5, 1);
}

/** Lights of spheres in the order in which they are drawn, as sphere.vert reads them. */
class LightTexture {
  constructor(gl) {
    this.gl = gl;
    this.texture = gl.createTexture();
    this.texels = new Int8Array(0);
  }

  /** `lightOf(k)`: kTexels times four numbers. */
  fill(count, lightOf) {
    const { gl } = this;
    const width = kTexels * 128;
    const height = Math.max(1, Math.ceil(count / 128));
    this.texels = grown(this.texels, 4 * width * height);
    for (let k = 0; k < count; ++k) {
      this.texels.set(lightOf(k), 4 * kTexels * k);
    }
    this.bind();
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8I, width, height, 0, gl.RGBA_INTEGER, gl.BYTE, this.texels);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
      gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST); // whole numbers have no others
    }
  }

  bind() {
    this.gl.bindTexture(this.gl.TEXTURE_2D, this.texture);
  }
}

/** Spheres by the cells of a grid in which their centres are; those of radius 0 are not there. */
class SphereGrid {
  constructor(spheres, count) {
    this.low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    this.largest = 0;
    let there = 0;
    this.spheres = spheres;
    this.each(count, (at) => {
      ++there;
      this.largest = Math.max(this.largest, spheres[at + 3]);
      for (let axis = 0; axis < 3; ++axis) {
        this.low[axis] = Math.min(this.low[axis], spheres[at + axis]);
        high[axis] = Math.max(high[axis], spheres[at + axis]);
      }
    });
    const edges = difference(high, this.low);
    // Not many more cells than spheres.
    this.cell = there === 0 ? 1 : Math.max(2 * this.largest, Math.cbrt(edges[0] * edges[1] * edges[2] / there),
      Math.max(...edges) / 1000);
    this.size = there === 0 ? [0, 0, 0] : edges.map((edge) => Math.floor(edge / this.cell) + 1);
    this.starts = new Uint32Array(this.size[0] * this.size[1] * this.size[2] + 1);
    this.each(count, (at) => ++this.starts[this.cellOf(at) + 1]);
    for (let cell = 1; cell < this.starts.length; ++cell) {
      this.starts[cell] += this.starts[cell - 1];
    }
    const next = this.starts.slice();
    this.inCells = new Uint32Array(there);
    this.each(count, (at) => { this.inCells[next[this.cellOf(at)]++] = at; });
  }

  each(count, visit) {
    for (let at = 0; at < 4 * count; at += 4) {
      if (this.spheres[at + 3] > 0) {
        visit(at);
      }
    }
  }

  cellOf(at) {
    const [x, y, z] = [0, 1, 2].map((axis) => this.index(axis, this.spheres[at + axis]));
    return (z * this.size[1] + y) * this.size[0] + x;
  }

  index(axis, place) {
    return Math.min(this.size[axis] - 1, Math.max(0, Math.floor((place - this.low[axis]) / this.cell)));
  }

  /** Visits what may be near a sphere, or around a ray from it that widens as the lamp is soft. */
  eachAround(sphere, close, ray, farthest, wide, visit) {
    if (this.inCells.length === 0) {
      return;
    }
    const atEnd = wide + facts.studio.lamp_softness * farthest;
    const end = [0, 1, 2].map((axis) => sphere[axis] + farthest * ray[axis]);
    const [low, high] = [-1, 1].map((side) => [0, 1, 2].map((axis) => this.index(axis,
      side * Math.max(side * sphere[axis] + close, side * end[axis] + atEnd))));
    for (let z = low[2]; z <= high[2]; ++z) {
      for (let y = low[1]; y <= high[1]; ++y) {
        const row = (z * this.size[1] + y) * this.size[0];
        for (let k = this.starts[row + low[0]]; k < this.starts[row + high[0] + 1]; ++k) {
          visit(this.inCells[k]);
        }
      }
    }
  }
}
