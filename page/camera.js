// SPDX-License-Identifier: MIT
// Where the eye is, as in src/render/framing, whose numbers are in facts.framing: azimuth about the
// up axis, elevation above the horizon,
// a target in the middle of the picture. Lengths are in unit space, where the object has a radius
// of 1. Matrices are arrays of columns.

const radians = (degrees) => degrees * Math.PI / 180;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const scaled = (a, s) => a.map((x) => x * s);
const sum = (a, b) => a.map((x, i) => x + b[i]);
const difference = (a, b) => a.map((x, i) => x - b[i]);
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const normalized = (a) => scaled(a, 1 / Math.hypot(...a));

function product(a, b) {
  const result = new Array(16).fill(0);
  for (let column = 0; column < 4; ++column) {
    for (let row = 0; row < 4; ++row) {
      for (let k = 0; k < 4; ++k) {
        result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
      }
    }
  }
  return result;
}

const toUnit = (point) => scaled(difference(point, facts.centre), facts.scale_of_unit);

/** A pose (see Film.pose) as a matrix of unit space. */
function poseMatrix(pose) {
  const fromCentre = difference(facts.origin, facts.centre);
  const turned = [0, 1, 2].map((row) => dot(pose.slice(3 * row, 3 * row + 3), fromCentre));
  const shift = [0, 1, 2].map((i) =>
    facts.scale_of_unit * (fromCentre[i] + pose[9 + i] - turned[i]));
  return [pose[0], pose[3], pose[6], 0, pose[1], pose[4], pose[7], 0,
    pose[2], pose[5], pose[8], 0, ...shift, 1];
}

/** Corners of the object in all its poses: what has to fit into the picture. */
function fittedPoints(points) {
  if (facts.poses.length === 0) {
    return points;
  }
  const all = new Float32Array(points.length * facts.poses.length);
  let at = 0;
  for (const pose of facts.poses) {
    const m = poseMatrix(pose);
    for (let i = 0; i < points.length; i += 3) {
      for (let row = 0; row < 3; ++row) {
        all[at++] = m[row] * points[i] + m[4 + row] * points[i + 1] + m[8 + row] * points[i + 2] +
          m[12 + row];
      }
    }
  }
  return all;
}

/** The horizontal direction in which a camera at this azimuth stands. */
function horizontalDirection(azimuth) {
  const angle = radians(azimuth);
  return sum(scaled(facts.framing.back, Math.cos(angle)),
    scaled(facts.framing.right, Math.sin(angle)));
}

/** The least and the largest distance of points along an axis of any length. */
function extent(points, [x, y, z]) {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < points.length; i += 3) {
    const along = x * points[i] + y * points[i + 1] + z * points[i + 2];
    low = Math.min(low, along);
    high = Math.max(high, along);
  }
  return { low, high };
}

class Camera {
  constructor(points) {
    this.points = fittedPoints(points);
    this.fieldOfView = facts.camera.field_of_view;
    this.aspect = 1;
    this.reset();
  }

  /** As the run looks at it. */
  reset() {
    this.azimuth = facts.camera.azimuth;
    this.elevation = facts.camera.elevation;
    this.target = facts.camera.target ? toUnit(facts.camera.target) : [0, 0, 0];
    this.distance = facts.camera.distance ? facts.camera.distance * facts.scale_of_unit : null;
    this.fitted = !this.distance; // as long as nobody has moved it, it fits any window
    this.fit();
  }

  resize(aspect) {
    this.aspect = aspect;
    this.fit();
  }

  get tangent() {
    return Math.tan(radians(this.fieldOfView) / 2);
  }

  axes() {
    const elevation = radians(this.elevation);
    const around = horizontalDirection(this.azimuth);
    return {
      right: horizontalDirection(this.azimuth + 90),
      up: difference(scaled(facts.up, Math.cos(elevation)), scaled(around, Math.sin(elevation))),
      back: sum(scaled(around, Math.cos(elevation)), scaled(facts.up, Math.sin(elevation))),
    };
  }

