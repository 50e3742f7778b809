"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const $ = (id) => document.getElementById(id);
const make = (parent, name, text) => {
  const element = document.createElement(name);
  if (text !== undefined) element.textContent = text;
  parent.append(element);
  return element;
};
// Values of each parameter, numbers in order.
const values = data.names.map((_, p) => {
  const all = [...new Set(data.jobs.map((job) => job.values[p]))];
  return all.every((v) => v.trim() !== "" && isFinite(v)) ? all.sort((a, b) => a - b) : all;
});
let chosen = 0;

// Of those with this value of the parameter the job that shares most others with the present one.
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

const tiles = data.jobs.map((job, i) => {
  const tile = make($("tiles"), "button");
  tile.title = data.names.map((name, p) => `${name}=${job.values[p]}`).join("\n");
  if (job.picture) Object.assign(make(tile, "img"), { src: job.picture, alt: tile.title, loading: "lazy" });
  else make(tile, "span").className = "none";
  make(tile, "span", job.values.join(" "));
  tile.className = job.state === "done" && job.passed ? "" : "failed";
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
  // The whole picture where it lies beside the page, else the small copy in it.
  $("picture").onerror = () => { $("picture").onerror = null; $("picture").src = job.picture; };
  $("picture").src = job.file || job.picture;
  $("caption").textContent = `${job.name}: ${job.state}${job.message ? ": " + job.message : ""}`;
  $("caption").className = job.state === "done" && job.passed ? "" : "failed";
  $("numbers").textContent = "";
  data.columns.forEach((name, c) => {
    if (job.cells[c] === "") return;
    const row = make($("numbers"), "tr");
    make(row, "td", name);
    const number = Number(job.cells[c]);
    make(row, "td", isNaN(number) ? job.cells[c] : String(Number(number.toPrecision(6)))).className = job.cells[c] === "no" ? "failed" : "";
  });
}

function paint() {
  const c = data.columns.indexOf($("by").value);
  const numbers = data.jobs.map((job) => (c < 0 || job.cells[c] === "" ? NaN : Number(job.cells[c])));
  const known = numbers.filter((n) => !isNaN(n));
  const low = Math.min(...known), high = Math.max(...known);
  tiles.forEach((tile, i) => {
    const share = (numbers[i] - low) / (high - low || 1);
    tile.style.background = isNaN(numbers[i]) ? "none" : `hsl(${240 - 240 * share} 70% 50% / 0.6)`;
  });
}
make($("by"), "option", "nothing");
data.columns.forEach((name, c) => {
  if (data.jobs.some((job) => job.cells[c] !== "" && isFinite(job.cells[c]))) make($("by"), "option", name);
});
$("by").addEventListener("change", paint);
$("title").textContent = document.title = data.title;
$("summary").textContent = data.summary;
show(0);
