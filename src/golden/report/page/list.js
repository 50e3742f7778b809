// The list of scenes: filters by status and text, sort order, and rows that exist only while visible.

const list = {
  rowHeight: 46,  // height of a row in px; must match style.css
  hidden: new Set(),  // statuses whose scenes are hidden
  shown: [],  // filtered and sorted scenes that the list shows
  rows: new Map(),    // row elements by index
};

function listOrders() {
  const rank = (scene) => statusOrder.indexOf(scene.status);
  const name = (a, b) => natural(a.name, b.name);
  const worst = new Map(suite.scenes.map(
      (scene) => [scene, [largest(scene, (m) => m.ratioBeyond), largest(scene, (m) => m.worst)]]));
  return {
    status: (a, b) => rank(a) - rank(b) || name(a, b),
    worst: (a, b) => worst.get(b)[0] - worst.get(a)[0] || worst.get(b)[1] - worst.get(a)[1] || name(a, b),
    seconds: (a, b) => b.seconds - a.seconds || name(a, b),
    name,
  };
}

/// Returns the second line of a scene's row: the reason for its status.
function summary(scene) {
  if (scene.status === "xfail" && scene.xfail) return scene.xfail;
  return scene.messages[0] || scene.notes[0] || (ofPictures ? statusWords[scene.status] : plural(scene.frames.length, "frame"));
}

/// Returns one small mark per frame. If there are many frames, a mark represents several and shows their worst status.
function frameMarks(scene) {
  const most = 12;
  const marks = element("span", {class: "ticks", "aria-hidden": "true"});
  const count = Math.min(most, scene.frames.length);
  for (let i = 0; i < count; ++i) {
    const from = Math.floor(i * scene.frames.length / count);
    const to = Math.floor((i + 1) * scene.frames.length / count);
    const ranks = scene.frames.slice(from, to).map((frame) => statusOrder.indexOf(frame.status));
    marks.append(element("i", {class: statusOrder[Math.min(...ranks)]}));
  }
  return marks;
}

/// Returns the thumbnail of a row. Rows and thumbnails exist only while visible.
function rowPicture(scene) {
  const frame = tellingFrame(scene), path = frame && (frame.actualImage || frame.expectedImage);
  return element("span", {class: "rowPicture"},
                 path ? element("img", {src: link(path), alt: "", decoding: "async", draggable: "false"}) : null);
}

function listRow(scene, index) {
  const row = element("div", {
    class: "row", role: "option", id: "row" + index, "aria-posinset": index + 1, "aria-setsize": list.shown.length,
    style: "top:" + index * list.rowHeight + "px", title: scene.name + "\n" + summary(scene),
    "aria-label": scene.name + ", " + statusWords[scene.status],
  },
  element("span", {class: "glyph " + scene.status, "aria-hidden": "true"}, statusGlyphs[scene.status]),
  rowPicture(scene),
  element("span", {class: "rowName"}, element("bdi", {dir: "ltr"}, scene.name)), frameMarks(scene),
  element("span", {class: "why"}, summary(scene)));
  row.addEventListener("click", () => {
    showScenePage();
    go({scene});
  });
  return row;
}

/// Creates the rows near the visible part and removes the others.
function drawRows() {
  const box = byId("list");
  const first = Math.max(0, Math.floor(box.scrollTop / list.rowHeight) - 6);
  const last = Math.min(list.shown.length, Math.ceil((box.scrollTop + box.clientHeight) / list.rowHeight) + 6);
  for (const [index, row] of list.rows) {
    if (index >= first && index < last) continue;
    row.remove();
    list.rows.delete(index);
  }
  for (let index = first; index < last; ++index) {
    if (!list.rows.has(index)) {
      const row = listRow(list.shown[index], index);
      list.rows.set(index, row);
      byId("rows").append(row);
    }
    list.rows.get(index).setAttribute("aria-selected", String(list.shown[index] === state.scene));
  }
}

function markSelected(scroll) {
  const box = byId("list");
  const index = list.shown.indexOf(state.scene);
  if (index >= 0 && scroll) {
    const top = index * list.rowHeight;
    if (top < box.scrollTop) box.scrollTop = top;
    else if (top + list.rowHeight > box.scrollTop + box.clientHeight)
      box.scrollTop = top + list.rowHeight - box.clientHeight;
  }
  drawRows();
  if (index >= 0) box.setAttribute("aria-activedescendant", "row" + index);
  else box.removeAttribute("aria-activedescendant");
}

