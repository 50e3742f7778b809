// Picture viewer with zoom, pan and marks, which are the same in all panes. Positions are in picture pixels, with x to
// the right and y downwards. Each pane shows picture point (x, y) at its centre, with `scale` CSS pixels per picture
// pixel.

const viewer = {
  scale: null,  // zoom in CSS pixels per picture pixel; null means fit to the pane
  x: 0, y: 0,  // picture point at the centre of each pane, if scale is not null
  size: {width: 16, height: 9},  // size of the pictures, once known
  panes: [],                   // panes of the form {box, layers: [{box, image, key}], window, worst}
  split: 0.5,  // swipe position: fraction of the pane that shows the expected picture
  marks: true,
  pointers: new Map(),         // positions {x, y} by pointer id
  drag: null,                  // "pan", "split" or "pinch"
};

const zoomLadder = [1 / 8, 1 / 4, 1 / 2, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];
const clamp = (value, least, most) => Math.min(most, Math.max(least, value));
const fitScale = (pane) =>
    Math.min(pane.box.clientWidth / viewer.size.width, pane.box.clientHeight / viewer.size.height);
/// Returns the size of a device pixel in CSS pixels.
const devicePixel = () => 1 / (window.devicePixelRatio || 1);

/// Returns the transform of the picture in a pane: screen = offset + scale * picture.
function placement(pane) {
  const fitted = viewer.scale === null;
  const scale = fitted ? fitScale(pane) : viewer.scale;
  const x = fitted ? viewer.size.width / 2 : viewer.x;
  const y = fitted ? viewer.size.height / 2 : viewer.y;
  // Snaps to whole device pixels, so that the edges of picture pixels stay sharp.
  const snap = (value) => Math.round(value / devicePixel()) * devicePixel();
  return {scale, left: snap(pane.box.clientWidth / 2 - x * scale), top: snap(pane.box.clientHeight / 2 - y * scale)};
}

/// Positions an image. A scaled image has smoothed edges, which would be visible when two images are subtracted. With
/// `wholePixels`, the image therefore gets a size in whole device pixels.
function placeImage(image, place, wholePixels) {
  const move = `translate(${place.left}px, ${place.top}px)`;
  const side = (size) => wholePixels ? Math.round(size * place.scale / devicePixel()) * devicePixel() + "px" : "";
  image.style.transform = wholePixels ? move : move + ` scale(${place.scale})`;
  image.style.width = side(image.naturalWidth);
  image.style.height = side(image.naturalHeight);
}

function placeMark(mark, place, x, y, size, visible) {
  mark.hidden = !visible;
  if (!visible) return;
  const side = Math.max(size * place.scale, 5);
  mark.style.left = place.left + x * place.scale + (size * place.scale - side) / 2 + "px";
  mark.style.top = place.top + y * place.scale + (size * place.scale - side) / 2 + "px";
  mark.style.width = mark.style.height = side + "px";
}

/// Returns the side length of the densest window in pixels.
function windowSize() {
  const given = state.scene.tolerance.windowSize;
  return given ? given.value : 16;
}

function drawPanes() {
  for (const pane of viewer.panes) {
    const place = placement(pane);
    for (const layer of pane.layers) {
      placeImage(layer.image, place, state.view === "amplified");
      layer.image.classList.toggle("shrunk", place.scale < devicePixel());
    }
    const metrics = frameOf(state.scene) ? frameOf(state.scene).metrics : null;
    const shown = viewer.marks && metrics !== null;
    placeMark(pane.window, place, metrics ? metrics.windowX : 0, metrics ? metrics.windowY : 0,
              Math.min(windowSize(), viewer.size.width, viewer.size.height),
              shown && metrics.windowRatio > 0);
    placeMark(pane.worst, place, metrics ? metrics.worstX : 0, metrics ? metrics.worstY : 0, 1,
              shown && metrics.worst > 0);
    if (pane.handle) {
      pane.layers[1].box.style.clipPath = `inset(0 0 0 ${viewer.split * 100}%)`;
      pane.handle.style.left = viewer.split * 100 + "%";
      pane.handle.setAttribute("aria-valuenow", Math.round(viewer.split * 100));
    }
    pane.box.classList.toggle("zoomed", viewer.scale !== null);
  }
  const first = viewer.panes[0];
  byId("zoom").textContent = first ? Math.round(placement(first).scale / devicePixel() * 100) + " %" : "–";
}

