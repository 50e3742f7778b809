// The report's data, values derived from it, and the selection: suite, scene, frame, view.

/// Unpacks the data of Packer in html.cpp. There, an object is [index of its key list, values...], a list is [-1,
/// values...], and a repeated text is {"t": index}.
function unpacked({keys, texts, data}) {
  const open = (value) => {
    if (!Array.isArray(value)) return value !== null && typeof value === "object" ? texts[value.t] : value;
    const values = value.slice(1).map(open);
    return value[0] < 0 ? values : Object.fromEntries(keys[value[0]].map((key, i) => [key, values[i]]));
  };
  return open(data);
}

const suite = unpacked(JSON.parse(document.getElementById("data").textContent));
/// true if the report is about pictures of other programs, which have no frames, device or state
const ofPictures = suite.unit === "picture";

/// All statuses in the order of the list, most urgent first.
const statusOrder =
    ["error", "fail", "nondeterministic", "missing", "xpass", "flaky", "xfail", "updated", "pass"];
const statusWords = {
  error: "error", fail: "failed", nondeterministic: "nondeterministic", missing: "no baseline",
  xpass: "passed unexpectedly", flaky: "flaky", xfail: "failed as expected", updated: "updated", pass: "passed",
};
/// Short status names for narrow places.
const statusShort = {...statusWords, xpass: "xpass", xfail: "xfail"};
const statusGlyphs = {
  error: "!", fail: "✕", nondeterministic: "≠", missing: "?", xpass: "⊕", flaky: "~", xfail: "⊖", updated: "↑",
  pass: "✓",
};

function isFailure(status) {
  if (status === "flaky") return !suite.allowFlaky;
  return !["pass", "updated", "xfail"].includes(status);
}

/// True if all pixels must be equal. `asked` comes from a scene or a frame.
function noneMayDiffer(asked) {
  return asked === "exact" || asked === "equal";
}

const views = [
  {id: "side", label: "side by side"},
  {id: "swipe", label: "swipe"},
  {id: "blink", label: "blink"},
  {id: "difference", label: "difference"},
  ...suite.scenes.some((scene) => scene.frames.some((frame) => frame.flipImage)) ? [{id: "flip", label: "FLIP"}] : [],
  {id: "amplified", label: "amplified", key: "a"},
];

/// Measurements that the curve can show. `of` computes the value from a frame's metrics. `bound` is the tolerance field
/// that limits the value.
const curves = [
  {id: "worst", label: "worst channel", of: (m) => m.worst, bound: "hardFail", text: (v) => format(v, 3)},
  {id: "ratioBeyond", label: "pixels beyond", of: (m) => m.ratioBeyond, bound: "maxDiffRatio", text: percent},
  {id: "flipMean", label: "FLIP mean", of: (m) => m.flipMean, bound: "maxFlipMean", text: (v) => format(v, 3)},
  {id: "ssim", label: "1 − SSIM", of: (m) => m.ssim === null ? null : 1 - m.ssim, bound: null, text: (v) => format(v, 3)},
];

/// The current selection. Change it with go(), which redraws the page and updates the link.
const state = {scene: null, frame: 0, view: "side"};

const byName = new Map(suite.scenes.map((scene) => [scene.name, scene]));
const failing = suite.scenes.filter((scene) => isFailure(scene.status));

const frameOf = (scene) => (scene && scene.frames[state.frame]) || null;
const hasPictures = (frame) => Boolean(frame.expectedImage || frame.actualImage || frame.differenceImage);
const equalPixels = (frame) => !frame.metrics && frame.pixels !== "" && frame.pixels === frame.expectedPixels;

/// Returns a frame's message without the frame number, for use where the number is already shown.
function ownMessage(frame) {
  const prefix = "frame " + frame.frame + ": ";
  return frame.message.startsWith(prefix) ? frame.message.slice(prefix.length) : frame.message;
}

/// Returns the largest value of a measurement over the scene's frames, or 0 if nothing was measured.
function largest(scene, of) {
  return scene.frames.reduce((most, frame) => frame.metrics ? Math.max(most, of(frame.metrics)) : most, 0);
}

