// SPDX-License-Identifier: MIT
// The size curve of a run beside the one that was asked for.

/** Both cumulative curves by mass, with a point at each sieve. */
function sizesChart(points) {
  const [width, height, left, foot] = [320, 120, 46, 18];
  const [first, last] = [points[0].radius, points[points.length - 1].radius];
  const x = (radius) => (left + (width - left - 8) * (radius - first) / Math.max(last - first, 1e-300)).toFixed(1);
  const y = (share) => (height - foot - (height - foot - 8) * share).toFixed(1);
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img",
    "aria-label": "Share of the mass up to a radius: a line as asked, points as achieved" });
  rules(picture, left, width - 8, y, (share) => `${100 * share} %`);
  const asked = points.map((point) => `${x(point.radius)} ${y(point.asked_by_mass)}`).join("L");
  picture.append(svg("path", { class: "plain line", d: `M${asked}` }));
  for (const point of points) {
    picture.append(svg("circle", { class: "frozen", cx: x(point.radius), cy: y(point.by_mass), r: 2.5 }));
  }
  picture.append(svg("text", { x: x(first), y: height - 4, "text-anchor": "start" }, readable(first)));
  picture.append(svg("text", { x: x(last), y: height - 4, "text-anchor": "end" }, readable(last)));
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