/// Zooms so that the picture point at (clientX, clientY) does not move on the screen.
function zoomAt(pane, clientX, clientY, scale) {
  const box = pane.box.getBoundingClientRect();
  const place = placement(pane);
  const wanted = clamp(scale, zoomLadder[0], zoomLadder[zoomLadder.length - 1]);
  const dx = clientX - box.left, dy = clientY - box.top;
  const x = (dx - place.left) / place.scale, y = (dy - place.top) / place.scale;
  viewer.scale = wanted;
  lookAt(x + (pane.box.clientWidth / 2 - dx) / wanted, y + (pane.box.clientHeight / 2 - dy) / wanted);
}

function lookAt(x, y) {
  viewer.x = clamp(x, 0, viewer.size.width);
  viewer.y = clamp(y, 0, viewer.size.height);
  drawPanes();
}

function setScale(scale) {
  const pane = viewer.panes[0];
  if (!pane) return;
  const box = pane.box.getBoundingClientRect();
  if (scale === null) {
    viewer.scale = null;
    drawPanes();
  } else {
    zoomAt(pane, box.left + box.width / 2, box.top + box.height / 2, scale);
  }
}

/// Zooms to the next predefined scale, up (1) or down (-1).
function stepZoom(direction) {
  if (!viewer.panes[0]) return;
  const now = placement(viewer.panes[0]).scale / devicePixel();
  const next = direction > 0 ? zoomLadder.find((step) => step > now * 1.001) :
                               zoomLadder.findLast((step) => step < now * 0.999);
  if (next !== undefined) setScale(next * devicePixel());
}

function pan(dx, dy) {
  const pane = viewer.panes[0];
  if (!pane || viewer.scale === null) return;
  lookAt(viewer.x - dx / viewer.scale, viewer.y - dy / viewer.scale);
}

/// Moves to the pixel with the largest difference and zooms in enough to see its neighbours.
function goToWorst() {
  const frame = frameOf(state.scene);
  if (!frame || !frame.metrics || viewer.panes.length === 0) return;
  viewer.scale = Math.max(placement(viewer.panes[0]).scale, 12 * devicePixel());
  viewer.marks = true;
  byId("marks").setAttribute("aria-pressed", "true");
  lookAt(frame.metrics.worstX + 0.5, frame.metrics.worstY + 0.5);
}

function toggleMarks() {
  viewer.marks = !viewer.marks;
  byId("marks").setAttribute("aria-pressed", String(viewer.marks));
  drawPanes();
}

// ---- the pixel under the pointer ----

const probe = {context: null, refused: false};

/// Returns [r, g, b] of an image pixel, or null if the browser does not let a page from disk read pictures.
function colourAt(image, x, y) {
  if (probe.refused || !image.complete || x >= image.naturalWidth || y >= image.naturalHeight) return null;
  try {
    if (!probe.context) {
      const canvas = document.createElement("canvas");
      canvas.width = canvas.height = 1;
      probe.context = canvas.getContext("2d", {willReadFrequently: true});
    }
    probe.context.drawImage(image, x, y, 1, 1, 0, 0, 1, 1);
    return [...probe.context.getImageData(0, 0, 1, 1).data.slice(0, 3)];
  } catch {
    probe.refused = true;
    return null;
  }
}