/// Returns the index of the frame to show first, the first failing one.
function firstFrame(scene) {
  const telling = (frame) => (frame.status !== "pass" && frame.status !== "updated") || frame.others.length > 0;
  return Math.max(0, scene.frames.findIndex(telling));
}

/// Returns a curve's value at a frame: 0 if the pixels are equal, null if the pictures cannot be compared.
function curveValue(curve, frame) {
  if (frame.metrics) return curve.of(frame.metrics);
  return equalPixels(frame) || frame.alternate > 0 ? 0 : null;
}

// ---- formatting of text ----

function format(value, digits = 4) {
  if (value === null || value === undefined) return "–";
  return String(Number(Number(value).toPrecision(digits)));
}
function percent(ratio) {
  return format(ratio * 100, 3) + " %";
}
function seconds(value) {
  if (value === null) return "–";
  if (value < 60) return value.toFixed(value < 10 ? 2 : 1) + " s";
  return Math.floor(value / 60) + " min " + Math.round(value % 60) + " s";
}
function plural(count, noun) {
  return count + " " + noun + (count === 1 ? "" : "s");
}
const natural = new Intl.Collator("en", {numeric: true}).compare;

/// Quotes text as one word for a POSIX shell.
function shellWord(text) {
  return "'" + text.replaceAll("'", "'\\''") + "'";
}

/// Returns the command that accepts this scene, or "" if no results were stored.
function acceptCommand(scene) {
  if (!suite.acceptCommand || !scene.candidate) return "";
  return suite.acceptCommand + " --only " + shellWord(scene.name);
}

/// Returns text like "first leaves the baseline at frame 37, step 4 of 22: flag.positions, within elements 128–191".
function divergenceText(divergence) {
  const d = divergence;
  const when = d.frame < 0 ? "before frame 0, at pre-roll frame " + d.frame : "at frame " + d.frame;
  const step = d.step > 0 ? ", step " + d.step + " of " + d.steps : "";
  const block = "within elements " + d.firstElement + "–" + d.lastElement;
  const elements = d.firstElement === d.lastElement ? "element " + d.firstElement : block;
  const where = [d.object, d.buffer].filter(Boolean).join(".");
  return "first leaves the baseline " + when + step + (where ? ": " + where + ", " + elements : "");
}

// ---- elements of the document ----

const byId = (id) => document.getElementById(id);

/// Creates an element. Text becomes text nodes, so data is never parsed as markup.
function element(tag, properties, ...children) {
  const made = document.createElement(tag);
  for (const [key, value] of Object.entries(properties || {})) {
    if (value === null || value === undefined || value === false) continue;
    if (key === "class") made.className = value;
    else if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else made.setAttribute(key, value === true ? "" : value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined && child !== ""));
  return made;
}
function svgElement(tag, attributes, text) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text) made.textContent = text;
  return made;
}
function badge(status) {
  return element("span", {class: "badge " + status}, statusGlyphs[status] + " " + statusWords[status]);
}

/// Browsers may deny localStorage (page from disk, private window). In that case settings are lost when the page is
/// closed.
function remembered(key) {
  try {
    return window.localStorage.getItem("simreel." + key);
  } catch {
    return null;
  }
}
function remember(key, value) {
  try {
    window.localStorage.setItem("simreel." + key, value);
  } catch {
    // the setting is lost when the page is closed
  }
}

/// Copies text with the asynchronous clipboard API. If the browser denies that, copies it through a selected text
/// field.
async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const field = element("textarea", {readonly: true, class: "copyField", "aria-hidden": "true"});
    const focused = document.activeElement;
    field.value = text;
    document.body.append(field);
    field.select();
    const copied = document.execCommand("copy");
    field.remove();
    if (focused) focused.focus({preventScroll: true});
    return copied;
  }
}

/// Returns a command and a button that copies it.
function commandLine(text, label) {
  const button = element("button", {class: "copy", "aria-label": "Copy: " + label, title: "Copy"}, "copy");
  button.addEventListener("click", async () => {
    button.textContent = await copyText(text) ? "copied" : "select it by hand";
    setTimeout(() => button.textContent = "copy", 1500);
  });
  return [element("code", {}, text), button];
}
