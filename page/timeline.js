// SPDX-License-Identifier: MIT
// Time: a slider over the counts of all frames, and playing. The run's time passes evenly, as fast
// as in the run's video at 1x.

const kSvg = "http://www.w3.org/2000/svg";

function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) {
    element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
}

class Timeline {
  /** `changed` is called when there is another frame to show. */
  constructor(film, changed) {
    this.film = film;
    this.changed = changed;
    this.first = film.times[0];
    this.last = film.times[film.frames - 1];
    this.time = this.last;
    this.frame = film.frames - 1;
    this.playing = false;
    this.rate = facts.rate ?? (this.last - this.first) / 20;
    this.slider = part("time");
    Object.assign(this.slider, { min: this.first, max: this.last });
    part("timeline").classList.toggle("still", !this.moves());
    this.slider.addEventListener("input", () => {
      this.stop();
      this.goTo(Number(this.slider.value));
    });
    this.slider.addEventListener("keydown", (event) => this.stepByKey(event));
    part("play").addEventListener("click", () => this.toggle());
    if (this.moves()) {
      this.drawCounts();
    }
    this.tell();
  }

  moves() {
    return this.last > this.first;
  }

  goTo(time) {
    this.time = Math.min(this.last, Math.max(this.first, time));
    this.showFrame(this.film.frameAt(this.time));
  }

  goToFrame(frame) {
    this.stop();
    const inside = Math.min(this.film.frames - 1, Math.max(0, frame));
    this.time = this.film.times[inside];
    this.showFrame(inside);
  }

  showFrame(frame) {
    if (this.frame !== frame) {
      this.frame = frame;
      this.changed();
    }
    this.tell();
  }

  tell() {
    const number = this.film.numbers[this.frame];
    this.slider.value = this.time;
    this.slider.setAttribute("aria-valuetext", `${seconds(this.time)}, frame ${number}`);
    part("clock").textContent = `${seconds(this.time)} · frame ${number}`;
    this.cursor?.setAttribute("x1", this.place(this.time));
    this.cursor?.setAttribute("x2", this.place(this.time));
  }

  stepByKey(event) {
    const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10 };
    if (event.key in steps) {
      event.preventDefault();
      this.goToFrame(this.frame + steps[event.key]);
    } else if (event.key === "Home" || event.key === "End") {
      event.preventDefault();
      this.goToFrame(event.key === "Home" ? 0 : this.film.frames - 1);
    }
  }

  toggle() {
    if (this.playing) {
      this.stop();
    } else if (this.moves()) {
      this.playing = true;
      if (this.time >= this.last) {
        this.goTo(this.first);
      }
      this.before = undefined;
      this.showButton();
      requestAnimationFrame((now) => this.play(now));
    }
  }

  play(now) {
    if (!this.playing) {
      return;
    }
    const passed = (now - (this.before ?? now)) / 1000;
    this.before = now;
    this.goTo(this.time + passed * this.rate * Number(part("speed").value));
    if (this.time >= this.last) {
      this.stop();
    }
    requestAnimationFrame((next) => this.play(next));
  }

  stop() {
    this.playing = false;
    this.showButton();
  }

  showButton() {
    part("play").setAttribute("aria-label", this.playing ? "Pause" : "Play");
    part("play").classList.toggle("playing", this.playing);
    document.body.classList.toggle("playing", this.playing);
  }

  place(time) {
    return 1000 * (time - this.first) / (this.last - this.first);
  }

  /** The counts of spheres over time, as areas one on another: discarded, frozen, running. */
  drawCounts() {
    const chart = part("counts-over-time");
    chart.setAttribute("viewBox", "0 0 1000 100");
    const step = Math.max(1, Math.floor(this.film.frames / 500));
    const frames = [];
    for (let i = 0; i < this.film.frames; i += step) {
      frames.push(i);
    }
    frames.push(this.film.frames - 1);
    const all = Math.max(1, ...frames.map((i) => {
      const [running, frozen, discarded] = this.film.countsAt(i);
      return running + frozen + discarded;
    }));
    const height = (count) => (100 - 96 * count / all).toFixed(2);
    const layers = [["running", ([r, f, d]) => r + f + d], ["frozen", ([, f, d]) => f + d],
      ["discarded", ([, , d]) => d]];
    for (const [name, count] of layers) {
      const top = frames.map((i) =>
        `${this.place(this.film.times[i]).toFixed(2)} ${height(count(this.film.countsAt(i)))}`);
      chart.append(svg("path", { class: name, d: `M0 100L${top.join("L")}L1000 100Z` }));
    }
    this.cursor = svg("line", { class: "cursor", y1: 0, y2: 100 });
    chart.append(this.cursor);
  }
}

function seconds(time) {
  return `${time.toFixed(time < 100 ? 2 : 1)} s`;
}
