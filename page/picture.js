// SPDX-License-Identifier: MIT
// The picture: spheres as squares that the shaders make round, then the shell over them.

const bytesToUnit = (colour) => colour.map((c) => c / 255);

class Picture {
  constructor(canvas, film, sections, view) {
    this.canvas = canvas;
    this.film = film;
    this.view = view; // what the reader has chosen
    const gl = canvas.getContext("webgl2",
      { antialias: false, alpha: false, depth: false, powerPreference: "high-performance" });
    if (!gl) {
      throw new Unable("This browser cannot draw the run: it lacks WebGL 2, or it is switched off.");
    }
    this.gl = gl;
    this.programs = new Programs(gl);
    this.shell = new Shell(gl, sections);
    this.makeSpheres();
    this.drawnSize = [0, 0];
    this.shown = {}; // of which frame, colours and eye the buffers are
  }

  makeSpheres() {
    const { gl } = this;
    this.array = gl.createVertexArray();
    this.buffers = [0, 1, 2].map(() => gl.createBuffer());
    gl.bindVertexArray(this.array);
    const kinds = [() => gl.vertexAttribPointer(0, 4, gl.FLOAT, false, 16, 0),
      () => gl.vertexAttribIPointer(1, 1, gl.UNSIGNED_INT, 4, 0),
      () => gl.vertexAttribPointer(2, 4, gl.UNSIGNED_BYTE, true, 4, 0)];
    kinds.forEach((describe, attribute) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[attribute]);
      describe();
      gl.enableVertexAttribArray(attribute);
    });
    // A corner for each vertex: a software renderer takes 30 us for each instance of four vertices.
    this.places = new Float32Array(0);
    this.words = new Uint32Array(0); // the states, and how the spheres have turned
    this.colours = new Uint32Array(0);
    this.indices = gl.createBuffer();
    this.squares = new Uint32Array(0);
  }

  /** Gives the driver places and states of the frame, in unit space, without the spheres that wait. */
  takeFrame() {
    const { film } = this;
    this.places = grown(this.places, 16 * film.spheres);
    this.words = grown(this.words, 4 * film.spheres);
    let at = 0; // of the first of four corners
    for (let id = 0; id < film.spheres; ++id) {
      if (film.states[id] !== kWaits) {
        putInUnitSpace(film, id, this.places, 4 * at);
        for (let k = 4 * at + 4; k < 4 * at + 16; ++k) {
          this.places[k] = this.places[k - 4];
        }
        const word = stateWord(film, id);
        for (const end = at + 4; at < end; ++at) {
          this.words[at] = word;
        }
      }
    }
    this.count = at / 4;
    this.fill(0, this.places.subarray(0, 4 * at));
    this.fill(1, this.words.subarray(0, at));
    this.makeSquares();
    this.shell.setPolygons(film.polygons);
  }

  takeColours() {
    const { film, view } = this;
    this.colours = grown(this.colours, 4 * film.spheres);
    const colourOf = coloursOf(film, view.colourBy, view.look);
    let at = 0;
    for (let id = 0; id < film.spheres; ++id) {
      if (film.states[id] !== kWaits) {
        const colour = colourOf(id);
        for (const end = at + 4; at < end; ++at) {
          this.colours[at] = colour;
        }
      }
    }
    this.fill(2, this.colours.subarray(0, at));
  }

  /** Of each square two triangles. */
  makeSquares() {
    const { gl } = this;
    if (6 * this.count <= this.squares.length) {
      return;
    }
    const before = this.squares.length / 6;
    this.squares = grown(this.squares, 6 * this.count);
    for (let k = before; 6 * k + 5 < this.squares.length; ++k) {
      this.squares.set([4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 2, 4 * k + 1, 4 * k + 3], 6 * k);
    }
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, this.squares, gl.STATIC_DRAW);
  }

  fill(buffer, numbers) {
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.buffers[buffer]);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, numbers, this.gl.DYNAMIC_DRAW);
  }

  /** A picture of width x height, so many times as large; it is made small when it is shown. */
  resize(width, height, times) {
    const { gl } = this;
    this.canvas.width = width;
    this.canvas.height = height;
    this.times = times;
    const size = [width * times, height * times];
    if (size[0] === this.drawnSize[0] && size[1] === this.drawnSize[1]) {
      return;
    }
    this.drawnSize = size;
    (this.targets ?? []).forEach((target) => gl.deleteRenderbuffer(target));
    this.frame ??= gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    const kinds = [[gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]];
    this.targets = kinds.map(([format, attachment]) => {
      const target = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, target);
      gl.renderbufferStorage(gl.RENDERBUFFER, format, ...size);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, target);
      return target;
    });
  }

  draw(camera) {
    const { gl, film, view, shown } = this;
    const isNew = shown.frame !== film.at;
    if (isNew) {
      this.takeFrame();
    }
    if (isNew || shown.colourBy !== view.colourBy || shown.look !== view.look) {
      this.takeColours();
    }
    Object.assign(shown, { frame: film.at, colourBy: view.colourBy, look: view.look });
    const looked = camera.look(film.pose());
    const planes = cutPlanes(view.cut, looked.view);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.viewport(0, 0, ...this.drawnSize);
    const ground = bytesToUnit(opaque(view.look.background));
    gl.clearColor(...ground);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.drawSpheres(looked, ground, planes);
    if (view.shell > 0) {
      this.drawShell(looked, planes);
    }
    this.show();
  }

  drawSpheres(looked, ground, planes) {
    const { gl, view: { look } } = this;
    this.programs.get("sphere", { ...look, fading_lines: false }, planes !== null).use({
      view: looked.view,
      projection: looked.projection,
      depthAtInfinity: looked.depthAtInfinity,
      pixelScale: 0.5 * looked.projection[5] * this.drawnSize[1],
      heightPlane: looked.heightPlane,
      distancePlane: looked.distancePlane,
      supersample: this.times,
      haze: look.haze,
      background: ground.slice(0, 3),
      outlineWidth: this.lineWidth(),
      cutPlanes: planes ?? new Array(8).fill(0),
    });
    gl.enable(gl.DEPTH_TEST);
    gl.bindVertexArray(this.array);
    gl.drawElements(gl.TRIANGLES, 6 * this.count, gl.UNSIGNED_INT, 0);
  }

  drawShell(looked, planes) {
    const { view: { look, shell } } = this;
    const eye = looked.eyeOfObject.join();
    if (this.shown.eye !== eye) {
      this.shell.lookFrom(looked.eyeOfObject);
      this.shown.eye = eye;
    }
    const lineWidth = this.lineWidth();
    const active = bytesToUnit(look.active_polygon);
    const discarded = bytesToUnit(look.discarded_polygon);
    discarded[3] = Math.min(1, discarded[3] * shell / Math.max(active[3], 1 / 255));
    active[3] = shell;
    this.programs.get("mesh", look, planes !== null).use({
      view: looked.view,
      projection: looked.projection,
      activeColour: active,
      discardedColour: discarded,
      activeInk: look.active_ink,
      discardedInk: look.discarded_ink,
      lineWidth,
      pixelLength: 2 / (looked.projection[5] * this.drawnSize[1]),
      edgeFade: scaled(facts.strokes.fade, lineWidth),
      cutPlanes: planes ?? new Array(8).fill(0),
    });
    this.shell.draw();
  }

  /** The width of lines, which grows with the picture [pixel of the one that is drawn]. */
  lineWidth() {
    const [pixels, share] = facts.strokes.line;
    return Math.max(pixels * this.times, share * Math.min(...this.drawnSize));
  }

  /** Averages the large picture into the canvas. */
  show() {
    const { gl, canvas } = this;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.frame);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, ...this.drawnSize, 0, 0, canvas.width, canvas.height,
      gl.COLOR_BUFFER_BIT, this.times === 1 ? gl.NEAREST : gl.LINEAR);
  }
}

/** A colour on white paper. */
function opaque([r, g, b, a]) {
  const onWhite = (c) => (c * a + 255 * (255 - a)) / 255;
  return [onWhite(r), onWhite(g), onWhite(b), 255];
}

/** What is cut away: { planes } as the run has them, or { axis, depth }; null for nothing. */
function cutPlanes(cut, view) {
  if (!cut) {
    return null;
  }
  const planes = cut.planes ?? [0, 1].map(() => [...cut.axis, -cut.place]);
  return planes.flatMap((plane) => movedPlane(view, plane));
}
