// The overview: groups of similar failures with thumbnails, the selection of scenes to accept, and a table of all
// failures with their pass and tolerance.

const overview = {
  groups: [],
  chosen: new Set(),  // scenes selected for acceptance
  boxes: new Map(),  // check boxes of each scene
  most: 12,  // number of thumbnails of a group shown at first
};

// ---- thumbnails ----

/// Returns a ring that marks the worst pixel if only few pixels differ, because a single pixel is hard to see in a
/// thumbnail.
function ringAtWorst(image, metrics) {
  if (!metrics || metrics.worst === 0 || differingShare(metrics) > 0.1) return null;
  const ring = element("i", {class: "ring", hidden: true});
  image.addEventListener("load", () => {
    // The picture is scaled to fit its box and centred in it.
    const box = image.getBoundingClientRect();
    const scale = Math.min(box.width / image.naturalWidth, box.height / image.naturalHeight);
    const place = (inside, size, at) => (inside - size * scale) / 2 + (at + 0.5) * scale;
    ring.style.left = place(box.width, image.naturalWidth, metrics.worstX) + "px";
    ring.style.top = place(box.height, image.naturalHeight, metrics.worstY) + "px";
    ring.hidden = false;
  });
  return ring;
}

/// Returns a thumbnail of a scene's first failing frame. The image is loaded when it comes near the window.
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
  // The difference image is loaded and shown only while the pointer is over the thumbnail.
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

/// Returns a check box for a scene or a group of scenes.
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

/// Updates the footer: the number of selected scenes and the command that accepts them.
function showChoice() {
  const scenes = [...overview.chosen], foot = byId("choice");
  foot.hidden = scenes.length === 0;
  const command = acceptAll(scenes);
  foot.replaceChildren(
      element("b", {}, plural(scenes.length, suite.unit) + " chosen"),
      element("span", {class: "command"}, ...command ? commandLine(command, "the command that accepts what is chosen") : []),
      element("button", {class: "quiet", onclick: () => choose(scenes, false)}, "clear"));
}

/// Selects a group and copies the command that accepts it, with a single click.
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

// ---- table with one line per failure ----

/// Returns the bounds in force, such as "maxChannelDiff 12 · maxDiffRatio 0.005", and their origins.
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
  // The table is created when it comes near the window, because it may have thousands of cells.
  const place = element("section", {class: "card failures later"}, "Every failure, with its tolerance");
  byId("overviewPage").append(place);
  const near = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    near.disconnect();
    place.replaceWith(failureTable());
  }, {root: byId("scene"), rootMargin: "400px"});
  near.observe(place);
}

/// Shows the overview instead of a scene. Creates it on the first call.
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