function readPixel(pane, event) {
  const box = pane.box.getBoundingClientRect();
  const place = placement(pane);
  const x = Math.floor((event.clientX - box.left - place.left) / place.scale);
  const y = Math.floor((event.clientY - box.top - place.top) / place.scale);
  if (x < 0 || y < 0 || x >= viewer.size.width || y >= viewer.size.height) {
    byId("pixel").textContent = "";
    return;
  }
  let text = `x ${x}  y ${y}`;
  for (const layer of viewer.panes.flatMap((other) => other.layers)) {
    if (layer.key === "difference") continue;
    const colour = colourAt(layer.image, x, y);
    if (colour) text += `  ·  ${layer.key} ${colour.join(" ")}`;
  }
  byId("pixel").textContent = text;
}

// ---- pointer ----

const paneOf = (event) => viewer.panes.find((pane) => pane.box.contains(event.target));

function setSplit(pane, clientX) {
  const box = pane.box.getBoundingClientRect();
  viewer.split = clamp((clientX - box.left) / box.width, 0, 1);
  drawPanes();
}

function pointerDown(event) {
  const pane = paneOf(event);
  if (!pane || event.button !== 0) return;
  viewer.pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
  byId("panes").setPointerCapture(event.pointerId);
  const onHandle = pane.handle && pane.handle.contains(event.target);
  // A picture that fits the pane cannot be panned, so dragging anywhere moves the slider.
  const split = pane.handle && (onHandle || viewer.scale === null);
  viewer.drag = viewer.pointers.size > 1 ? "pinch" : split ? "split" : "pan";
  viewer.dragPane = pane;
  if (viewer.drag === "split") setSplit(pane, event.clientX);
  if (viewer.drag === "pan") pane.box.classList.add("dragging");
}

function pointerMove(event) {
  const last = viewer.pointers.get(event.pointerId);
  const pane = last ? viewer.dragPane : paneOf(event);
  if (pane) readPixel(pane, event);
  if (!last) return;
  const now = {x: event.clientX, y: event.clientY};
  if (viewer.drag === "split") setSplit(pane, now.x);
  if (viewer.drag === "pan") pan(now.x - last.x, now.y - last.y);
  if (viewer.drag === "pinch") {
    const other = [...viewer.pointers].find(([id]) => id !== event.pointerId)[1];
    const apart = (point) => Math.hypot(point.x - other.x, point.y - other.y) || 1;
    zoomAt(pane, (now.x + other.x) / 2, (now.y + other.y) / 2, placement(pane).scale * apart(now) / apart(last));
  }
  viewer.pointers.set(event.pointerId, now);
}

function pointerUp(event) {
  viewer.pointers.delete(event.pointerId);
  if (viewer.drag === "pinch" && viewer.pointers.size === 1) viewer.drag = "pan";
  if (viewer.pointers.size === 0) viewer.drag = null;
  for (const pane of viewer.panes) pane.box.classList.remove("dragging");
}

function wheel(event) {
  const pane = paneOf(event);
  if (!pane || pane.layers.length === 0) return;
  event.preventDefault();
  const lines = event.deltaMode === 1 ? 16 : 1;
  const factor = Math.exp(clamp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.002), -1, 1));
  zoomAt(pane, event.clientX, event.clientY, placement(pane).scale * factor);
}

function startViewer() {
  const panes = byId("panes");
  panes.addEventListener("pointerdown", pointerDown);
  panes.addEventListener("pointermove", pointerMove);
  panes.addEventListener("pointerup", pointerUp);
  panes.addEventListener("pointercancel", pointerUp);
  panes.addEventListener("pointerleave", () => byId("pixel").textContent = "");
  panes.addEventListener("wheel", wheel, {passive: false});
  panes.addEventListener("dragstart", (event) => event.preventDefault());
  byId("zoomIn").addEventListener("click", () => stepZoom(1));
  byId("zoomOut").addEventListener("click", () => stepZoom(-1));
  byId("fit").addEventListener("click", () => setScale(null));
  byId("oneToOne").addEventListener("click", () => setScale(devicePixel()));
  byId("worst").addEventListener("click", goToWorst);
  byId("marks").addEventListener("click", toggleMarks);
  new ResizeObserver(sizePanes).observe(panes);
}
