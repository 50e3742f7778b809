// Connects the parts of the page: the selection, the link in the address bar, the keyboard, light and dark theme.

/// Selects a scene, a frame (by index) or a view. Selecting only a scene shows its first failing frame.
function go(change, keepLink) {
  const scene = change.scene || state.scene;
  if (!scene) return;
  const otherScene = scene !== state.scene;
  state.view = change.view || state.view;
  state.frame = change.frame !== undefined ? change.frame : otherScene ? firstFrame(scene) : state.frame;
  state.scene = scene;
  document.body.classList.remove("overview");
  if (otherScene) {
    viewer.scale = null;
    byId("scene").scrollTop = 0;
    showHead(scene);
    showDetails(scene);
    markSelected(true);
  }
  byId("viewer").hidden = scene.frames.length === 0;
  showPictures();
  showMetrics(scene, frameOf(scene));
  showFrames();
  if (!keepLink) writeLink(otherScene);
}

// ---- link: #scene=name&frame=119&view=swipe, or #overview ----

/// The overview of groups is the start page if there are several failures.
const beginsWithOverview = failing.length > 1;

function writeLink(push) {
  const frame = frameOf(state.scene);
  const link = "#scene=" + encodeURIComponent(state.scene.name) + (frame ? "&frame=" + frame.frame : "") +
      "&view=" + state.view;
  document.title = state.scene.name + " – simreel test report";
  changeLink(link, push);
}

function changeLink(link, push) {
  if (link === location.hash) return;
  try {
    history[push ? "pushState" : "replaceState"](null, "", link);
  } catch {
    location.hash = link;
  }
}

/// Selects the scene, frame and view of the link. Returns true if the link is valid for this report.
function followLink() {
  if (location.hash === "#overview" || (location.hash === "" && beginsWithOverview)) {
    showOverview(true);
    return location.hash !== "";
  }
  const given = new URLSearchParams(location.hash.slice(1).replaceAll("+", "%2B"));
  const scene = byName.get(given.get("scene"));
  if (!scene) return false;
  const index = scene.frames.findIndex((frame) => String(frame.frame) === given.get("frame"));
  const view = views.find((one) => one.id === given.get("view"));
  go({scene, frame: index < 0 ? firstFrame(scene) : index, view: view ? view.id : "side"}, true);
  writeLink(false);
  return true;
}

/// On a narrow screen, the list and the scene are separate pages.
function showScenePage() {
  document.body.classList.remove("showList");
}
function showListPage() {
  document.body.classList.add("showList");
  markSelected(true);
  byId("list").focus({preventScroll: true});
}

/// Toggles the visibility of the list.
function toggleWide() {
  const wide = document.body.classList.toggle("wide");
  byId("wide").setAttribute("aria-pressed", String(wide));
}

// ---- light and dark ----

const themes = ["auto", "light", "dark"];

function showTheme(theme) {
  if (theme === "auto") delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = theme;
  byId("theme").textContent = {auto: "◐ auto", light: "○ light", dark: "● dark"}[theme];
  byId("theme").setAttribute("aria-label", "Colours: " + theme);
  byId("theme").title = "Colours: " + theme + " (t)";
}
function nextTheme() {
  const now = document.documentElement.dataset.theme || "auto";
  const next = themes[(themes.indexOf(now) + 1) % themes.length];
  showTheme(next);
  remember("theme", next);
}

// ---- keyboard ----

const keyGroups = [
  ["Scenes", [["j / k", "next, previous scene"], ["f / F", "next, previous failure"], ["/", "filter by text"]]],
  ["Frames", [["l / h or → / ←", "next, previous frame"], ["g / G", "first, last frame"]]],
  ["Pictures", [["1 2 3 4 5", "side by side, swipe, blink, difference, FLIP's map"], ["a", "amplified difference"], ["b", "blink; there: swap by hand"],
                ["p", "blink by timer, on and off"], ["+ / −", "zoom"], ["0", "fit"], ["o", "1:1"],
                ["w", "worst pixel"], ["m", "marks on and off"], ["shift + arrows", "pan"],
                ["wheel, drag", "zoom about the pointer, pan"]]],
  ["Report", [["v", "overview: groups of like failures"], ["c", "copy the command that accepts the scene"],
              ["s", "the whole window for pictures"], ["t", "light, dark, as the system"],
              ["?", "this help"], ["esc", "leave the filter or the help"]]],
];

