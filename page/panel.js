// SPDX-License-Identifier: MIT
// What is told beside the picture: name, verdict, counts, errors, machine, the command.

const kOutcomes = { full: "Full: no place is left.",
  "inlets reached": "The heap has reached the inlets.", "count reached": "All spheres are in.",
  stopped: "The run was stopped.", failed: "The run has failed." };

function fillList(list, rows) {
  for (const [term, text] of rows) {
    const row = document.createElement("div");
    for (const [name, content] of [["dt", term], ["dd", text]]) {
      const cell = document.createElement(name);
      cell.textContent = content;
      row.append(cell);
    }
    list.append(row);
  }
}

function showHeader() {
  const { summary, scene, film } = facts;
  part("name").textContent = facts.name;
  const radius = summary?.spheres
    ? `, radius ${summary.spheres.smallest_radius === summary.spheres.radius ? ""
      : `${readable(summary.spheres.smallest_radius)} to `}${readable(summary.spheres.radius)}` : "";
  part("subtitle").textContent = `${readable(film.spheres)} spheres${radius} · ` +
    `preset ${scene.preset}${scene.preset === "fast" ? `, motion ${scene.motion.mode}` : ""}`;
  const verdict = part("verdict");
  verdict.classList.toggle("bad", Boolean(summary?.failure));
  verdict.textContent = !summary ? "The run had not ended when this page was written."
    : summary.failure ? `Fault: ${summary.failure}.`
      : `${kOutcomes[summary.outcome] ?? summary.outcome} No fault was found.`;
  if (film.frames.length < film.kept) {
    part("motion-note").hidden = false;
    part("motion-note").textContent = `This page shows the last frame alone: all ` +
      `${readable(film.kept)} frames of the run would have made it too large.`;
  }
}

function showErrors() {
  const error = facts.summary?.error;
  const rows = error ? [
    ["Largest overlap of two spheres", `${readable(error.max_overlap_over_radius)} r`],
    ["Mean overlap", `${readable(error.mean_overlap_over_radius)} r`],
    ["Deepest in a wall", `${readable(error.max_wall_overlap_over_radius)} r`],
    ["Centres outside", readable(error.centres_outside)],
    ["At rest without support", readable(error.unsupported_frozen)],
    ["Energy gained", readable(error.energy_gain)],
    ["Share of the volume in spheres", `${(100 * error.packing_fraction).toFixed(1)} %`]] : [];
  const joint = error?.equilibrium;
  if (joint) {
    rows.push([`Unbalanced, friction ${readable(joint.friction)}`,
      `${readable(joint.unbalanced)} of ${readable(joint.at_rest)}`],
      ["Stands from a friction of",
        joint.least_friction === null ? "none up to 8" : readable(joint.least_friction)]);
  }
  rows.push(["Rounding of places in this page", `${readable(facts.film.error_over_radius)} r`]);
  if (facts.shell_distance) {
    rows.push(["Shell in this page", `${readable(facts.triangles)} of ` +
      `${readable(facts.mesh_triangles)} triangles, within ${readable(facts.shell_distance)} of the mesh`]);
  }
  fillList(part("errors"), rows);
}

function showMachine() {
  const { summary, version } = facts;
  const machine = summary?.machine;
  fillList(part("machine"), machine ? [
    ["Processor", `${machine.cpu}, ${machine.cores} cores`],
    ["Memory", `${Math.round(machine.memory_gib)} GiB`],
    ["System", machine.system],
    ["Compiler", `${machine.compiler}, ${machine.build}`],
    ["Drawn with", machine.renderer || "nothing"],
    ["Wall-clock time", `${readable(summary.time.wall)} s`],
    ["Time steps", `${readable(summary.time.steps)} of ${readable(summary.time.step)} s`],
    ["Frostfill", machine.frostfill]] : [["Frostfill", version]]);
}

/** The scene is in the page, so that the page alone repeats its run. */
function showCommand() {
  const { summary, scene, name } = facts;
  const file = `${name.replace(/[^\w.-]+/g, "_") || "run"}.json`;
  const { mesh } = scene.object;
  const also = /[./\\]/.test(mesh) ? ` The mesh is not in it: put ${mesh} where the scene looks for it.` : "";
  part("repeat-note").textContent = `The page holds the whole scene.${also} Save it, then run:`;
  part("command").textContent = `frostfill fill ${file} --out again`;
  part("save-summary").textContent = `Save ${file}`;
  part("save-summary").addEventListener("click", () => {
    const link = document.createElement("a");
    const text = JSON.stringify(summary ?? { scene }, null, 2);
    link.href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
    link.download = file;
    link.click();
    URL.revokeObjectURL(link.href);
  });
  part("copy-command").addEventListener("click", async () => {
    await navigator.clipboard?.writeText(part("command").textContent);
    part("copy-command").textContent = "Copied";
  });
  part("footer").textContent = `Frostfill ${facts.version}` +
    (summary?.state_hash ? ` · state ${summary.state_hash}` : "");
}

function showCounts(film) {
  const counts = film.countsAt(film.at);
  ["running", "frozen", "discarded", "polygons"].forEach((id, i) => {
    part(id).textContent = readable(counts[i]);
  });
}

/** The scale of colours that are not those of states. */
function showScale(by, look) {
  const meaning = facts.colours.find((each) => each.by === by);
  part("scale").hidden = by === "state";
  const [low, high] = part("scale").querySelectorAll("span");
  low.textContent = readable(meaning.low);
  high.textContent = `${readable(meaning.high)} ${meaning.title.match(/\[.*\]/)?.[0] ?? ""}`;
  const bar = part("scale-bar").getContext("2d");
  const pixels = bar.createImageData(256, 1);
  pixels.data.set(scaleOf(look).flat());
  bar.putImageData(pixels, 0, 0);
}

/** The page takes the colours of the look. */
function dressPage(look) {
  const root = document.documentElement.style;
  const css = ([r, g, b]) => `rgb(${Math.round(r)} ${Math.round(g)} ${Math.round(b)})`;
  root.setProperty("--ground", css(opaque(look.background)));
  root.setProperty("--ink", css(look.text));
  for (const name of ["running", "frozen", "discarded"]) {
    root.setProperty(`--${name}`, css(look[name]));
  }
  root.setProperty("--polygon", css(look.discarded_polygon));
  const isDark = look.background.slice(0, 3).reduce((a, b) => a + b) < 384;
  root.setProperty("color-scheme", isDark ? "dark" : "light");
}
