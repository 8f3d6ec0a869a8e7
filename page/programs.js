// SPDX-License-Identifier: MIT
// The shaders of Frostfill's own pictures (shaders/), for WebGL 2. Which of their variants are
// compiled depends on the look and on whether something is cut away.

const kHead = "#version 300 es\nprecision highp float;\nprecision highp int;\n";

function compile(gl, kind, text) {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
    throw new Unable(`The graphics driver refuses a shader: ${gl.getShaderInfoLog(shader)}`);
  }
  return shader;
}

class Program {
  constructor(gl, vertex, fragment, defined) {
    this.gl = gl;
    const front = kHead + defined.map((name) => `#define ${name}\n`).join("") + shaders.common;
    this.program = gl.createProgram();
    gl.attachShader(this.program, compile(gl, gl.VERTEX_SHADER, front + vertex));
    gl.attachShader(this.program, compile(gl, gl.FRAGMENT_SHADER, front + fragment));
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS)) {
      throw new Unable(`The graphics driver refuses a shader: ${gl.getProgramInfoLog(this.program)}`);
    }
    this.places = new Map();
  }

  /** Sets uniforms by their names; a number, or a list of 2, 3, 4, 8 (two vectors) or 16. */
  use(values) {
    const { gl } = this;
    gl.useProgram(this.program);
    for (const [name, value] of Object.entries(values)) {
      if (!this.places.has(name)) {
        this.places.set(name, gl.getUniformLocation(this.program, name));
      }
      const place = this.places.get(name);
      if (typeof value === "number") {
        gl.uniform1f(place, value);
      } else if (value.length === 16) {
        gl.uniformMatrix4fv(place, false, value);
      } else {
        const kind = { 2: "uniform2fv", 3: "uniform3fv", 4: "uniform4fv", 8: "uniform4fv" };
        gl[kind[value.length]](place, value);
      }
    }
  }
}

/** Programs by what is drawn and how; each is compiled when it is first wanted. */
class Programs {
  constructor(gl) {
    this.gl = gl;
    this.known = new Map();
  }

  get(name, look, isCut) {
    const defined = [];
    if (isCut) defined.push("CUTAWAY");
    if (look.outlines) defined.push("OUTLINES");
    if (look.fading_lines) defined.push("FADING_LINES");
    const key = [name, ...defined].join();
    if (!this.known.has(key)) {
      this.known.set(key,
        new Program(this.gl, shaders[`${name}_vert`], shaders[`${name}_frag`], defined));
    }
    return this.known.get(key);
  }
}