function filterList() {
  const words = byId("filter").value.toLowerCase().split(/\s+/).filter(Boolean);
  const fits = (scene) => {
    if (list.hidden.has(scene.status)) return false;
    const text = [scene.name, scene.file, ...scene.messages].join("\n").toLowerCase();
    return words.every((word) => text.includes(word));
  };
  list.shown = suite.scenes.filter(fits).sort(list.orders[byId("sort").value]);
  list.rows.clear();
  byId("rows").replaceChildren();
  byId("rows").style.height = list.shown.length * list.rowHeight + "px";
  byId("shown").textContent = list.shown.length === suite.scenes.length ?
      plural(suite.scenes.length, suite.unit) :
      list.shown.length + " of " + plural(suite.scenes.length, suite.unit) + " shown";
  markSelected(true);
}

function showStatuses(hidden) {
  list.hidden = hidden;
  for (const chip of byId("statuses").querySelectorAll("[data-status]"))
    chip.setAttribute("aria-pressed", String(!hidden.has(chip.dataset.status)));
  filterList();
}

function startList() {
  list.orders = listOrders();
  const present = statusOrder.filter((status) => suite.scenes.some((scene) => scene.status === status));
  for (const status of present) {
    const count = suite.scenes.filter((scene) => scene.status === status).length;
    const chip = element("button", {
      class: "chip " + status, "data-status": status, "aria-pressed": "true",
      "aria-label": statusWords[status] + ": " + count,
      title: statusWords[status] + ": show or hide (with Alt: only these)",
    },
    element("b", {}, String(count)), " " + statusShort[status]);
    chip.addEventListener("click", (event) => {
      const hidden = new Set(event.altKey ? present : list.hidden);
      if (hidden.has(status)) hidden.delete(status);
      else hidden.add(status);
      showStatuses(hidden);
    });
    byId("statuses").append(chip);
  }
  if (present.length > 1 && failing.length > 0) {
    byId("statuses").append(
        element("button", {class: "only", id: "onlyFailing", title: "Hide what did not fail",
                           onclick: () => showStatuses(new Set(present.filter((s) => !isFailure(s))))},
                "only failures"),
        element("button", {class: "only", id: "allStatuses", onclick: () => showStatuses(new Set())}, "all"));
  }
  byId("filter").addEventListener("input", filterList);
  byId("sort").addEventListener("change", filterList);
  byId("list").addEventListener("scroll", drawRows, {passive: true});
  new ResizeObserver(drawRows).observe(byId("list"));
  filterList();
}

/// Selects the scene `step` rows below the current one in the list.
function stepScene(step) {
  if (list.shown.length === 0) return;
  const at = list.shown.indexOf(state.scene);
  const to = at < 0 ? 0 : Math.min(list.shown.length - 1, Math.max(0, at + step));
  go({scene: list.shown[to]});
}

/// Selects the next (step 1) or previous (step -1) failed frame in this scene or in the next failing scene. Wraps
/// around at the ends of the list.
function stepFailure(step) {
  const failed = (frame) => isFailure(frame.status);
  const scenes = list.shown.filter((scene) => isFailure(scene.status) || scene === state.scene);
  if (scenes.length === 0) return;
  const indices = (scene) => [...scene.frames.keys()].filter((i) => failed(scene.frames[i]));
  const at = scenes.indexOf(state.scene);
  if (at >= 0) {
    const rest = indices(state.scene).filter((i) => step > 0 ? i > state.frame : i < state.frame);
    if (rest.length > 0) return go({frame: step > 0 ? rest[0] : rest[rest.length - 1]});
  }
  // A scene that is not in the list counts as before the first scene (step 1) or after the last one (step -1).
  const scene = scenes[(Math.max(at, step > 0 ? -1 : 0) + step + scenes.length) % scenes.length];
  const found = indices(scene);
  go({scene, frame: found.length === 0 ? firstFrame(scene) : step > 0 ? found[0] : found[found.length - 1]});
}
