// The frames of the scene: a strip of thumbnails, and a curve of a measurement over the frames.

const strip = {observer: null, scene: null};
const curve = {points: [], toX: null};

const curveChosen = () => curves.find((one) => one.id === byId("metric").value);

// ---- strip ----

/// Creates the image of a thumbnail while it is visible and removes it afterwards.
function tileVisible(entries) {
  for (const entry of entries) {
    const frame = strip.scene.frames[Number(entry.target.dataset.index)];
    const slot = entry.target.querySelector(".slot");
    const wanted = entry.isIntersecting && frame ? frame.actualImage || frame.expectedImage : "";
    if (!wanted) slot.querySelector("img")?.remove();
    else if (!slot.querySelector("img"))
      slot.prepend(element("img", {src: link(wanted), alt: "", decoding: "async", draggable: "false"}));
  }
}

function tile(frame, index) {
  return element("button", {
    class: "tile " + frame.status, "data-index": index,
    "aria-label": "Frame " + frame.frame + ", " + statusWords[frame.status],
    title: "frame " + frame.frame + ", " + format(frame.time) + " s: " + (ownMessage(frame) || statusWords[frame.status]),
    onclick: () => go({frame: index}),
  },
  element("span", {class: "slot"}, hasPictures(frame) ? null : statusGlyphs[frame.status]),
  element("span", {class: "number"}, String(frame.frame)));
}

function showStrip() {
  const box = byId("strip");
  if (strip.scene !== state.scene) {
    if (strip.observer) strip.observer.disconnect();
    strip.scene = state.scene;
    strip.observer = new IntersectionObserver(tileVisible, {root: box});
    box.replaceChildren(...state.scene.frames.map(tile));
    box.scrollLeft = 0;
    for (const one of box.children) strip.observer.observe(one);
  }
  for (const [index, one] of [...box.children].entries()) {
    if (index === state.frame) one.setAttribute("aria-current", "true");
    else one.removeAttribute("aria-current");
  }
  const current = box.children[state.frame];
  if (current && (current.offsetLeft < box.scrollLeft ||
                  current.offsetLeft + current.offsetWidth > box.scrollLeft + box.clientWidth))
    box.scrollLeft = current.offsetLeft - (box.clientWidth - current.offsetWidth) / 2;
}

// ---- curve ----

const curveArea = {left: 62, right: 14, top: 12, bottom: 18, height: 104};  // margins and height of the curve in px

function curveScales(scene, chosen, width) {
  const values = scene.frames.map((frame) => curveValue(chosen, frame));
  const given = chosen.bound ? scene.tolerance[chosen.bound] : undefined;
  const bound = given && !noneMayDiffer(scene.asked) ? given.value : null;
  const most = Math.max(...values.filter((value) => value !== null), 0);
  // A bound far above all measurements is hidden, because it would flatten the curve.
  const showBound = bound !== null && bound <= most * 8 + 1e-12;
  const top = Math.max(most, showBound ? bound : 0) || 1;
  const numbers = scene.frames.map((frame) => frame.frame);
  const first = Math.min(...numbers), last = Math.max(...numbers);
  const inner = width - curveArea.left - curveArea.right;
  const share = (frame) => last === first ? 0.5 : clamp((frame - first) / (last - first), 0, 1);
  const toX = (frame) => curveArea.left + share(frame) * inner;
  const bottom = curveArea.height - curveArea.bottom;
  const toY = (value) => bottom - value / top * (bottom - curveArea.top);
  const measured = values.some((value) => value !== null);
  return {values, measured, bound: showBound ? bound : null, most, top, first, last, toX, toY, bottom};
}

function curveLine(x1, y1, x2, y2, name) {
  return svgElement("line", {x1, y1, x2, y2, class: name});
}

function curveText(x, y, anchor, text, name) {
  return svgElement("text", {x, y, "text-anchor": anchor, class: name || ""}, text);
}

/// Returns line segments between consecutive measured frames.
function curvePath(scene, scales) {
  let path = "", open = false;
  scene.frames.forEach((frame, i) => {
    if (scales.values[i] !== null)
      path += `${open ? "L" : "M"}${scales.toX(frame.frame).toFixed(1)} ${scales.toY(scales.values[i]).toFixed(1)}`;
    open = scales.values[i] !== null;
  });
  return svgElement("path", {d: path, class: "line"});
}

