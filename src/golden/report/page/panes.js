// Views of a frame's pictures: side by side, swipe, blink, difference, and the FLIP map if there is one.

const blink = {
  playing: !window.matchMedia("(prefers-reduced-motion: reduce)").matches,
  timer: null,
  first: true,  // true while the expected picture is shown
};

const pictureKeys = ["expected", "actual", "difference"];

/// Returns the caption of a picture. If two runs differ, the captions name the runs.
function pictureLabel(frame, key) {
  if (frame.status === "nondeterministic" && key !== "difference" && frame.others.length > 1)
    return frame.others[key === "expected" ? 0 : 1].label;
  if (key === "flip") return "FLIP";
  if (key === "expected" && frame.alternate > 0) return "expected (alternate " + frame.alternate + ")";
  return key;
}

/// Returns a path as a relative URL. Encodes it, because a name may contain "#", "?" or "%".
function link(path) {
  return path.split("/").map(encodeURIComponent).join("/");
}

function pictureLoaded(image) {
  const images = viewer.panes.flatMap((pane) => pane.layers).map((layer) => layer.image)
                     .filter((other) => other.naturalWidth > 0);
  if (!images.includes(image)) return;  // image of a frame that is no longer shown
  viewer.size = {
    width: Math.max(...images.map((other) => other.naturalWidth)),
    height: Math.max(...images.map((other) => other.naturalHeight)),
  };
  sizePanes();
}

/// Returns the image element for a path. Reuses an element that is already shown, so that switching views does not
/// flicker.
function pictureElement(path) {
  const shown = viewer.panes.flatMap((pane) => pane.layers).find((layer) => layer.path === path);
  if (shown) return shown.image;
  const image = element("img", {draggable: "false", decoding: "sync"});
  image.addEventListener("load", () => pictureLoaded(image));
  image.addEventListener("error", () => {
    image.after(element("p", {class: "lost"}, path + " cannot be loaded; index.html needs the files beside it"));
    image.hidden = true;
  });
  image.src = link(path);
  return image;
}

function makeLayer(frame, key) {
  const path = frame[key + "Image"];
  const image = pictureElement(path);
  image.alt = pictureLabel(frame, key) + (ofPictures ? "" : ", frame " + frame.frame);
  return {box: element("div", {class: "layer"}, image), image, key, path};
}

/// Returns a pane of one or more stacked pictures, with a caption in its corner.
function makePane(frame, keys) {
  const layers = keys.map((key) => makeLayer(frame, key));
  const window = element("i", {class: "mark window", title: "densest window", hidden: true});
  const worst = element("i", {class: "mark worst", title: "worst pixel", hidden: true});
  const captions = keys.map((key) => element("figcaption", {class: key}, pictureLabel(frame, key)));
  const box = element("figure", {class: "pane"}, ...layers.map((layer) => layer.box), window, worst, ...captions);
  return {box, layers, window, worst, captions, handle: null};
}

