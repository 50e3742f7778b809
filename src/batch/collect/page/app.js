"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const $ = (id) => document.getElementById(id);
const make = (parent, name, text) => {
  const element = document.createElement(name);
  if (text !== undefined) element.textContent = text;
  parent.append(element);
  return element;
};
// distinct values of each parameter; numbers are in ascending order
const values = data.names.map((_, p) => {
  const all = [...new Set(data.jobs.map((job) => job.values[p]))];
  return all.every((v) => v.trim() !== "" && isFinite(v)) ? all.sort((a, b) => a - b) : all;
});
let chosen = 0;

// Returns the index of the job that has this value of the parameter and agrees with the chosen job in the most other
// values.
function nearest(parameter, value) {
  const now = data.jobs[chosen].values;
  let best = -1, found = chosen;
  data.jobs.forEach((job, i) => {
    if (job.values[parameter] !== value) return;
    const shared = job.values.filter((v, p) => v === now[p]).length;
    if (shared > best) [best, found] = [shared, i];
  });
  return found;
}

const sliders = data.names.map((name, p) => {
  const label = make($("sliders"), "label", name);
  const output = make(label, "output");
  const input = make(label, "input");
  Object.assign(input, { type: "range", min: 0, max: values[p].length - 1, step: 1 });
  input.addEventListener("input", () => show(nearest(p, values[p][input.value])));
  return { input, output };
});

// In a grid, the last parameter varies from left to right, all others from top to bottom.
const across = values.length > 1 ? values[values.length - 1] : [];
const isGrid = across.length > 1 && across.length <= 16 && data.jobs.length % across.length === 0 &&
  data.jobs.every((job, i) => job.values.every((value, p) =>
    p === values.length - 1 ? value === data.jobs[i % across.length].values[p]
                            : value === data.jobs[i - i % across.length].values[p]));
if (isGrid) {
  $("tiles").style.gridTemplateColumns = `max-content repeat(${across.length}, minmax(4.5rem, 12rem))`;
  make($("tiles"), "span");
  for (let c = 0; c < across.length; ++c)
    make($("tiles"), "span", `${data.names.at(-1)}\n${data.jobs[c].values.at(-1)}`).className = "head";
}

const tiles = data.jobs.map((job, i) => {
  if (isGrid && i % across.length === 0)
    make($("tiles"), "span", data.names.slice(0, -1).map((name, p) => `${name}\n${job.values[p]}`).join("\n")).className = "head row";
  const tile = make($("tiles"), "button");
  const well = job.state === "done" && job.passed;
  tile.title = [job.name, ...data.names.map((name, p) => `${name}=${job.values[p]}`), ...(well ? [] : [job.message || job.state])].join("\n");
  if (job.picture) Object.assign(make(tile, "img"), { src: job.picture, alt: tile.title, loading: "lazy" });
  else make(tile, "span").className = "none";
  if (!isGrid) make(tile, "span", job.values.join(" "));
  if (!well) make(tile, "span", (isGrid ? "" : " ") + (job.state === "done" ? "\u2717 check" : job.state));
  tile.className = well ? "" : "failed";
  tile.addEventListener("click", () => show(i));
  return tile;
});

function show(i) {
  chosen = i;
  const job = data.jobs[i];
  sliders.forEach(({ input, output }, p) => {
    input.value = values[p].indexOf(job.values[p]);
    output.textContent = job.values[p];
  });
  tiles.forEach((tile, k) => tile.setAttribute("aria-pressed", k === i));
  // Shows the full picture if it exists next to the page, and otherwise the small copy inside the page.
  $("picture").onerror = () => { $("picture").onerror = null; $("picture").src = job.picture; };
  $("picture").src = job.file || job.picture;
  $("caption").textContent = `${job.name}: ${job.state}${job.message ? ": " + job.message : ""}`;
  $("caption").className = job.state === "done" && job.passed ? "" : "failed";
  $("numbers").textContent = "";
  make($("numbers"), "caption", "At the last frame");
  data.columns.forEach((name, c) => {
    if (name.startsWith("passed ")) return;  // The row of the check shows this value.
    const passed = name.startsWith("check ") ? job.cells[data.columns.indexOf("passed " + name.slice(6))] : undefined;
    if (job.cells[c] === "" && !passed) return;
    const row = make($("numbers"), "tr");
    make(row, "td", name);
    const number = Number(job.cells[c]);
    const text = job.cells[c] === "" || isNaN(number) ? job.cells[c] : String(Number(number.toPrecision(6)));
    const cell = make(row, "td", passed ? `${text} ${passed === "yes" ? "\u2713" : "\u2717"}` : text);
    if (passed) cell.className = passed === "yes" ? "passed" : "failed";
  });
}

// Returns a colour from blue through grey to orange, which color-blind readers can tell apart on light and dark
// backgrounds. `share` is 0 to 1.
const color = (share) => share < 0.5 ? `hsl(215 ${90 - 160 * share}% ${50 + 20 * share}%)` : `hsl(28 ${160 * share - 70}% ${70 - 20 * share}%)`;

function paint() {
  const c = data.columns.indexOf($("by").value);
  const numbers = data.jobs.map((job) => (c < 0 || job.cells[c] === "" ? NaN : Number(job.cells[c])));
  const known = numbers.filter((n) => !isNaN(n));
  const low = Math.min(...known), high = Math.max(...known);
  tiles.forEach((tile, i) => {
    tile.style.background = isNaN(numbers[i]) ? "none" : color((numbers[i] - low) / (high - low || 1));
  });
  $("scale").hidden = c < 0;
  if (c < 0) return;
  $("low").textContent = Number(low.toPrecision(4));
  $("high").textContent = Number(high.toPrecision(4));
  $("ramp").style.setProperty("--ramp", [0, 0.25, 0.5, 0.75, 1].map(color).join(","));
}
make($("by"), "option", "nothing");
data.columns.forEach((name, c) => {
  if (data.jobs.some((job) => job.cells[c] !== "" && isFinite(job.cells[c]))) make($("by"), "option", name);
});
$("by").addEventListener("change", paint);
$("title").textContent = document.title = data.title;
$("summary").textContent = data.summary;
show(0);
