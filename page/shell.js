// SPDX-License-Identifier: MIT
// The object's shell, as in src/render/passes/mesh_pass.cpp: each triangle has three corners of its
// own, so that the fragment stage knows how far each edge is.

class Shell {
  constructor(gl, sections) {
    this.gl = gl;
    this.points = numbersOf(Float32Array, sections.points);
    this.readTriangles(sections);
    this.readEdges(sections);
    this.upload(numbersOf(Int16Array, sections.normals), sections.creases);
  }

  readTriangles(sections) {
    const cursor = new Cursor(sections.triangles);
    this.corners = new Uint32Array(3 * facts.triangles);
    let point = 0;
    for (let i = 0; i < this.corners.length; ++i) {
      point += cursor.difference();
      this.corners[i] = point;
    }
    this.normals = new Float64Array(3 * facts.triangles); // of the faces; any length
    for (let t = 0; t < facts.triangles; ++t) {
      const [a, b, c] = [0, 1, 2].map((corner) => this.point(3 * t + corner));
      this.normals.set(cross(difference(b, a), difference(c, a)), 3 * t);
    }
  }

  point(corner) {
    const at = 3 * this.corners[corner];
    return [this.points[at], this.points[at + 1], this.points[at + 2]];
  }

  readEdges(sections) {
    const cursor = new Cursor(sections.edges);
    const count = sections.edgeKinds.length / 2;
    this.sides = new Uint32Array(2 * count); // triangles beside each edge; equal: there is one
    this.kinds = sections.edgeKinds; // corners that are opposite, and how strongly it is drawn
    let first = 0;
    for (let i = 0; i < count; ++i) {
      first += cursor.difference();
      this.sides[2 * i] = first;
      this.sides[2 * i + 1] = first + cursor.difference();
    }
  }

  upload(normals, creases) {
    const { gl, corners } = this;
    const shape = new DataView(new ArrayBuffer(18 * corners.length + 2 * corners.length));
    this.edges = new Uint8Array(4 * corners.length);
    corners.forEach((point, i) => {
      for (let axis = 0; axis < 3; ++axis) {
        shape.setFloat32(20 * i + 4 * axis, this.points[3 * point + axis], true);
        shape.setInt16(20 * i + 12 + 2 * axis, normals[3 * point + axis], true);
      }
      this.edges[4 * i + 3] = creases[point];
    });
    this.array = gl.createVertexArray();
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, shape, gl.STATIC_DRAW);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 20, 0);
    gl.vertexAttribPointer(1, 3, gl.SHORT, true, 20, 12);
    this.edgeBuffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.edgeBuffer);
    gl.vertexAttribPointer(2, 4, gl.UNSIGNED_BYTE, true, 4, 0);
    this.stateBuffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.stateBuffer);
    gl.vertexAttribIPointer(3, 1, gl.UNSIGNED_BYTE, 1, 0);
    [0, 1, 2, 3].forEach((attribute) => gl.enableVertexAttribArray(attribute));
  }

  /** Takes the states of the triangles. */
  setPolygons(polygons) {
    const states = new Uint8Array(3 * polygons.length);
    polygons.forEach((state, t) => states.fill(state, 3 * t, 3 * t + 3));
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.stateBuffer);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, states, this.gl.DYNAMIC_DRAW);
  }

  /** Draws edges as outlines where one of their sides is seen and the other is not. */
  lookFrom(eye) {
    const seen = new Uint8Array(facts.triangles);
    for (let t = 0; t < seen.length; ++t) {
      const at = 3 * this.corners[3 * t];
      seen[t] = this.normals[3 * t] * (eye[0] - this.points[at]) +
        this.normals[3 * t + 1] * (eye[1] - this.points[at + 1]) +
        this.normals[3 * t + 2] * (eye[2] - this.points[at + 2]) > 0 ? 1 : 0;
    }
    for (let i = 0; i < this.kinds.length / 2; ++i) {
      const first = this.sides[2 * i];
      const second = this.sides[2 * i + 1];
      const strength = seen[first] !== seen[second] ? facts.framing.outline : this.kinds[2 * i + 1];
      const corners = this.kinds[2 * i];
      this.setEdge(first, corners & 3, strength);
      if (second !== first) {
        this.setEdge(second, corners >> 2, strength);
      }
    }
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.edgeBuffer);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, this.edges, this.gl.DYNAMIC_DRAW);
  }

  /** The edge opposite a corner, for all three corners of the triangle. */
  setEdge(triangle, corner, strength) {
    for (let k = 0; k < 3; ++k) {
      this.edges[4 * (3 * triangle + k) + corner] = strength;
    }
  }

  /** Blends back faces, then front faces, over the spheres. */
  draw() {
    const { gl } = this;
    gl.bindVertexArray(this.array);
    gl.depthMask(false);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.enable(gl.CULL_FACE);
    for (const hidden of [gl.FRONT, gl.BACK]) {
      gl.cullFace(hidden);
      gl.drawArrays(gl.TRIANGLES, 0, this.corners.length);
    }
    gl.disable(gl.CULL_FACE);
    gl.disable(gl.BLEND);
    gl.depthMask(true);
  }
}
