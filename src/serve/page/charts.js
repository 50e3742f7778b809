// Draws charts of the numbers that objects count and measure, and shows the times that the latest picture took.
import { element, number } from "./dom.js";

const svg = (name, attributes) => {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
};

const boundsOf = (series, checks) => checks.filter((check) => check.what === series.name && !check.of &&
  (!check.object || check.object === series.object));

function chart(series, checks, frame, frames) {
  const known = series.values.map((value, i) => [series.frames[i], value]).filter(([, value]) => value !== null);
  const bounds = boundsOf(series, checks).flatMap((check) => [check.min, check.max]).filter((value) => value !== null);
  const values = known.map(([, value]) => value);
  let [low, high] = [Math.min(...values), Math.max(...values)];
  // The chart includes the bounds of checks if they are near the curve. Distant bounds would flatten the curve.
  const reach = high - low || Math.abs(high) || 1;
  for (const bound of bounds) {
    if (bound < low && low - bound < reach) low = bound;
    if (bound > high && bound - high < reach) high = bound;
  }
  if (high === low) [low, high] = [low - 1, high + 1];
  const x = (at) => (168 * at) / Math.max(1, frames - 1);
  const y = (value) => 54 - (50 * (value - low)) / (high - low);
  const picture = svg("svg", { viewBox: "0 0 168 58", preserveAspectRatio: "none" });
  for (const bound of bounds)
    if (bound >= low && bound <= high)
      picture.append(svg("line", { x1: 0, x2: 168, y1: y(bound), y2: y(bound), class: "bound" }));
  picture.append(svg("line", { x1: x(frame), x2: x(frame), y1: 0, y2: 58 }));
  picture.append(svg("path", { d: known.map(([at, value], i) => `${i ? "L" : "M"}${x(at).toFixed(1)} ${y(value).toFixed(1)}`).join("") +
    (known.length === 1 ? "h1" : "") }));
  const here = known.find(([at]) => at === frame) ?? known[known.length - 1];
  const outside = boundsOf(series, checks).some((check) => here &&
    ((check.min !== null && here[1] < check.min) || (check.max !== null && here[1] > check.max)));
  return element("div", { class: `chart${outside ? " bad" : ""}`, title: `${series.object}: ${series.name}` },
    element("header", {}, element("span", {}, `${series.object} · ${series.name}`),
      element("b", {}, here ? `${number(here[1])} ${series.unit}` : "")), picture);
}

export function showCharts(into, series, checks, frame, frames) {
  const shown = series.filter((one) => one.values.length > 0);
  // Series with checks come first.
  const held = (one) => (boundsOf(one, checks).length > 0 ? 0 : 1);
  shown.sort((a, b) => held(a) - held(b));
  into.replaceChildren(...shown.slice(0, 12).map((one) => chart(one, checks, frame, frames)));
}

export function showTimes(into, took, status) {
  const most = Math.max(16, ...Object.values(took));
  const rows = Object.entries(took).map(([name, ms]) => {
    const bar = element("i", {});
    bar.style.width = `${(100 * ms) / most}%`;
    return element("div", { class: "time" }, element("span", { class: "quiet" }, name),
      element("span", { class: "bar" }, bar), element("output", {}, ms < 1000 ? `${ms.toFixed(1)} ms` : `${(ms / 1000).toFixed(1)} s`));
  });
  const rate = status.moving && status.rate ? `${status.rate.toFixed(1)} pictures/s` : "at rest";
  const kept = status.kept;
  const states = kept && kept.count ? `${kept.count} ${kept.count === 1 ? "state" : "states"} kept, every ${kept.every === 1 ? "frame" : kept.every + " frames"}` +
    `, ${Math.ceil(kept.bytes / 1048576)} of ${Math.round(kept.most / 1048576)} MiB` : "";
  into.replaceChildren(...rows, element("div", { class: "quiet", title: states }, `${rate}${states ? ` · ${kept.count} ${kept.count === 1 ? "state" : "states"} kept` : ""}`));
}
