// Controls to play, step, loop and scrub. Marks frames with kept states and frames at which values have keys.
import { byId, element, typing } from "./dom.js";

export class Timeline {
  constructor(on) {
    this.on = on;
    this.status = {};
    this.scrub = byId("scrub");
    this.scrub.addEventListener("input", () => { this.held = true; on.seek(Number(this.scrub.value), true); this.clock(); });
    this.scrub.addEventListener("change", () => { this.held = false; on.seek(Number(this.scrub.value), false); });
    byId("play").onclick = () => this.toggle();
    byId("loop").onclick = () => this.toggleLoop();
    byId("first").onclick = () => on.seek(0, false);
    byId("back").onclick = () => this.step(-1);
    byId("next").onclick = () => this.step(1);
    addEventListener("keydown", (event) => this.key(event));
  }

  toggle() {
    this.on.send({ do: this.status.playing ? "pause" : "play" });
  }

  toggleLoop() {
    this.on.send({ do: "loop", on: !this.status.loop });
  }

  // The server adds the step to its current frame, so fast key presses need not wait for answers.
  step(by) {
    this.on.step(by);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || typing(event.target)) return;
    // The slider handles these keys itself.
    if (event.target.matches("input[type='range']") && /^(Arrow|Home|End|Page)/.test(event.key)) return;
    const act = { " ": () => this.toggle(), ArrowLeft: () => this.step(-1), ArrowRight: () => this.step(1),
      Home: () => this.on.seek(0, false), End: () => this.on.seek(this.last, false), l: () => this.toggleLoop() }[event.key];
    if (!act || (event.key === " " && event.target.matches("button, summary, input:not([type='range'])"))) return;
    event.preventDefault();
    act();
  }

  setScene(scene) {
    this.last = scene.frames - 1;
    this.fps = scene.fps;
    this.scrub.max = this.last;
    this.clock();
    if (this.dragging) return; // Rebuilding would remove the mark under the pointer.
    const times = new Map();
    keysOf(scene.scene, "", times);
    byId("keys").replaceChildren(...[...times].filter(([time]) => time >= 0 && time * this.fps < this.last + 1.5).map(([time, keys]) => {
      const mark = element("i", { title: `${time} s: ${keys.map((key) => key.path).join(", ")}; drag to move`,
        onpointerdown: (event) => this.drag(event, mark, time, keys) });
      // A key at the scene's end lies after the last frame.
      mark.style.left = this.at(Math.min(this.last, time * this.fps));
      return mark;
    }));
  }

  // Moves all keys at one time together, in whole frames, but not past their neighbouring keys.
  drag(event, mark, time, keys) {
    if (event.button !== 0) return;
    event.preventDefault();
    this.dragging = true;
    mark.setPointerCapture(event.pointerId);
    const box = byId("track").getBoundingClientRect();
    const low = Math.max(0, ...keys.map((key) => Math.floor(key.after * this.fps + 1e-6) + 1));
    const high = Math.min(this.last, ...keys.map((key) => Math.ceil(key.before * this.fps - 1e-6) - 1));
    let now = time;
    const move = (e) => {
      const frame = Math.round((this.last * (e.clientX - box.x - 6)) / (box.width - 12));
      if (low > high) return;  // The keys cannot move, because no frame lies between the neighbouring keys.
      const next = Number((Math.min(high, Math.max(low, frame)) / this.fps).toPrecision(6));
      if (next === now || Math.abs(e.clientX - event.clientX) < 3) return;
      now = next;
      mark.style.left = this.at(now * this.fps);
      for (const key of keys) this.on.key(`${key.path}.keys.${key.index}.0`, now, true);
    };
    const end = () => {
      mark.removeEventListener("pointermove", move);
      mark.removeEventListener("pointerup", end);
      mark.removeEventListener("pointercancel", end);
      this.dragging = false;
      if (now === time) this.on.seek(Math.round(time * this.fps), false);
      else for (const key of keys) this.on.key(`${key.path}.keys.${key.index}.0`, now, false);
    };
    mark.addEventListener("pointermove", move);
    mark.addEventListener("pointerup", end);
    mark.addEventListener("pointercancel", end);
  }

  at(frame) {
    const part = this.last > 0 ? frame / this.last : 0;
    return `calc(6px + ${part} * (100% - 12px))`;
  }

  setStatus(status) {
    this.status = status;
    byId("play").textContent = status.playing ? "❚❚" : "▶";
    byId("play").setAttribute("aria-label", status.playing ? "Pause" : "Play");
    byId("loop").setAttribute("aria-pressed", status.loop);
    if (!this.held) this.scrub.value = status.target;
    const last = status.kept?.last ?? -1;
    byId("kept").style.width = last > 0 && this.last > 0 ? `calc(${last / this.last} * (100% - 12px))` : "0";
    this.clock();
  }

  clock() {
    const frame = Number(this.scrub.value);
    byId("clock").textContent = `${frame} / ${this.last ?? 0} · ${(frame / (this.fps || 1)).toFixed(2)} s`;
  }
}

function keysOf(value, path, times) {
  if (value === null || typeof value !== "object") return;
  if (Array.isArray(value.keys) && value.keys.every((key) => Array.isArray(key)))
    value.keys.forEach(([time], index) => {
      const key = { path, index, after: value.keys[index - 1]?.[0] ?? -Infinity, before: value.keys[index + 1]?.[0] ?? Infinity };
      times.set(time, [...(times.get(time) ?? []), key]);
    });
  for (const [key, member] of Object.entries(value)) if (key !== "keys") keysOf(member, path ? `${path}.${key}` : key, times);
}
