// SPDX-License-Identifier: MIT
// Puts the parts together: what the reader chooses, and when the picture is drawn anew.

const kSmoothTimes = 2; // a picture is drawn so many times as large where pixels are coarse
const kSlow = 60; // where pictures take longer they are drawn smaller while things move [ms]

class Page {
  constructor(sections) {
    this.film = new Film(sections);
    const look = facts.looks[startLook()];
    this.view = { colourBy: facts.colour_by, look, shell: 0, cut: null };
    const canvas = part("picture");
    this.picture = new Picture(canvas, this.film, sections, this.view);
    this.keepContext(canvas, sections);
    this.camera = new Camera(this.picture.shell.points);
    this.timeline = new Timeline(this.film, () => this.redraw());
    this.gestures = new Gestures(part("picture"), this.camera, () => this.redraw());
    this.fillControls();
    this.takeLook();
    this.readAddress();
    // At once: what is drawn a frame later is seen stretched until then.
    new ResizeObserver(() => this.draw()).observe(part("stage"));
    window.addEventListener("hashchange", () => this.readAddress());
    window.addEventListener("keydown", (event) => this.key(event));
  }

  /** A browser may take the graphics context away; what it gives in its place is empty. */
  keepContext(canvas, sections) {
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault(); // or there is no other one
      part("notice").textContent =
        "The browser has taken the graphics away. If the picture does not come back, reload the page.";
      part("notice").hidden = false;
    });
    canvas.addEventListener("webglcontextrestored", () => {
      this.picture = new Picture(canvas, this.film, sections, this.view);
      part("notice").hidden = true;
      this.redraw();
    });
  }

  fillControls() {
    const { view } = this;
    choices("colour-by", facts.colours.map(({ by }) => [by, by]), view.colourBy, (by) => {
      view.colourBy = by;
      showScale(by, view.look);
    });
    choices("look", facts.looks.map(({ name }, i) => [i, name]), facts.looks.indexOf(view.look), (i) => {
      view.look = facts.looks[i];
      this.takeLook();
    });
    const cuts = [["", "nothing"], ["front", "the front"], ["right", "the right"], ["top", "the top"]];
    if (facts.cutaway) {
      cuts.push(["run", "as in the run"]);
    }
    choices("cut", cuts, facts.cutaway ? "run" : "", () => this.takeCut());
    for (const id of ["colour-by", "look", "cut"]) {
      part(id).addEventListener("change", () => this.redraw());
    }
    part("cut-depth").addEventListener("input", () => this.takeCut());
    part("shell").addEventListener("input", () => {
      this.shellIsChosen = true;
      view.shell = Number(part("shell").value) ** 2; // film is seen where it is hardly there
      this.redraw();
    });
    part("controls").addEventListener("submit", (event) => event.preventDefault());
    this.takeCut();
  }

  takeLook() {
    dressPage(this.view.look);
    showScale(this.view.colourBy, this.view.look);
    if (!this.shellIsChosen) {
      this.takeShell();
    }
    this.redraw();
  }

  takeShell() {
    const opacity = facts.shell_opacity ?? this.view.look.active_polygon[3] / 255;
    this.view.shell = facts.shell ? opacity : 0;
    part("shell").value = Math.sqrt(this.view.shell);
  }

  takeCut() {
    const which = part("cut").value;
    const plane = which !== "" && which !== "run";
    part("cut-depth").hidden = part("cut-depth-label").hidden = !plane;
    this.view.cut = which === "" ? null
      : which === "run" ? { planes: facts.cutaway } : this.cutOf(which, Number(part("cut-depth").value));
    this.redraw();
  }

  /** A plane across the object; at depth 1 nothing of it is left. */
  cutOf(which, depth) {
    const front = facts.camera.azimuth;
    const axis = { front: () => horizontalDirection(front), right: () => horizontalDirection(front + 90),
      top: () => facts.up }[which]();
    const { low, high } = extent(this.picture.shell.points, axis);
    return { axis, place: high - depth * (high - low) };
  }

  /** Keys of the whole page, where nothing else has them. */
  key(event) {
    const busy = event.target.closest("input, select, button, summary, a");
    if (event.key === " " && !busy) {
      event.preventDefault();
      this.timeline.toggle();
    } else if (event.key === "," || event.key === ".") {
      this.timeline.goToFrame(this.timeline.frame + (event.key === "," ? -1 : 1));
    }
  }

  /** The part after # chooses frame, camera, colours and look; docs/view.md lists the words. */
  readAddress() {
    const words = new URLSearchParams(location.hash.slice(1));
    const numbers = (name) => words.get(name).split(",").map(Number);
    document.body.classList.toggle("bare", words.has("canvas"));
    if (words.has("canvas") && words.get("canvas")) {
      const [width, height] = words.get("canvas").split("x");
      Object.assign(part("stage").style, { width: `${width}px`, height: `${height}px` });
    }
    if (words.has("frame")) {
      const at = this.film.numbers.findLastIndex((number) => number <= numbers("frame")[0]);
      this.timeline.goToFrame(at);
    }
    this.readCamera(words, numbers);
    for (const [word, id] of [["colour", "colour-by"], ["cut", "cut"], ["depth", "cut-depth"]]) {
      if (words.has(word)) {
        part(id).value = words.get(word);
        part(id).dispatchEvent(new Event(id === "cut-depth" ? "input" : "change"));
      }
    }
    if (words.has("look")) {
      part("look").value = facts.looks.findIndex(({ name }) => name === words.get("look"));
      part("look").dispatchEvent(new Event("change"));
    }
    if (words.has("shell")) {
      this.shellIsChosen = true;
      [this.view.shell] = numbers("shell");
    }
    this.redraw();
  }

  readCamera(words, numbers) {
    for (const name of ["azimuth", "elevation"]) {
      if (words.has(name)) {
        [this.camera[name]] = numbers(name);
        this.camera.fit();
      }
    }
    if (words.has("target") && words.has("distance")) {
      this.camera.fitted = false;
      this.camera.target = toUnit(numbers("target"));
      this.camera.distance = numbers("distance")[0] * facts.scale_of_unit;
    }
  }

  redraw() {
    this.wanted ??= requestAnimationFrame(() => {
      this.wanted = undefined;
      this.draw();
    });
  }

  draw() {
    if (this.picture.gl.isContextLost()) {
      return;
    }
    const now = performance.now();
    this.film.seek(this.timeline.frame);
    const { clientWidth, clientHeight } = part("stage");
    const ratio = Math.min(window.devicePixelRatio, 3);
    const width = Math.max(1, Math.round(clientWidth * ratio));
    const height = Math.max(1, Math.round(clientHeight * ratio));
    const hurried = this.isSlow && (this.timeline.playing || this.gestures.pointers.size > 0);
    this.picture.resize(width, height, ratio >= 2 || hurried ? 1 : kSmoothTimes);
    this.camera.resize(width / height);
    this.picture.draw(this.camera);
    showCounts(this.film);
    const { azimuth, elevation, distance } = this.camera;
    Object.assign(part("picture").dataset,
      { azimuth, elevation, distance, frame: this.film.numbers[this.film.at] });
    // One picture waits for the one before; from a pause on, nothing is known.
    const passed = now - (this.drawn ?? -Infinity);
    this.isSlow ||= passed > kSlow && passed < 10 * kSlow;
    this.drawn = now;
    clearTimeout(this.later);
    if (hurried) {
      this.later = setTimeout(() => this.redraw(), 250);
    }
  }
}

/** The run's look, or the dark one where the reader likes that and the run asks for nothing else. */
function startLook() {
  const dark = facts.looks.findIndex(({ name }) => name === "Dark");
  const isPlain = facts.looks[facts.look].name === "Clean";
  return isPlain && matchMedia("(prefers-color-scheme: dark)").matches ? dark : facts.look;
}

/** Fills a list of choices: [value, text]. */
function choices(id, all, chosen, changed) {
  part(id).replaceChildren(...all.map(([value, text]) => new Option(text, value)));
  part(id).value = chosen;
  part(id).addEventListener("change", () => changed(part(id).value));
}

showHeader();
showSizes();
showErrors();
showMachine();
showCommand();
showSets();
dressPage(facts.looks[startLook()]);
try {
  window.frostfill = new Page(await unpackSections()); // for the console, and for tests
  part("notice").hidden = true;
  document.body.dataset.ready = "yes";
} catch (error) {
  part("notice").textContent = error instanceof Unable ? error.message
    : `This page is damaged, or the browser lacks something: ${error.message}`;
  if (!(error instanceof Unable)) {
    throw error;
  }
}
