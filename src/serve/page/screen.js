// The picture, and what the mouse does to it.
import { orbit, pan, zoom } from "./camera.js";

export class Screen {
  constructor(element, on) {
    this.element = element;
    this.canvas = element.querySelector("canvas");
    this.context = this.canvas.getContext("2d", { alpha: true });
    this.on = on;
    this.about = null;
    this.view = null;
    this.aspect = 16 / 9;
    this.busy = Promise.resolve();
    new ResizeObserver(() => this.fit()).observe(element);
    this.canvas.addEventListener("pointerdown", (event) => this.grab(event));
    this.canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("wheel", (event) => this.roll(event), { passive: false });
  }

  show(about, blob) {
    // One after the other: a picture never overtakes another.
    this.busy = this.busy.then(async () => {
      const options = { colorSpaceConversion: "none", premultiplyAlpha: "none" };
      const image = await createImageBitmap(blob, options);
      this.canvas.width = about.width;
      this.canvas.height = about.height;
      this.context.clearRect(0, 0, about.width, about.height);
      this.context.drawImage(image, 0, 0);
      image.close();
      this.about = about;
      if (!this.held && about.view) this.view = about.view;
      this.on.shown(about);
    }).catch(() => this.on.shown(about));
  }

  setSize([width, height]) {
    this.aspect = width / height;
    this.pixels = width;
    this.fit();
  }

  fit() {
    const room = this.element.getBoundingClientRect();
    const width = Math.max(16, Math.min(room.width - 32, (room.height - 32) * this.aspect));
    this.canvas.style.width = `${width}px`;
    this.canvas.style.height = `${width / this.aspect}px`;
  }

  grab(event) {
    if (this.brush) return this.paint(event);
    if (!this.view) return;
    const panning = event.button !== 0 || event.shiftKey;
    let [x, y] = [event.clientX, event.clientY];
    let moved = 0;
    this.held = true;
    this.canvas.classList.add("held");
    this.canvas.setPointerCapture(event.pointerId);
    const move = (e) => {
      const [dx, dy] = [e.clientX - x, e.clientY - y];
      [x, y] = [e.clientX, e.clientY];
      moved += Math.abs(dx) + Math.abs(dy);
      if (moved < 4) return;
      const high = this.canvas.clientHeight;
      this.view = panning ? pan(this.view, dx / high, dy / high) : orbit(this.view, (3 * dx) / high, (3 * dy) / high);
      this.on.camera(this.view, true);
    };
    const end = (e) => {
      this.held = false;
      this.canvas.classList.remove("held");
      this.canvas.removeEventListener("pointermove", move);
      this.canvas.removeEventListener("pointerup", end);
      this.canvas.removeEventListener("pointercancel", end);
      if (moved >= 4) this.on.camera(this.view, false);
      else if (e.type === "pointerup" && e.button === 0) this.on.click(...this.pointAt(e));
    };
    this.canvas.addEventListener("pointermove", move);
    this.canvas.addEventListener("pointerup", end);
    this.canvas.addEventListener("pointercancel", end);
  }

  // Strokes of the brush: one for every piece of the way.
  paint(event) {
    let last = this.pointAt(event);
    let time = performance.now();
    this.canvas.setPointerCapture(event.pointerId);
    this.on.paint(last, last);
    const move = (e) => {
      if (performance.now() - time < 120) return;
      const now = this.pointAt(e);
      this.on.paint(last, now);
      [last, time] = [now, performance.now()];
    };
    const end = (e) => {
      this.canvas.removeEventListener("pointermove", move);
      this.canvas.removeEventListener("pointerup", end);
      this.canvas.removeEventListener("pointercancel", end);
      const now = this.pointAt(e);
      if (now[0] !== last[0] || now[1] !== last[1]) this.on.paint(last, now);
    };
    this.canvas.addEventListener("pointermove", move);
    this.canvas.addEventListener("pointerup", end);
    this.canvas.addEventListener("pointercancel", end);
  }

  // As fractions of the picture from its top left.
  pointAt(event) {
    const box = this.canvas.getBoundingClientRect();
    return [(event.clientX - box.x) / box.width, (event.clientY - box.y) / box.height];
  }

  roll(event) {
    event.preventDefault();
    if (!this.view) return;
    this.held = true; // until it rests
    this.view = zoom(this.view, Math.exp(Math.max(-200, Math.min(200, event.deltaY)) * 0.0015));
    this.on.camera(this.view, true);
    clearTimeout(this.rolling);
    this.rolling = setTimeout(() => {
      this.held = false;
      this.on.camera(this.view, false);
    }, 250);
  }
}
