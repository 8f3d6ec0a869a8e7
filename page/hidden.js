// SPDX-License-Identifier: MIT
// Which of very many spheres are left out of a picture: those that others hide, that lie beside it or
// that are cut away. Nothing that could be seen is: a sphere hides the pixels of the great circle that
// faces the viewer as far as they lie in it whole, from its centre on, and it is hidden where all pixels
// that it may touch are hidden before it begins.

const kManySpheres = 50000; // so many are drawn without a look at what is hidden
const kSteps = 1 << 16; // of distance, by which they are ordered

class Hidden {
  constructor() {
    this.depths = new Float32Array(0); // of what hides everything behind it, for each pixel [unit]
    this.order = new Uint32Array(0);
    this.begins = new Float32Array(0); // distance ahead at which each sphere begins
    this.seen = new Uint32Array(0);
  }

  /** Indices of the spheres to draw, the nearest first; valid until the next call. `spheres` are
      centres and radii in unit space, `planes` those of drawSpheres or null. */
  seenOf(spheres, count, { view, projection }, [width, height], planes) {
    this.depths = grown(this.depths, width * height);
    this.depths.fill(Infinity, 0, width * height);
    this.begins = grown(this.begins, count);
    this.seen = grown(this.seen, count);
    const ordered = this.nearestFirst(spheres, count, view);
    const look = { scaleX: 0.5 * width * projection[0], scaleY: 0.5 * height * projection[5],
      middleX: 0.5 * width * (1 - projection[8]), middleY: 0.5 * height * (1 - projection[9]), width, height };
    let found = 0;
    for (let k = 0; k < count; ++k) {
      const i = ordered[k];
      const [x, y, z, r] = [spheres[4 * i], spheres[4 * i + 1], spheres[4 * i + 2], spheres[4 * i + 3]];
      const ahead = -(view[2] * x + view[6] * y + view[10] * z + view[14]);
      const right = view[0] * x + view[4] * y + view[8] * z + view[12];
      const up = view[1] * x + view[5] * y + view[9] * z + view[13];
      const inCut = planes === null ? -Infinity : Math.min(
        planes[0] * right + planes[1] * up - planes[2] * ahead + planes[3],
        planes[4] * right + planes[5] * up - planes[6] * ahead + planes[7]);
      if (ahead <= r || inCut > r || this.isHidden(right, up, ahead, r, look)) {
        continue;
      }
      this.seen[found++] = i;
      if (inCut < -r) {
        this.hide(look.middleX + look.scaleX * right / ahead, look.middleY + look.scaleY * up / ahead,
          look.scaleX * r / ahead, look.scaleY * r / ahead, ahead, look);
      }
    }
    return this.seen.subarray(0, found);
  }

  /** By counting: a sort would take a second for a million. */
  nearestFirst(spheres, count, view) {
    const { begins } = this;
    let low = Infinity;
    let high = -Infinity;
    for (let i = 0; i < count; ++i) {
      const begin = -(view[2] * spheres[4 * i] + view[6] * spheres[4 * i + 1] +
        view[10] * spheres[4 * i + 2] + view[14]) - spheres[4 * i + 3];
      begins[i] = begin;
      low = Math.min(low, begin);
      high = Math.max(high, begin);
    }
    const perLength = (kSteps - 1) / Math.max(high - low, 1e-9);
    const starts = new Uint32Array(kSteps + 1);
    for (let i = 0; i < count; ++i) {
      ++starts[1 + ((begins[i] - low) * perLength | 0)];
    }
    for (let step = 0; step < kSteps; ++step) {
      starts[step + 1] += starts[step];
    }
    this.order = grown(this.order, count);
    for (let i = 0; i < count; ++i) {
      this.order[starts[(begins[i] - low) * perLength | 0]++] = i;
    }
    return this.order;
  }

  isHidden(right, up, ahead, radius, { scaleX, scaleY, middleX, middleY, width, height }) {
    // Where the tangents from the eye pass: (across ahead -+ r t) / (ahead^2 - r^2).
    const over = 1 / (ahead * ahead - radius * radius);
    const reachX = radius * Math.sqrt(right * right + ahead * ahead - radius * radius) * over;
    const reachY = radius * Math.sqrt(up * up + ahead * ahead - radius * radius) * over;
    const x = right * ahead * over;
    const y = up * ahead * over;
    const left = Math.max(0, Math.floor(middleX + scaleX * (x - reachX) - 0.01));
    const end = Math.min(width, Math.ceil(middleX + scaleX * (x + reachX) + 0.01));
    const bottom = Math.max(0, Math.floor(middleY + scaleY * (y - reachY) - 0.01));
    const top = Math.min(height, Math.ceil(middleY + scaleY * (y + reachY) + 0.01));
    const begin = ahead - radius;
    for (let row = bottom; row < top; ++row) {
      for (let at = row * width + left; at < row * width + end; ++at) {
        if (this.depths[at] > begin) {
          return false;
        }
      }
    }
    return true;
  }

  /** The pixels that lie whole in an ellipse. */
  hide(x, y, radiusX, radiusY, ahead, { width, height }) {
    const { depths } = this;
    const bottom = Math.max(0, Math.ceil(y - radiusY));
    const top = Math.min(height, Math.floor(y + radiusY));
    for (let row = bottom; row < top; ++row) {
      const away = Math.max(Math.abs(row - y), Math.abs(row + 1 - y)) / radiusY;
      if (away < 1) {
        const half = radiusX * Math.sqrt(1 - away * away);
        const left = Math.max(0, Math.ceil(x - half));
        const end = Math.min(width, Math.floor(x + half));
        for (let at = row * width + left; at < row * width + end; ++at) {
          if (ahead < depths[at]) {
            depths[at] = ahead;
          }
        }
      }
    }
  }
}
