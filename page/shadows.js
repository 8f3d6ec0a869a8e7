// SPDX-License-Identifier: MIT
// Shadows in the studio: of the object on the ground, as src/render/framing/ground_shadow.cpp has computed
// it, and of spheres at rest on the walls that they touch, which src/render/picture/contact_shadows.cpp has
// found.

class StudioShadows {
  constructor(gl, sections) {
    this.gl = gl;
    this.ground = facts.studio.ground ? this.groundOf(facts.studio.ground, sections.ground) : null;
    this.contacts = this.readContacts(new Cursor(sections.walls));
    this.buffer = gl.createBuffer();
    this.array = this.arrayOf(this.buffer, [3, 2, 4]);
  }

  /** An array of floats, of so many for each attribute. */
  arrayOf(buffer, sizes) {
    const { gl } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    const stride = 4 * sizes.reduce((a, b) => a + b);
    let from = 0;
    sizes.forEach((size, attribute) => {
      gl.vertexAttribPointer(attribute, size, gl.FLOAT, false, stride, from);
      gl.enableVertexAttribArray(attribute);
      from += 4 * size;
    });
    return array;
  }

  /** Two triangles for each cell of the grid in which anything is dark. */
  groundOf({ cells, corner, across, along }, dark) {
    const { gl } = this;
    const places = [];
    const put = (x, y) => places.push(...sum(corner, sum(scaled(across, x), scaled(along, y))),
      dark[y * (cells + 1) + x] / 255);
    for (let y = 0; y < cells; ++y) {
      for (let x = 0; x < cells; ++x) {
        const quad = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
        if (quad.some(([i, k]) => dark[k * (cells + 1) + i] > 0)) {
          [0, 1, 2, 0, 2, 3].forEach((i) => put(...quad[i]));
        }
      }
    }
    const buffer = gl.createBuffer();
    const array = this.arrayOf(buffer, [4]);
    gl.bufferData(gl.ARRAY_BUFFER, Float32Array.from(places), gl.STATIC_DRAW);
    return { array, count: places.length / 4 };
  }

  /** Of each sphere that touches walls its place in the last frame [step of the film], and the walls. */
  readContacts(cursor) {
    const contacts = [];
    let id = 0;
    for (let left = cursor.count(); left > 0; --left) {
      id += cursor.count();
      const place = [0, 1, 2].map(() => cursor.difference());
      const walls = Array.from({ length: cursor.count() }, () => ({
        inwards: normalized([0, 1, 2].map(() => cursor.difference())),
        height: cursor.count() / 32767, // of the centre [radius]
        bend: cursor.count() / 255 }));
      contacts.push({ id, place, walls });
    }
    return contacts;
  }

  /** Over nothing but the background. */
  draw(programs, looked, film, isWhole, withContacts) {
    const { gl } = this;
    gl.disable(gl.DEPTH_TEST);
    gl.depthMask(false);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    // The ground reaches further than the object, for which the far plane is: no depth is clipped.
    const projection = looked.projection.map((number, i) => i === 10 || i === 14 ? 0 : number);
    const { up, ground } = facts.studio;
    if (ground && dot(up, looked.eyeOfObject) > ground.level) {
      this.drawArray("ground", this.ground.array, this.ground.count, programs, looked.view, projection);
    }
    const corners = withContacts ? this.cornersOfContacts(looked, film, isWhole) : [];
    if (corners.length > 0) {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
      gl.bufferData(gl.ARRAY_BUFFER, Float32Array.from(corners), gl.DYNAMIC_DRAW);
      this.drawArray("contact", this.array, corners.length / 9, programs, looked.view, projection);
    }
    gl.disable(gl.BLEND);
    gl.depthMask(true);
  }

  drawArray(program, array, count, programs, view, projection) {
    programs.get(program, {}, false).use({ view, projection });
    this.gl.bindVertexArray(array);
    this.gl.drawArrays(this.gl.TRIANGLES, 0, count);
  }

  /** Squares in the walls that are seen from within, as contact.vert takes them. */
  cornersOfContacts({ eyeOfObject }, film, isWhole) {
    const { edge_on: edgeOn, of_bend: ofBend, fade, touches, farthest } = facts.studio;
    const smooth = (from, to, x) => {
      const t = Math.min(1, Math.max(0, (x - from) / (to - from)));
      return t * t * (3 - 2 * t);
    };
    const corners = [];
    const sphere = [0, 0, 0, 0];
    for (const { id, place, walls } of this.contacts) {
      const rests = id < film.spheres && (film.states[id] === kFrozen || film.states[id] === kDiscarded);
      if (!rests || place.some((at, axis) => Math.abs(at - film.places[3 * id + axis]) > 1)) {
        continue; // it touches nothing yet, or something else
      }
      putInUnitSpace(film, id, sphere, 0);
      const [x, y, z, radius] = sphere;
      for (const { inwards, height, bend } of walls) {
        const foot = difference([x, y, z], scaled(inwards, height * radius));
        const facing = dot(normalized(difference(eyeOfObject, foot)), inwards);
        const least = edgeOn + ofBend * bend;
        const strength = (1 - smooth(touches, farthest, height)) * smooth(least, least + fade, facing);
        if (strength > 0 && isWhole(foot, radius)) {
          this.addSquare(foot, radius, inwards, height, strength, corners);
        }
      }
    }
    return corners;
  }

  addSquare(foot, radius, inwards, height, strength, corners) {
    const { lamp } = facts.studio;
    const up = dot(lamp, inwards);
    const level = difference(lamp, scaled(inwards, up));
    const length = Math.hypot(...level);
    const axis = Math.abs(inwards[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0];
    const across = scaled(length > 1e-3 ? scaled(level, -1 / length) : normalized(cross(inwards, axis)), radius);
    const along = cross(inwards, across);
    for (const [x, y] of [[-1, -1], [1, -1], [-1, 1], [-1, 1], [1, -1], [1, 1]]) {
      corners.push(...sum(foot, sum(scaled(across, x), scaled(along, y))), x, y, height, length, up, strength);
    }
  }
}
