// SPDX-License-Identifier: MIT
// The table of sets, sets.csv, and charts of it; and the size curve beside the one that was asked for.

const kMaxPoints = 120; // of a chart; neighbouring sets share a point

/** Rows of CSV as objects of numbers. */
function readTable(text) {
  const [heading, ...lines] = text.trim().split("\n").map((line) => line.split(","));
  return lines.map((line) => Object.fromEntries(line.map((cell, i) => [heading[i], Number(cell)])));
}

/** A power of ten as people write it. */
function powerOfTen(value) {
  const [digits, power] = value.toExponential(1).split("e");
  const raised = [...String(Number(power))].map((c) => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]);
  return `${digits} · 10${raised.join("")}`;
}

/** A number for people: 1234567 as 1,234,567; 0.00012345 as 0.000123. */
function readable(value) {
  if (value === null || value === undefined || Number.isNaN(value)) {
    return "–";
  }
  if (Number.isInteger(value)) {
    return value.toLocaleString("en");
  }
  const size = Math.abs(value);
  return size >= 1e6 || size < 1e-4 ? powerOfTen(value)
    : size >= 100 ? Math.round(value).toLocaleString("en") : String(Number(value.toPrecision(3)));
}

/** The least of 1, 2, 5 times a power of ten that is not below. */
function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map((digit) => digit * power).find((round) => round >= value * (1 - 1e-9));
}

/** Rows in at most kMaxPoints groups, each the mean of some neighbours. */
function thinned(rows, value) {
  const each = Math.ceil(rows.length / kMaxPoints);
  const points = [];
  for (let i = 0; i < rows.length; i += each) {
    const group = rows.slice(i, i + each);
    points.push({ set: group[0].set, value: group.reduce((all, row) => all + value(row), 0) / group.length });
  }
  return points;
}

/** An empty chart: its picture, and where values are in it. `name`: of heights at 0, half and all of `top`. */
function plane(height, label, [first, last], top, name) {
  const [width, left, foot] = [320, 46, 18];
  const x = (value) => (left + (width - left - 8) * (value - first) / Math.max(last - first, 1e-300)).toFixed(1);
  const y = (value) => (height - foot - (height - foot - 8) * value / top).toFixed(1);
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": label });
  for (const value of [0, top / 2, top]) {
    picture.append(svg("line", { class: "rule", x1: left, x2: width - 8, y1: y(value), y2: y(value) }));
    picture.append(svg("text", { x: left - 6, y: Number(y(value)) + 3.5, "text-anchor": "end" }, name(value)));
  }
  const mark = (value, anchor, text) =>
    picture.append(svg("text", { x: x(value), y: height - 4, "text-anchor": anchor }, text));
  return { picture, x, y, mark };
}

/** Areas one on another, or a single line. `layers`: [class, value of a row] from below. */
function chart(title, rows, layers) {
  const sums = new Array(Math.min(rows.length, thinned(rows, () => 0).length)).fill(0);
  const stacked = layers.map(([name, value]) => [name, thinned(rows, value).map((point, i) => {
    sums[i] += point.value;
    return { set: point.set, value: sums[i] };
  })]);
  const top = roundUp(Math.max(1e-9, ...sums));
  const lastSet = Math.max(1, rows[rows.length - 1].set);
  const { picture, x, y, mark } =
    plane(96, `${title}, by set; the table has the numbers`, [0, lastSet], top, readable);
  for (const [name, points] of stacked.reverse()) {
    const path = points.map((point) => `${x(point.set)} ${y(point.value)}`).join("L");
    picture.append(layers.length > 1
      ? svg("path", { class: name, d: `M${x(0)} ${y(0)}L${path}L${x(points[points.length - 1].set)} ${y(0)}Z` })
      : svg("path", { class: `${name} line`, d: `M${path}` }));
  }
  mark(0, "start", "0");
  mark(lastSet, "end", `set ${lastSet}`);
  return figureOf(title, picture);
}

function figureOf(title, picture) {
  const figure = document.createElement("figure");
  const caption = document.createElement("figcaption");
  caption.textContent = title;
  figure.append(caption, picture);
  return figure;
}

/** Charts and table, or a word where the page has none. */
function showSets() {
  const rows = facts.sets ? readTable(facts.sets) : [];
  if (rows.length === 0) {
    part("charts").textContent = "There was no sets.csv beside the run file when this page was written.";
    part("set-table").hidden = true;
    return;
  }
  const drawn = rows.some((row) => row.frames > 0);
  if (rows.length > 1) {
    part("charts").append(
      chart("Spheres at the end of a set", rows, [["discarded", (row) => row.discarded],
        ["frozen", (row) => row.frozen], ["running", (row) => row.running]]),
      chart(drawn ? "Frames a second" : "Steps a second", rows,
        [["plain", (row) => row.frames_per_second]]),
      chart("Tests a step", rows, [["plain", (row) => row.tests / Math.max(1, row.steps)]]));
  }
  part("set-table").append(tableOf(rows, [["Set", "set"], ["Spheres", "spheres"],
    drawn ? ["Frames", "frames"] : ["Steps", "steps"],
    [drawn ? "Frames/s" : "Steps/s", "frames_per_second"], ["Running", "running"],
    ["Frozen", "frozen"], ["Discarded", "discarded"], ["Polygons", "discarded_polygons"],
    ["Tests", "tests"]]));
}

function tableOf(rows, columns) {
  const table = document.createElement("table");
  const heading = table.createTHead().insertRow();
  for (const [title] of columns) {
    const cell = document.createElement("th");
    cell.scope = "col";
    cell.textContent = title;
    heading.append(cell);
  }
  const body = table.createTBody();
  for (const row of rows) {
    const line = body.insertRow();
    for (const [, name] of columns) {
      line.insertCell().textContent = readable(row[name]);
    }
  }
  return table;
}

/** Both cumulative curves by mass, with a point at each sieve. */
function sizesChart(points) {
  const [first, last] = [points[0].radius, points[points.length - 1].radius];
  const { picture, x, y, mark } =
    plane(120, "Share of the mass up to a radius: a line as asked, points as achieved", [first, last], 1,
      (share) => `${100 * share} %`);
  const asked = points.map((point) => `${x(point.radius)} ${y(point.asked_by_mass)}`).join("L");
  picture.append(svg("path", { class: "plain line", d: `M${asked}` }));
  for (const point of points) {
    picture.append(svg("circle", { class: "frozen", cx: x(point.radius), cy: y(point.by_mass), r: 2.5 }));
  }
  mark(first, "start", readable(first));
  mark(last, "end", readable(last));
  return picture;
}

/** Of a run with a size curve; otherwise nothing. */
function showSizes() {
  const sizes = facts.summary?.sizes;
  part("sizes").hidden = !sizes;
  if (sizes) {
    part("size-curve").append(figureOf(
      "Share of the mass up to a radius: line as asked, points as achieved", sizesChart(sizes.points)));
    fillList(part("size-facts"), [
      ["Farthest off, of the mass", `${(100 * sizes.deviation).toPrecision(2)} %`],
      ["At the radius", readable(sizes.at_radius)],
      ["Allowed until full", sizes.within === null ? "any" : `${readable(100 * sizes.within)} %`]]);
  }
}
