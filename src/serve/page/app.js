// Main module of the page of `simreel serve`. Passes messages from the link to screen, timeline, charts and panel.
import { showAnswer } from "./answer.js";
import { showCharts, showTimes } from "./charts.js";
import { Compare } from "./compare.js";
import { byId, element, typing } from "./dom.js";
import { Link } from "./link.js";
import { Pair } from "./pair.js";
import { Panel } from "./panel.js";
import { Schema } from "./schema.js";
import { Screen } from "./screen.js";
import { Timeline } from "./timeline.js";

const state = { me: 0, editor: 0, about: null, scene: null, status: {}, picture: null, series: [], seriesBeside: [], held: false };
let panel = null;

function note(text, seconds = 4) {
  byId("note").textContent = text;
  byId("note").hidden = !text;
  byId("note").classList.toggle("report", text.includes("\n"));
  clearTimeout(note.timer);
  if (text) note.timer = setTimeout(() => { byId("note").hidden = true; }, 1000 * seconds);
}

const link = new Link({
  open: () => note(""),
  closed: () => note("The connection is gone; trying again", 3600),
  you: (message) => { state.me = message.viewer; people(); },
  viewers: (message) => { Object.assign(state, { editor: message.editor, count: message.count }); people(); },
  about: (message) => { state.about = message; facts(); },
  scene: (message) => { state.scene = message; sceneChanged(); },
  status: (message) => { state.status = message; statusChanged(); },
  series: (message) => { Object.assign(state, { series: message.series, seriesBeside: message.beside ?? [] }); charts(); },
  render: (message) => rendered(message),
  golden: (message) => compare.set(message),
  refused: (message) => { note(message.text, message.text.includes("\n") ? 12 : 6); restore(); },
  answer: (message) => showAnswer(byId("answer"), message),
  picture: (about, files) => screen.show(about, files),
});

const screen = new Screen(byId("screen"), {
  shown: (about) => {
    state.picture = about;
    link.shown(about.number);
    compare.follow(about);
    pair.follow(about);
    badges();
    charts();
    showTimes(byId("times"), about.took, state.status);
  },
  camera: (view, other, moving) => {
    const placed = ({ eye, target, height }) => ({ position: eye, target, ...(height ? { height } : {}) });
    const request = { do: "camera", ...placed(view) };
    if (other) Object.assign(request, { beside: placed(other), right: pair.right });
    if (moving) link.move("camera", request);
    else link.settle("camera", request);
  },
  paint: (from, to, beside) => link.send({ do: "paint", from, to, radius: Number(byId("radius").value) || 1,
    ...(byId("value").value === "" ? {} : { value: Number(byId("value").value) }), beside }),
  click: (x, y, beside) => link.send({ asks: "pixel", x, y, beside }),
});

const timeline = new Timeline({
  send: (request) => link.send(request),
  seek: (frame, moving) => (moving ? link.move("seek", { do: "seek", frame }) : link.settle("seek", { do: "seek", frame })),
  step: (by) => link.settle("seek", { do: "seek", by }),
  key: (path, value, moving) => set(path, value, moving),
});

const compare = new Compare({
  send: (request) => link.send(request),
  side: () => pair.flag,
  seek: (frame) => link.settle("seek", { do: "seek", frame }),
});

const pair = new Pair({ send: (request) => link.send(request), chosen: () => sideChosen() });

function set(path, value, moving) {
  const request = { do: "set", path, value, ...pair.flag };
  if (moving) link.move(`set ${path}`, request);
  else link.settle(`set ${path}`, request);
}

