// The overview: groups of like failures with small pictures, what is chosen of them to be accepted, and a line for each
// failure with its pass and its tolerance.

const overview = {
  groups: [],
  chosen: new Set(),  // scenes
  boxes: new Map(),   // scene -> its check boxes
  most: 12,           // pictures of a group that are shown at first
};

// ---- small pictures ----

/// A ring around the worst pixel where few differ: in a small picture nobody would find it.
function ringAtWorst(image, metrics) {
  if (!metrics || metrics.worst === 0 || differingShare(metrics) > 0.1) return null;
  const ring = element("i", {class: "ring", hidden: true});
  image.addEventListener("load", () => {
    // The picture is fitted into its box, in the middle.
    const box = image.getBoundingClientRect();
    const scale = Math.min(box.width / image.naturalWidth, box.height / image.naturalHeight);
    const place = (inside, size, at) => (inside - size * scale) / 2 + (at + 0.5) * scale;
    ring.style.left = place(box.width, image.naturalWidth, metrics.worstX) + "px";
    ring.style.top = place(box.height, image.naturalHeight, metrics.worstY) + "px";
    ring.hidden = false;
  });
  return ring;
}

/// The picture of a scene's telling frame, loaded once it comes near the window.
function smallPicture(scene) {
  const frame = tellingFrame(scene);
  const path = frame && (frame.actualImage || frame.expectedImage);
  if (!path) return element("span", {class: "small none " + scene.status}, statusGlyphs[scene.status]);
  const image = element("img", {loading: "lazy", decoding: "async", alt: "", draggable: "false"});
  const ring = ringAtWorst(image, frame.metrics);
  image.src = link(path);
  const difference = frame.differenceImage ?
      element("img", {loading: "lazy", decoding: "async", alt: "", class: "over", draggable: "false"}) : null;
  const box = element("span", {class: "small"}, image, difference, ring);
  // The difference shows under the pointer; nobody else needs its file.
  if (difference) box.addEventListener("pointerenter", () => difference.src = link(frame.differenceImage), {once: true});
  return box;
}

function openScene(scene) {
  showScenePage();
  go({scene});
}

function thumbnail(scene) {
  const frame = tellingFrame(scene), metrics = frame && frame.metrics;
  const facts = metrics ? "worst " + format(metrics.worst, 3) + " · " + percent(differingShare(metrics)) : summary(scene);
  return element("li", {class: "thumb"},
      element("button", {class: "look", title: scene.name + "\n" + summary(scene), onclick: () => openScene(scene)},
              smallPicture(scene), element("span", {class: "thumbName"}, ofPictures ? scene.name.split("/").pop() : scene.name), element("span", {class: "dim"}, facts)),
      acceptCommand(scene) ? chooser([scene], "choose " + scene.name) : null);
}

// ---- choosing ----

/// A check box for one scene or a group of them.
function chooser(scenes, label) {
  const box = element("input", {type: "checkbox", class: "choose", "aria-label": label, title: label});
  box.addEventListener("change", () => choose(scenes, box.checked));
  for (const scene of scenes) {
    if (!overview.boxes.has(scene)) overview.boxes.set(scene, new Set());
    overview.boxes.get(scene).add(box);
  }
  box.scenes = scenes;
  showChosen(box);
  return box;
}

function showChosen(box) {
  const count = box.scenes.filter((scene) => overview.chosen.has(scene)).length;
  box.checked = count === box.scenes.length;
  box.indeterminate = count > 0 && !box.checked;
}

function choose(scenes, on) {
  const boxes = new Set();
  for (const scene of scenes) {
    if (on) overview.chosen.add(scene);
    else overview.chosen.delete(scene);
    for (const box of overview.boxes.get(scene) || []) boxes.add(box);
  }
  boxes.forEach(showChosen);
  showChoice();
}

/// What is chosen, at the foot of the page, with the command that accepts it.
function showChoice() {
  const scenes = [...overview.chosen], foot = byId("choice");
  foot.hidden = scenes.length === 0;
  const command = acceptAll(scenes);
  foot.replaceChildren(
      element("b", {}, plural(scenes.length, suite.unit) + " chosen"),
      element("span", {class: "command"}, ...command ? commandLine(command, "the command that accepts what is chosen") : []),
      element("button", {class: "quiet", onclick: () => choose(scenes, false)}, "clear"));
}

/// One click: the group is chosen, and its command in the clipboard.
function acceptGroup(group, button) {
  const scenes = group.scenes.filter(acceptCommand);
  choose([...overview.chosen], false);
  choose(scenes, true);
  const text = button.textContent;
  copyText(acceptAll(scenes)).then((copied) => {
    button.textContent = copied ? "✓ command copied" : "select the command below";
    setTimeout(() => button.textContent = text, 1800);
  });
}

