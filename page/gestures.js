// SPDX-License-Identifier: MIT
// Mouse, touch, wheel and keys, made into turns and steps of the camera.

const kDegreesPerPixel = 0.4;

class Gestures {
  /** `moved` is called when the camera has moved. */
  constructor(canvas, camera, moved) {
    Object.assign(this, { canvas, camera, moved });
    this.pointers = new Map();
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    for (const end of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    }
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("dblclick", () => this.reset());
    canvas.addEventListener("wheel", (event) => this.roll(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.key(event));
    part("reset").addEventListener("click", () => this.reset());
  }

  reset() {
    this.camera.reset();
    this.moved();
  }

  press(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  drag(event) {
    if (!this.pointers.has(event.pointerId)) {
      return;
    }
    const before = this.grip();
    const [x, y] = this.pointers.get(event.pointerId);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    const height = this.canvas.clientHeight;
    if (this.pointers.size > 1) {
      const now = this.grip();
      this.camera.approach(before.span / Math.max(1, now.span));
      this.camera.shift((before.x - now.x) / height, (now.y - before.y) / height);
    } else if (event.buttons & 6 || event.shiftKey) {
      this.camera.shift((x - event.clientX) / height, (event.clientY - y) / height);
    } else {
      this.camera.turn((x - event.clientX) * kDegreesPerPixel,
        (event.clientY - y) * kDegreesPerPixel);
    }
    this.moved();
  }

  /** Middle and span of the first two fingers. */
  grip() {
    const [a, b = a] = [...this.pointers.values()];
    return { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, span: Math.hypot(a[0] - b[0], a[1] - b[1]) };
  }

  roll(event) {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
    this.camera.approach(Math.exp(0.001 * lines * event.deltaY));
    this.moved();
  }

  key(event) {
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    if (event.key in turns && event.shiftKey) {
      this.camera.shift(...scaled(turns[event.key], 0.05));
    } else if (event.key in turns) {
      this.camera.turn(...scaled(turns[event.key], 5));
    } else if (event.key === "+" || event.key === "=") {
      this.camera.approach(0.9);
    } else if (event.key === "-") {
      this.camera.approach(1 / 0.9);
    } else if (event.key === "0") {
      this.camera.reset();
    } else {
      return;
    }
    event.preventDefault();
    this.moved();
  }
}
