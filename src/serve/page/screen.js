// Shows the pictures and handles mouse input on them.
import { orbit, pan, zoom } from "./camera.js";

const gap = 12;  // gap between pictures in pixels

export class Screen {
  constructor(element, on) {
    this.element = element;
    this.sides = element.querySelector("#sides");
    this.panes = [...this.sides.querySelectorAll("figure")].map((figure) => ({ figure, canvas: figure.querySelector("canvas"),
      context: figure.querySelector("canvas").getContext("2d", { alpha: true }), aspect: 16 / 9, view: null }));
    this.on = on;
    this.about = null;
    this.busy = Promise.resolve();
    new ResizeObserver(() => this.fit()).observe(element);
    this.panes.slice(0, 2).forEach(({ canvas }, side) => {
      canvas.addEventListener("pointerdown", (event) => this.grab(event, side));
      canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    });
    element.addEventListener("wheel", (event) => this.roll(event), { passive: false });
  }

  show(about, files) {
    // Pictures are drawn one after the other, so that a later one cannot appear first. The pictures of both sides
    // appear at the same time.
    this.busy = this.busy.then(async () => {
      const options = { colorSpaceConversion: "none", premultiplyAlpha: "none" };
      const images = await Promise.all(files.map((file) => createImageBitmap(file, options)));
      images.forEach((image, i) => {
        const { canvas, context } = this.panes[i];
        canvas.width = image.width;
        canvas.height = image.height;
        context.clearRect(0, 0, image.width, image.height);
        context.drawImage(image, 0, 0);
        image.close();
      });
      this.about = about;
      [about.view, about.beside?.view ?? null].forEach((view, side) => {
        if (!this.held && (view || side > 0)) this.panes[side].view = view;
      });
      if (!this.held) this.arrange(files.length);
      this.on.shown(about);
    }).catch(() => this.on.shown(about));
  }

  // Resets the cameras to the views of the latest picture.
  restore() {
    if (this.about && !this.held) [this.about.view, this.about.beside?.view ?? null].forEach((view, side) => { this.panes[side].view = view; });
  }

  // Shows as many panes as pictures have arrived. During drafts, a difference picture stays until the next full
  // picture.
  arrange(count) {
    const quick = this.about.draft && this.about.beside && !this.panes[2].figure.hidden;
    this.panes.forEach(({ figure }, i) => { figure.hidden = i >= count && !(quick && i === 2); });
    this.panes[2].figure.classList.toggle("stale", Boolean(quick));
    this.fit();
  }

  setSizes(sizes, captions) {
    sizes.forEach(([width, height], i) => { this.panes[i].aspect = width / height; });
    this.panes[2].aspect = this.panes[0].aspect;
    this.panes.forEach(({ figure }, i) => {
      figure.querySelector("figcaption").textContent = captions[i] ?? "";
      figure.querySelector("figcaption").hidden = !captions[i];
    });
    if (sizes.length < 2) this.panes.slice(1).forEach(({ figure }) => { figure.hidden = true; });
    this.fit();
  }

  // Scales all pictures to the same height, as large as possible. Arranges them in one row, in one column, or with two
  // pictures above one.
  fit() {
    const shown = this.panes.filter(({ figure }) => !figure.hidden);
    const room = this.element.getBoundingClientRect();
    const wide = (row) => row.reduce((sum, { aspect }) => sum + aspect, 0);
    const layouts = [[shown], shown.map((pane) => [pane]), [shown.slice(0, 2), shown.slice(2)]];
    let best = { height: 9, width: 16 };
    for (const layout of layouts) {
      const rows = layout.filter((row) => row.length > 0);
      const height = Math.min((room.height - 32 - gap * (rows.length - 1)) / rows.length,
        ...rows.map((row) => (room.width - 32 - gap * (row.length - 1)) / wide(row)));
      if (height > best.height) best = { height, width: Math.max(...rows.map((row) => wide(row) * height + gap * (row.length - 1))) };
    }
    this.sides.style.width = `${Math.ceil(best.width)}px`;
    for (const { canvas, aspect } of shown) {
      canvas.style.width = `${best.height * aspect}px`;
      canvas.style.height = `${best.height}px`;
    }
  }

  // Moves the cameras of both sides in the same way.
  move(change, moving) {
    for (const pane of this.panes) if (pane.view) pane.view = change(pane.view);
    this.on.camera(this.panes[0].view, this.panes[1].view, moving);
  }

  grab(event, side) {
    const { canvas } = this.panes[side];
    if (this.brush) return this.paint(event, canvas, side === 1);
    if (!this.panes[0].view) return;
    const panning = event.button !== 0 || event.shiftKey;
    let [x, y] = [event.clientX, event.clientY];
    let moved = 0;
    this.held = true;
    canvas.classList.add("held");
    canvas.setPointerCapture(event.pointerId);
    const move = (e) => {
      const [dx, dy] = [e.clientX - x, e.clientY - y];
      [x, y] = [e.clientX, e.clientY];
      moved += Math.abs(dx) + Math.abs(dy);
      if (moved < 4) return;
      const high = canvas.clientHeight;
      this.move((view) => (panning ? pan(view, dx / high, dy / high) : orbit(view, (3 * dx) / high, (3 * dy) / high)), true);
    };
    const end = (e) => {
      this.held = false;
      canvas.classList.remove("held");
      canvas.removeEventListener("pointermove", move);
      canvas.removeEventListener("pointerup", end);
      canvas.removeEventListener("pointercancel", end);
      if (moved >= 4) this.move((view) => view, false);
      else if (e.type === "pointerup" && e.button === 0) this.on.click(...this.pointAt(e, canvas), side === 1);
    };
    canvas.addEventListener("pointermove", move);
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointercancel", end);
  }

  // Sends brush strokes, one for each segment of the mouse's path.
  paint(event, canvas, beside) {
    let last = this.pointAt(event, canvas);
    let time = performance.now();
    canvas.setPointerCapture(event.pointerId);
    this.on.paint(last, last, beside);
    const move = (e) => {
      if (performance.now() - time < 120) return;
      const now = this.pointAt(e, canvas);
      this.on.paint(last, now, beside);
      [last, time] = [now, performance.now()];
    };
    const end = (e) => {
      canvas.removeEventListener("pointermove", move);
      canvas.removeEventListener("pointerup", end);
      canvas.removeEventListener("pointercancel", end);
      const now = this.pointAt(e, canvas);
      if (now[0] !== last[0] || now[1] !== last[1]) this.on.paint(last, now, beside);
    };
    canvas.addEventListener("pointermove", move);
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointercancel", end);
  }

  // Returns the mouse position as fractions of the picture, from its top left.
  pointAt(event, canvas) {
    const box = canvas.getBoundingClientRect();
    return [(event.clientX - box.x) / box.width, (event.clientY - box.y) / box.height];
  }

  roll(event) {
    event.preventDefault();
    if (!this.panes[0].view) return;
    this.held = true;  // The camera counts as held until the wheel stops.
    const factor = Math.exp(Math.max(-200, Math.min(200, event.deltaY)) * 0.0015);
    this.move((view) => zoom(view, factor), true);
    clearTimeout(this.rolling);
    this.rolling = setTimeout(() => {
      this.held = false;
      this.move((view) => view, false);
    }, 250);
  }
}