function facts() {
  const { scene, about } = state;
  if (!scene || !about) return;
  const fact = (name, value, title) => element("span", { class: "fact", title: title ?? "" }, `${name} `, element("b", {}, value));
  byId("render").hidden = byId("renderAll").hidden = !about.output;
  byId("file").title = about.file;
  byId("file").textContent = about.file.split("/").pop() + (about.edit ? " · saved as you go" : "");
  byId("facts").replaceChildren(...(scene.size ? [
    fact("numerics", scene.numerics), fact("rasterizer", scene.rasterizer),
    fact("", `${scene.size[0]}×${scene.size[1]}`, `${scene.samples} samples per pixel`),
    fact("on", about.device.replace(/\s*\(.*/, ""), `${about.driver}; ${about.processor}`)] : []));
}

function rendered(message) {
  const part = message.total ? ` ${message.done} of ${message.total}` : "";
  const text = { running: `rendering${part}`, done: "rendered", failed: "render failed" }[message.state];
  byId("rendered").replaceChildren(message.link && message.state === "done"
    ? element("a", { href: message.link, target: "_blank", rel: "noopener", title: message.output }, text)
    : element("span", { title: message.output }, text));
  if (message.state === "failed") note(message.text, 10);
}

function people() {
  const mine = state.me !== 0 && state.me === state.editor;
  byId("people").textContent = state.count > 1 ? `${state.count} viewers${mine ? "" : ", you watch"}` : "";
  byId("take").hidden = mine || state.me === 0;
}

function sceneChanged() {
  const { scene } = state;
  const mistakes = [scene.mistakes, scene.beside?.mistakes && `Right side: ${scene.beside.mistakes}`].filter(Boolean).join("\n");
  byId("mistakes").textContent = mistakes;
  byId("mistakes").hidden = !mistakes;
  pair.set(scene);
  facts();
  if (!scene.scene) return;
  byId("title").textContent = scene.title;
  document.title = `${scene.title || "simreel"} — simreel serve`;
  const sizes = [scene.size, scene.beside?.size].filter(Boolean);
  screen.setSizes(sizes, sizes.length > 1 ? pair.captions() : []);
  byId("brush").hidden = !Object.values(scene.scene.objects ?? {}).some((object) => paintable.some((kind) => kind in object));
  parametersChanged();
}

function sideChosen() {
  parametersChanged();
  charts();
  compare.follow(state.picture);
  if (compare.message.on) link.send({ do: "compare", on: true, ...pair.flag });
}

// Resets all controls to the current values after the server has refused a request.
function restore() {
  if (state.scene?.scene) parametersChanged();
  timeline.setStatus(state.status);
  screen.restore();
}

// Updates the controls to show the side that changes apply to.
function parametersChanged() {
  const chosen = pair.chosen;
  byId("forget").hidden = chosen.edits.length === 0;
  timeline.setScene(chosen);
  panel?.update(chosen);
}

function statusChanged() {
  timeline.setStatus(state.status);
  badges();
}

function badges() {
  const { status, picture } = state;
  const list = [];
  const badge = (text, warm = false) => list.push(element("span", { class: `badge${warm ? " warm" : ""}` }, text));
  if (status.frame !== undefined && status.frame !== status.target)
    badge(status.frame < 0 ? `before the first frame: ${status.frame}` : `going to ${status.target}: at ${status.frame}`, true);
  if (picture?.carried || picture?.beside?.carried) badge("goes on with other values", true);
  if (picture?.draft) badge(`quick ${picture.width}×${picture.height}`);
  byId("badges").replaceChildren(...list);
}

function charts() {
  const { picture } = state;
  const scene = pair.chosen;
  const series = pair.flag.beside ? state.seriesBeside : state.series;
  if (scene?.scene && picture) showCharts(byId("charts"), series, scene.checks, picture.frame, scene.frames);
}

const paintable = ["life", "lenia", "grayScott", "epidemic", "wildfire", "reaction", "water", "fluid"];
function brush(on) {
  screen.brush = on;
  byId("brush").setAttribute("aria-pressed", on);
  byId("radius").hidden = byId("value").hidden = !on;
  byId("sides").classList.toggle("brush", on);
}
byId("brush").onclick = () => brush(!screen.brush);
addEventListener("keydown", (event) => {
  if (event.key === "b" && !typing(event.target) && !byId("brush").hidden) brush(!screen.brush);
});
byId("render").onclick = () => link.send({ do: "render", all: false, ...pair.flag });
byId("renderAll").onclick = () => link.send({ do: "render", all: true, ...pair.flag });
byId("take").onclick = () => link.takeOver();
byId("forget").onclick = () => link.send({ do: "forget", ...pair.flag });
byId("filter").oninput = (event) => panel?.find(event.target.value);
byId("copy").onclick = async () => {
  const text = `${pair.chosen.command} --frames ${state.status.target} -o frame_####.png`;
  try {
    await navigator.clipboard.writeText(text);
    note("Copied: " + text);
  } catch {
    note(text, 20);
  }
};
addEventListener("pointerdown", () => { state.held = true; }, true);
addEventListener("pointerup", () => { state.held = false; }, true);

new ResizeObserver(() => screen.fit()).observe(byId("left"));
const answer = await fetch("schema.json");
panel = new Panel(byId("parameters"), new Schema(await answer.json()), {
  set,
  forget: (path) => link.send({ do: "forget", path, ...pair.flag }),
  isHeld: () => state.held,
  frame: () => state.status.target ?? 0,
  fps: () => pair.chosen.fps,
});
if (state.scene?.scene) panel.update(pair.chosen);
globalThis.simreel = { state, link, panel, screen, compare, pair }; // The global object is for debugging in the
                                                                    // browser's console.
