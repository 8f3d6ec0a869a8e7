// SPDX-License-Identifier: MIT
// What colours of spheres mean, as in src/render/overlay/colour_scale.cpp, which wrote the scale and
// the ranges into the page.

/** Four bytes as WebGL reads them. */
const packed = (colour) =>
  (colour[0] | colour[1] << 8 | colour[2] << 16 | 255 << 24) >>> 0;

/** The 256 colours of the scale: on a dark background they begin where they can be seen. */
const scaleOf = ({ scale_start: start }) => facts.scale.map((_, i) =>
  facts.scale[Math.round(255 * start + (1 - start) * i)]);

function coloursOfStates(look) {
  return [look.running, look.frozen, look.discarded, look.running].map(packed);
}

/** The colour of each sphere of the film's frame, as a function of its number. */
function coloursOf(film, by, look) {
  const ofState = coloursOfStates(look);
  const scale = Uint32Array.from(scaleOf(look), packed);
  const { low, high, of } = facts.colours.find((each) => each.by === by);
  const width = high > low ? high - low : Infinity;
  const fromScale = (value) =>
    scale[Math.round(255 * Math.min(1, Math.max(0, (value - low) / width)))];
  const resting = packed(facts.resting);
  const height = heightOf();
  const valueOf = {
    state: (id) => ofState[film.states[id]],
    set: (id) => fromScale(Math.floor(film.values.group[id] / facts.groups_per_set)),
    group: (id) => fromScale(film.values.group[id]),
    speed: (id) => scale[film.values.speed[id]],
    height: (id) => fromScale(height(film, id)),
    radius: (id) => fromScale(facts.film.radius_step * film.values.radius[id]),
  }[by] ?? ((id) => fromScale(film.values[by][id]));
  return (id) => {
    const state = film.states[id];
    const rests = state === kFrozen || state === kDiscarded;
    const isMeant = of === "all" || (of === "resting") === rests;
    return isMeant ? valueOf(id) : state === kFrozen ? resting : ofState[state];
  };
}

/** The height of a sphere above the object's foot [mesh unit], as the mesh stands. */
function heightOf() {
  const { step } = facts.film;
  const base = dot(facts.up, facts.origin) - facts.foot;
  const [x, y, z] = facts.up;
  return (film, id) => base + step *
    (x * film.places[3 * id] + y * film.places[3 * id + 1] + z * film.places[3 * id + 2]);
}