function addHandle(pane) {
  pane.handle = element("div", {class: "handle", role: "slider", tabindex: "0", "aria-label": "Swipe position",
                                "aria-valuemin": "0", "aria-valuemax": "100", "aria-orientation": "horizontal"});
  pane.handle.addEventListener("keydown", (event) => {
    const step = {ArrowLeft: -0.02, ArrowRight: 0.02, PageDown: -0.1, PageUp: 0.1, Home: -1, End: 1}[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    viewer.split = clamp(viewer.split + step, 0, 1);
    drawPanes();
  });
  pane.box.append(pane.handle);
}

function makePanes(frame, existing) {
  const both = existing.includes("expected") && existing.includes("actual");
  if (state.view === "difference") return existing.includes("difference") ? [makePane(frame, ["difference"])] : [];
  if (state.view === "flip") return frame.flipImage ? [makePane(frame, ["flip"])] : [];
  if (state.view === "side" || !both) {
    const keys = state.view === "side" ? existing : existing.filter((key) => key !== "difference");
    return keys.map((key) => makePane(frame, [key]));
  }
  const pane = makePane(frame, ["expected", "actual"]);
  if (state.view === "amplified") amplify(pane, frame);
  if (state.view === "swipe") addHandle(pane);
  return [pane];
}

/// Returns a text that explains why the view is empty.
function emptyText(frame, existing) {
  if (!frame) return state.scene.status === "error" ? "No frame was made." : "No frame was tested.";
  if (existing.length > 0)
    return existing.length === 1 ? "No difference picture: there is nothing to compare with." :
                                   "No difference picture: the pictures differ in size.";
  if (state.view === "flip" && hasPictures(frame)) return "No map of FLIP: the pictures look equal.";
  if (frame.status === "updated") return "The baseline was written; its picture is not stored here.";
  if (frame.status === "pass") {
    const alternate = frame.alternate > 0 ? "its accepted alternate " + frame.alternate : "its baseline";
    return (ofPictures ? "The picture is " : "Frame " + frame.frame + " is ") + (frame.metrics ? "within tolerance of " : "equal to ") + alternate +
        "; its picture is not stored.";
  }
  return equalPixels(frame) ? "The pixels are equal, not stored." : "No pictures were stored.";
}

function showPictures() {
  const frame = frameOf(state.scene);
  const existing = frame ? pictureKeys.filter((key) => frame[key + "Image"]) : [];
  viewer.panes = frame ? makePanes(frame, existing) : [];
  viewer.pointers.clear();
  viewer.drag = null;
  const panes = byId("panes");
  panes.className = "view-" + state.view + " of-" + viewer.panes.length;
  panes.replaceChildren(...viewer.panes.map((pane) => pane.box));
  if (viewer.panes.length === 0) panes.append(element("p", {class: "empty"}, emptyText(frame, existing)));
  for (const button of byId("views").children)
    button.setAttribute("aria-pressed", String(button.dataset.view === state.view));
  for (const id of ["zoomIn", "zoomOut", "fit", "oneToOne", "marks"]) byId(id).disabled = viewer.panes.length === 0;
  byId("worst").disabled = viewer.panes.length === 0 || !frame.metrics || frame.metrics.worst === 0;
  byId("pixel").textContent = "";
  byId("amplifyTools").hidden = state.view !== "amplified" || viewer.panes.length === 0;
  startBlink();
  sizePanes();
}

/// Sets the height of the panes from the pictures' aspect ratio, so that no pane is half empty.
function sizePanes() {
  const box = byId("panes");
  const columns = getComputedStyle(box).gridTemplateColumns.split(" ").length;
  const width = box.clientWidth / Math.max(1, columns);
  const most = window.innerHeight * (columns > 1 || viewer.panes.length === 1 ? 0.78 : 0.6);
  const shape = viewer.size.height / viewer.size.width;
  const height = viewer.panes.length === 0 ? 84 : clamp(width * shape, 150, Math.max(150, most));
  box.style.setProperty("--pane", Math.round(height) + "px");
  drawPanes();
}

// ---- amplified ----

const amplified = {chosen: "auto", factors: [1, 4, 16, 64, 255]};

/// Returns the amplification factor. The automatic factor keeps a difference of 1 visible. If 1 is the largest
/// difference, it is shown white, and otherwise dark grey.
function factorOf(frame) {
  if (amplified.chosen !== "auto") return Number(amplified.chosen);
  return frame.metrics && frame.metrics.worst > 1 ? 64 : 255;
}

/// Shows |actual - expected| of each channel times a factor. Uses CSS blending, because a page from disk may show the
/// pictures but not read their pixels.
function amplify(pane, frame) {
  const factor = factorOf(frame);
  const box = element("div", {class: "amplified", style: `filter: brightness(${factor})`}, ...pane.layers.map((layer) => layer.box));
  pane.box.prepend(box);
  const caption = element("figcaption", {}, `|actual − expected| × ${factor}`);
  pane.captions.forEach((one) => one.remove());
  pane.captions = [caption];
  pane.box.append(caption);
}

// ---- blink ----

const blinkPane = () => state.view === "blink" && viewer.panes.length === 1 && viewer.panes[0].layers.length === 2 ?
    viewer.panes[0] : null;

function showBlink() {
  const pane = blinkPane();
  if (!pane) return;
  pane.layers[1].box.style.visibility = blink.first ? "hidden" : "visible";
  pane.captions[0].hidden = !blink.first;
  pane.captions[1].hidden = blink.first;
}

function swapBlink() {
  blink.first = !blink.first;
  showBlink();
}

function startBlink() {
  clearInterval(blink.timer);
  blink.timer = null;
  byId("blinkTools").hidden = !blinkPane();
  byId("play").setAttribute("aria-pressed", String(blink.playing));
  if (!blinkPane()) return;
  showBlink();
  if (blink.playing) blink.timer = setInterval(swapBlink, Number(byId("interval").value));
}

/// Swaps the pictures on request. Stops the timer, because its next swap could otherwise follow immediately.
function blinkByHand() {
  if (state.view !== "blink") return go({view: "blink"});
  blink.playing = false;
  startBlink();
  swapBlink();
}

function toggleBlinkTimer() {
  blink.playing = !blink.playing;
  startBlink();
}

function startPanes() {
  views.forEach((view, index) => {
    byId("views").append(element("button", {"data-view": view.id, "aria-pressed": "false",
                                            title: view.label + " (" + (view.key || index + 1) + ")",
                                            onclick: () => go({view: view.id})},
                                 view.label));
  });
  for (const factor of ["auto", ...amplified.factors])
    byId("factor").append(element("option", {value: factor}, String(factor)));
  byId("factor").addEventListener("change", () => {
    amplified.chosen = byId("factor").value;
    showPictures();
  });
  byId("play").addEventListener("click", toggleBlinkTimer);
  byId("swap").addEventListener("click", blinkByHand);
  byId("interval").addEventListener("change", startBlink);
}