// ---- groups ----

function groupCard(group) {
  const scenes = group.scenes, kept = scenes.filter(acceptCommand);
  const thumbs = element("ul", {class: "thumbs"}, ...scenes.slice(0, overview.most).map(thumbnail));
  const more = element("button", {class: "link"}, "all " + scenes.length);
  more.addEventListener("click", () => {
    thumbs.append(...scenes.slice(overview.most).map(thumbnail));
    more.remove();
  });
  const accept = element("button", {class: "accept"}, kept.length === 1 ? "accept it" : "accept these " + kept.length);
  accept.title = "Choose these, and copy the command that accepts them";
  accept.addEventListener("click", () => acceptGroup(group, accept));
  return element("section", {class: "group " + group.status + (scenes.length < 3 ? " few" : ""), "aria-label": group.words.join(", ")},
      element("header", {},
              kept.length > 0 ? chooser(kept, "choose this group") : null,
              element("span", {class: "count"}, String(scenes.length)),
              element("h3", {}, group.words[0], element("small", {}, group.words.slice(1).join(" · "))),
              element("span", {class: "badge " + group.status}, statusGlyphs[group.status] + " " + statusShort[group.status]),
              kept.length > 0 ? accept : null),
      thumbs, scenes.length > overview.most ? more : null);
}

// ---- every failure in a line ----

/// The bounds in force: "worst ≤ 12 · pixels ≤ 0.5 %", and who set them.
function toleranceText(scene) {
  if (noneMayDiffer(scene.asked)) return ["none: has to be equal", ""];
  const bounds = Object.entries(scene.tolerance).filter(([name]) => name !== "windowSize");
  const origins = new Set(bounds.map(([, bound]) => bound.origin).filter((origin) => origin !== "default"));
  return [bounds.map(([name, bound]) => name + " " + format(bound.value)).join(" · "), [...origins].join(", ")];
}

function failureLine(scene) {
  const frame = tellingFrame(scene), metrics = frame && frame.metrics;
  const [tolerance, origin] = toleranceText(scene);
  const name = element("button", {class: "link", onclick: () => openScene(scene)}, breakable(scene.name));
  const pass = frame && frame.pass ? frame.pass.pass : "";
  return {class: scene.status, cells: [
    name, ...ofPictures ? [] : [frame ? String(frame.frame) : "", pass || (scene.divergence ? "state" : "")],
    metrics ? format(metrics.worst, 3) : "", metrics ? percent(metrics.ratioBeyond) : "",
    metrics ? format(metrics.flipMean, 3) : "",
    element("span", {}, tolerance, origin ? element("small", {class: "dim"}, " by ", breakable(origin)) : null),
  ]};
}

function failureTable() {
  const heads = [suite.unit, ...ofPictures ? [] : ["frame", "first differs in"], "worst", "pixels beyond", "FLIP", "tolerance"];
  return table("Every failure, with its tolerance", "failures", heads,
               overview.groups.flatMap((group) => group.scenes).map(failureLine));
}

// ---- the page ----

function makeOverview() {
  overview.groups = groupsOf(failing);
  const kept = failing.filter(acceptCommand);
  byId("overviewPage").replaceChildren(
      element("div", {class: "overviewHead"},
              element("h2", {}, plural(failing.length, suite.unit) + " failed"),
              element("span", {class: "dim"}, "in " + plural(overview.groups.length, "group") + " of like differences"),
              kept.length > 0 ? element("label", {class: "all"}, chooser(kept, "choose all"), " all") : null),
      ...overview.groups.map(groupCard));
  // Made when it comes near: it may have thousands of cells.
  const place = element("section", {class: "card failures later"}, "Every failure, with its tolerance");
  byId("overviewPage").append(place);
  const near = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    near.disconnect();
    place.replaceWith(failureTable());
  }, {root: byId("scene"), rootMargin: "400px"});
  near.observe(place);
}

/// Instead of a scene. Made when it is first asked for.
function showOverview(keepLink) {
  if (failing.length === 0) return;
  if (overview.groups.length === 0) makeOverview();
  document.body.classList.add("overview");
  document.title = plural(failing.length, suite.unit) + " failed – simreel test report";
  byId("scene").scrollTop = 0;
  if (keepLink) return;
  showScenePage();
  changeLink("#overview", true);
}

function startOverview() {
  byId("toOverview").hidden = failing.length === 0;
  byId("toOverview").addEventListener("click", () => showOverview());
}
