// Shows the frame with its golden baseline. The views are the frame's picture, the baseline, the difference, side by
// side, and one over the other with a movable border.
import { byId, element } from "./dom.js";

const modes = { ours: "Ours", baseline: "Baseline", difference: "Difference", beside: "Side by side", swipe: "Swipe" };
const captions = { ours: "ours", baseline: "baseline", difference: "difference" };
const gap = 12;  // gap between pictures in pixels
const shownIn = { ours: ["ours"], baseline: ["baseline"], difference: ["difference"], beside: ["baseline", "ours", "difference"],
  swipe: ["baseline", "ours"] };

export class Compare {
  constructor(on) {
    this.on = on;
    this.mode = "beside";
    this.message = { on: false };
    this.split = 0.5;
    byId("compare").onclick = () => on.send({ do: "compare", on: !this.message.on, ...on.side() });
    byId("accept").onclick = () => on.send({ do: "accept" });
    byId("testThis").onclick = () => on.send({ do: "testThis" });
    byId("modes").replaceChildren(...Object.entries(modes).map(([mode, name]) =>
      element("button", { "data-mode": mode, "aria-pressed": mode === this.mode, onclick: () => this.choose(mode) }, name)));
    byId("pairs").addEventListener("pointermove", (event) => this.swipe(event));
    // Without this, the wheel would move the camera.
    byId("golden").addEventListener("wheel", (event) => event.stopPropagation());
    addEventListener("resize", () => this.fit());
  }

  choose(mode) {
    this.mode = mode;
    this.show();
  }

  // Receives the server's verdict on the frame.
  set(message) {
    this.message = message;
    this.show();
  }

  // Receives the picture that is on the screen. The comparison is visible only while it belongs to the same frame.
  follow(picture) {
    this.picture = picture;
    this.show();
  }

  current() {
    const { message, picture } = this;
    return message.on && picture && !picture.draft && message.frame === picture.frame;
  }

  show() {
    const { message } = this;
    byId("compare").setAttribute("aria-pressed", Boolean(message.on));
    byId("golden").hidden = !message.on;
    if (!message.on) return;
    const current = this.current();
    const pair = current && Boolean(message.baseline);
    byId("pairs").hidden = !pair;
    byId("modes").hidden = !pair;
    for (const button of byId("modes").children) {
      button.setAttribute("aria-pressed", button.dataset.mode === this.mode);
      button.disabled = !message.difference && (button.dataset.mode === "difference" || button.dataset.mode === "swipe");
    }
    byId("verdict").textContent = current ? `${message.right ? "Right side: " : ""}${message.words}` : "…";
    byId("verdict").dataset.verdict = current ? message.verdict : "";
    this.buttons(current);
    const said = { none: "", running: "Writing baselines…", done: message.said, failed: message.said }[message.accept];
    byId("said").textContent = said?.trim() ?? "";
    byId("said").hidden = !said;
    if (pair) this.pictures();
  }

  buttons(current) {
    const { message } = this;
    const running = message.accept === "running";
    byId("accept").hidden = !current || !message.edit || !["fail", "missing"].includes(message.verdict);
    byId("accept").disabled = running;
    byId("testThis").hidden = !current || !message.edit || message.verdict !== "untested";
    const jumps = current && message.verdict === "untested" ? message.tested.slice(0, 12) : [];
    byId("jumps").replaceChildren(...jumps.map((frame) =>
      element("button", { title: `To tested frame ${frame}`, onclick: () => this.on.seek(frame) }, String(frame))));
  }

  pictures() {
    const { message } = this;
    let names = shownIn[this.mode].filter((name) => name !== "difference" || message.difference);
    if (names.length === 0 || (this.mode === "swipe" && !message.difference)) names = ["baseline", "ours"];
    const key = `${message.number} ${names}`;
    if (this.key !== key) {
      this.key = key;
      byId("pairs").replaceChildren(...names.map((name) => element("figure", { "data-name": name },
        element("img", { src: `golden-${name}.png?${message.number}`, alt: captions[name], draggable: "false" }),
        element("figcaption", {}, captions[name]))), element("i", { id: "split", hidden: true }));
    }
    byId("pairs").dataset.mode = this.mode;
    const worst = message.worst;
    const difference = byId("pairs").querySelector("[data-name='difference']");
    if (worst && difference) this.ring(difference, worst);
    this.fit();
  }

  // Draws a ring around the pixel with the largest difference.
  ring(figure, worst) {
    if (figure.querySelector(".ring")) return;
    const [width, height] = this.message.size;
    const ring = element("i", { class: "ring", title: `by ${worst.by} of 255` });
    ring.style.left = `${(100 * (worst.x + 0.5)) / width}%`;
    ring.style.top = `${(100 * (worst.y + 0.5)) / height}%`;
    figure.append(ring);
  }

  // Scales the pictures to the largest size at which all are visible.
  fit() {
    const pairs = byId("pairs");
    if (pairs.hidden || !this.message.size) return;
    const figures = [...pairs.querySelectorAll("figure")];
    const [width, height] = this.message.size;
    const room = pairs.getBoundingClientRect();
    const swipes = this.mode === "swipe";
    const places = swipes ? 1 : figures.length; // In the view with the movable border, both pictures are at the same
                                                // position.
    const widest = (columns) => {
      const rows = Math.ceil(places / columns);
      return Math.min((room.width - gap * (columns + 1)) / columns, (((room.height - gap * (rows + 1)) / rows) * width) / height);
    };
    const wide = Math.max(16, ...Array.from({ length: places }, (_, i) => widest(i + 1)));
    for (const figure of figures) {
      figure.style.width = `${wide}px`;
      figure.style.height = `${(wide * height) / width}px`;
      figure.style.clipPath = swipes && figure.dataset.name === "ours" ? `inset(0 0 0 ${100 * this.split}%)` : "";
    }
    byId("split").hidden = !swipes;
    byId("split").style.left = `${room.width / 2 + (this.split - 0.5) * wide}px`;
  }

  swipe(event) {
    if (this.mode !== "swipe") return;
    const box = byId("pairs").firstElementChild?.getBoundingClientRect();
    if (!box) return;
    this.split = Math.min(1, Math.max(0, (event.clientX - box.x) / box.width));
    this.fit();
  }
}