function curveDots(scene, scales, chosen) {
  return scene.frames.map((frame, i) => {
    const value = scales.values[i];
    const dot = svgElement("circle", {
      cx: scales.toX(frame.frame), cy: value === null ? scales.bottom : scales.toY(value),
      r: i === state.frame ? 5 : scene.frames.length > 80 ? 2.5 : 3.5,
      class: "dot " + frame.status + (value === null ? " gap" : "") + (i === state.frame ? " current" : ""),
    });
    const text = value === null ? "not measured" : chosen.label + " " + chosen.text(value);
    dot.append(svgElement("title", {}, "frame " + frame.frame + ": " + text));
    return dot;
  });
}

function divergenceMark(scene, scales, width) {
  const d = scene.divergence;
  const x = scales.toX(d.frame);
  const end = x > width * 0.6;
  const text = "leaves the baseline: frame " + d.frame + (d.step > 0 ? ", step " + d.step + "/" + d.steps : "");
  return [
    curveLine(x, curveArea.top - 4, x, scales.bottom, "diverges"),
    curveText(x + (end ? -5 : 5), curveArea.top + 4, end ? "end" : "start", text, "diverges"),
  ];
}

function showCurve() {
  const svg = byId("curve"), scene = state.scene, chosen = curveChosen();
  const width = svg.clientWidth || 600;
  svg.replaceChildren();
  svg.style.display = byId("curveChoice").style.display = scene.frames.length === 0 ? "none" : "";
  if (scene.frames.length === 0) return;
  const scales = curveScales(scene, chosen, width);
  curve.toX = scales.toX;
  svg.setAttribute("viewBox", `0 0 ${width} ${curveArea.height}`);
  const most = scales.measured ? "at most " + chosen.text(scales.most) : "not measured";
  svg.setAttribute("aria-label", `${chosen.label} by frame, ${most}`);
  const right = width - curveArea.right, left = curveArea.left;
  const below = curveArea.height - 4;
  svg.append(curveLine(left, scales.bottom, right, scales.bottom, "axis"),
             curveLine(left, curveArea.top, left, scales.bottom, "axis"),
             curveText(left - 6, curveArea.top + 4, "end", scales.measured ? chosen.text(scales.top) : ""),
             curveText(left - 6, scales.bottom + 3, "end", "0"),
             curveText(scales.toX(scales.first), below, "middle", String(scales.first)));
  if (scales.last !== scales.first) svg.append(curveText(right, below, "middle", String(scales.last)));
  if (scales.bound !== null) {
    const y = scales.toY(scales.bound);
    const text = chosen.bound + " " + chosen.text(scales.bound);
    svg.append(curveLine(left, y, right, y, "bound"), curveText(right, y - 3, "end", text, "bound"));
  }
  const current = frameOf(scene);
  if (current) {
    const x = scales.toX(current.frame);
    svg.append(curveLine(x, curveArea.top - 4, x, scales.bottom, "cursor"));
  }
  svg.append(curvePath(scene, scales), ...curveDots(scene, scales, chosen));
  if (scene.divergence) svg.append(...divergenceMark(scene, scales, width));
}

/// Selects the frame nearest to the click.
function clickCurve(event) {
  if (!curve.toX || state.scene.frames.length === 0) return;
  const x = event.clientX - byId("curve").getBoundingClientRect().left;
  const away = state.scene.frames.map((frame) => Math.abs(curve.toX(frame.frame) - x));
  go({frame: away.indexOf(Math.min(...away))});
}

// ---- strip and curve ----

function stepFrame(step) {
  if (!state.scene || state.scene.frames.length === 0) return;
  go({frame: clamp(state.frame + step, 0, state.scene.frames.length - 1)});
}

function showFrames() {
  const scene = state.scene, frame = frameOf(scene);
  byId("time").hidden = ofPictures || scene.frames.length === 0;
  if (!frame) return;
  byId("frame").textContent = "frame " + frame.frame;
  byId("previous").disabled = state.frame === 0;
  byId("next").disabled = state.frame === scene.frames.length - 1;
  byId("frameMessage").replaceChildren(
      element("span", {}, format(frame.time) + " s · " + (state.frame + 1) + " of " + scene.frames.length), " ",
      badge(frame.status), " ", ownMessage(frame));
  showStrip();
  showCurve();
}

function startFrames() {
  for (const one of curves) byId("metric").append(element("option", {value: one.id}, one.label));
  byId("metric").value = "ratioBeyond";
  byId("metric").addEventListener("change", showCurve);
  byId("previous").addEventListener("click", () => stepFrame(-1));
  byId("next").addEventListener("click", () => stepFrame(1));
  byId("curve").addEventListener("click", clickCurve);
  new ResizeObserver(() => state.scene && showCurve()).observe(byId("curve"));
}