const keyActions = {
  j: () => stepScene(1), k: () => stepScene(-1), l: () => stepFrame(1), h: () => stepFrame(-1),
  ArrowRight: () => stepFrame(1), ArrowLeft: () => stepFrame(-1),
  g: () => go({frame: 0}), G: () => stepFrame(Infinity),
  f: () => stepFailure(1), F: () => stepFailure(-1),
  1: () => go({view: "side"}), 2: () => go({view: "swipe"}), 3: () => go({view: "blink"}),
  4: () => go({view: "difference"}),
  5: () => views.some((view) => view.id === "flip") && go({view: "flip"}),
  a: () => go({view: "amplified"}), v: () => showOverview(), s: toggleWide, b: blinkByHand, p: () => state.view === "blink" && toggleBlinkTimer(),
  "+": () => stepZoom(1), "=": () => stepZoom(1), "-": () => stepZoom(-1), 0: () => setScale(null),
  o: () => setScale(devicePixel()), w: goToWorst, m: toggleMarks,
  c: () => byId("accept").querySelector(".copy")?.click(), t: nextTheme,
  "/": () => {
    showListPage();
    byId("filter").focus();
    byId("filter").select();
  },
  "?": () => byId("keys").showModal(),
};
const panKeys = {ArrowLeft: [60, 0], ArrowRight: [-60, 0], ArrowUp: [0, 60], ArrowDown: [0, -60]};

function keyDown(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || byId("keys").open) return;
  const inList = event.target === byId("list");
  if (event.target === byId("filter")) {
    if (event.key === "Enter" && list.shown.length > 0) go({scene: list.shown[0]});
    if (event.key === "Enter" || event.key === "Escape") byId("list").focus();
    return;
  }
  if (event.target.matches("input, select, textarea")) return;
  const listMove = {ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10, Home: -Infinity, End: Infinity}[event.key];
  let action = keyActions[event.key];
  if (event.shiftKey && panKeys[event.key]) action = () => pan(...panKeys[event.key]);
  else if (inList && listMove) action = () => stepScene(listMove);
  else if (inList && event.key === "Enter") action = showScenePage;
  if (!action) return;
  event.preventDefault();
  action();
}

function startKeys() {
  const dialog = byId("keys");
  const close = element("button", {class: "quiet", "aria-label": "Close", onclick: () => dialog.close()}, "✕");
  const line = ([key, what]) => [element("dt", {}, element("kbd", {}, key)), element("dd", {}, what)];
  const groups = keyGroups.map(([title, keys]) =>
      element("section", {}, element("h3", {}, title), element("dl", {}, ...keys.flatMap(line))));
  dialog.append(element("header", {}, element("h2", {}, "Keyboard"), close),
                element("div", {class: "groups"}, ...groups));
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  dialog.addEventListener("keydown", (event) => {
    if (event.key !== "?") return;
    event.preventDefault();
    event.stopPropagation();
    dialog.close();
  });
  byId("help").addEventListener("click", () => dialog.showModal());
  document.addEventListener("keydown", keyDown);
}

// ---- top of the page ----

function showVerdict() {
  const total = plural(suite.scenes.length, suite.unit);
  byId("verdict").className = failing.length > 0 ? "bad" : "good";
  byId("verdict").textContent = suite.scenes.length === 0 ? "no " + suite.unit + "s" :
      failing.length > 0 ? failing.length + " of " + total + " failed" : total + ": none failed";
  const stale = suite.stale.filter((one) => !one.removed).length;
  if (stale > 0) byId("verdict").textContent += ", " + plural(stale, "stale baseline");
  if (stale > 0 && suite.strict) byId("verdict").className = "bad";
  const environment = suite.environment;
  const run = [environment.driver, environment.profile, seconds(suite.seconds)];
  byId("run").textContent = run.filter(Boolean).join(" · ");
  if (!ofPictures) byId("run").title = "numerics " + environment.fingerprint + ", " + environment.memoryPath;
}

/// Adjusts the page's texts for a report about pictures instead of scenes.
function namePictures() {
  document.body.classList.add("ofPictures");
  byId("filter").placeholder = "Filter pictures  ( / )";
  byId("filter").setAttribute("aria-label", "Filter pictures by text");
  byId("back").textContent = "‹ Pictures";
  byId("back").setAttribute("aria-label", "Back to the list of pictures");
  for (const [id, label] of [["side", "Pictures"], ["list", "Pictures"], ["scene", "Picture"], ["sort", "Order of pictures"]])
    byId(id).setAttribute("aria-label", label);
  byId("sort").title = "Order of pictures";
}

function start() {
  if (ofPictures) namePictures();
  const kept = remembered("theme");
  showTheme(themes.includes(kept) ? kept : "auto");
  byId("theme").addEventListener("click", nextTheme);
  byId("back").addEventListener("click", showListPage);
  showVerdict();
  startKeys();
  startViewer();
  startPanes();
  startFrames();
  startList();
  startOverview();
  byId("wide").addEventListener("click", toggleWide);
  window.addEventListener("popstate", followLink);
  if (suite.scenes.length === 0) {
    document.body.classList.add("none");
    byId("nothing").hidden = false;
    byId("nothing").textContent = "This run tested no " + suite.unit + ".";
  } else if (location.hash !== "" && followLink()) {
    showScenePage();
    if (!state.scene) go({scene: list.shown[0]}, true), showOverview(true);
  } else {
    go({scene: list.shown[0]}, true);
    if (beginsWithOverview) showOverview(true);
  }
}

start();