  /** Goes so far away that the whole object is seen, in the middle of the picture. */
  fit() {
    if (!this.fitted) {
      return;
    }
    const { right, up, back } = this.axes();
    const vertical = this.tangent * (1 - facts.framing.margin);
    const sides = [[right, vertical * this.aspect], [up, vertical]];
    this.target = [0, 0, 0];
    let offset = [0, 0, 0];
    this.distance = 0;
    for (const [axis, tangent] of sides) {
      const towards = scaled(back, tangent);
      const plus = extent(this.points, sum(towards, axis)).high;
      const minus = extent(this.points, difference(towards, axis)).high;
      offset = sum(offset, scaled(axis, (plus - minus) / 2));
      this.distance = Math.max(this.distance, (plus + minus) / (2 * tangent));
    }
    this.target = offset;
    this.distance /= facts.camera.zoom;
  }

  turn(azimuth, elevation) {
    this.fitted = false;
    this.azimuth = (this.azimuth + azimuth) % 360;
    this.elevation = Math.min(90, Math.max(-90, this.elevation + elevation));
  }

  approach(factor) {
    this.fitted = false;
    this.distance = Math.min(50, Math.max(0.02, this.distance * factor));
  }

  /** Shifts the target by shares of the picture's height. */
  shift(right, up) {
    this.fitted = false;
    const { right: x, up: y } = this.axes();
    const height = 2 * this.tangent * this.distance;
    this.target = sum(this.target, sum(scaled(x, right * height), scaled(y, up * height)));
  }

  /** All that shaders want to know, for the pose of the object. */
  look(pose) {
    const { right, up, back } = this.axes();
    const eye = sum(this.target, scaled(back, this.distance));
    const view = [right[0], up[0], back[0], 0, right[1], up[1], back[1], 0,
      right[2], up[2], back[2], 0, -dot(right, eye), -dot(up, eye), -dot(back, eye), 1];
    const depth = extent(this.points, back);
    const height = extent(this.points, facts.up);
    const high = depth.high - dot(back, this.target);
    const low = depth.low - dot(back, this.target);
    const padding = facts.framing.depth_padding;
    const near = Math.max(this.distance - high - padding, facts.framing.near_share * this.distance);
    const far = this.distance - low + padding;
    const projection = [1 / (this.tangent * this.aspect), 0, 0, 0, 0, 1 / this.tangent, 0, 0,
      0, 0, -(far + near) / (far - near), -1, 0, 0, -2 * far * near / (far - near), 0];
    const tall = Math.max(height.high - height.low, 1e-6);
    const deep = Math.max(high - low, 1e-6);
    const upward = [dot(right, facts.up), dot(up, facts.up), dot(back, facts.up)];
    const matrix = poseMatrix(pose);
    return {
      eyeOfObject: pullBack(matrix, eye),
      view: product(view, matrix),
      projection,
      depthAtInfinity: (1 + (far + near) / (far - near)) / 2,
      heightPlane: [...scaled(upward, 1 / tall), (dot(facts.up, eye) - height.low) / tall],
      distancePlane: [0, 0, -1 / deep, (high - this.distance) / deep],
    };
  }
}

/** A point before a rigid motion. */
function pullBack(matrix, point) {
  const p = difference(point, matrix.slice(12, 15));
  return [0, 1, 2].map((column) => dot(matrix.slice(4 * column, 4 * column + 3), p));
}

/** A direction of the space before a view, in the space after it. */
const turned = (view, [x, y, z]) =>
  [0, 1, 2].map((row) => view[row] * x + view[4 + row] * y + view[8 + row] * z);

/** A plane (normal, constant) of the space before a view, in the space after it. */
function movedPlane(view, plane) {
  const normal = turned(view, plane);
  return [...normal, plane[3] - dot(normal, view.slice(12, 15))];
}
