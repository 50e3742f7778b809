// Controls for two sides in step. They select the side to which changes apply, show the values that only the right side
// has, and turn the difference of the pictures on.
import { byId, element } from "./dom.js";

const nameOf = (file) => file.split("/").pop();

export class Pair {
  constructor(on) {
    this.on = on;
    this.scene = null;
    this.picture = null;
    this.right = false; // true if changes apply to the right side
    byId("beside").onclick = () => {
      this.right = !this.shown && !this.scene?.beside?.ownFile;
      on.send({ do: "beside", on: !this.shown });
    };
    byId("pairDifference").onclick = () => on.send({ do: "beside", on: true, difference: !this.scene.beside.difference });
    for (const button of byId("pairSides").children)
      button.onclick = () => {
        this.right = button.dataset.side === "right";
        this.show();
        on.chosen();
      };
  }

  get shown() { return Boolean(this.scene?.beside); }

  // Returns the scene that the panel shows and that changes apply to.
  get chosen() {
    const { scene } = this;
    if (!this.right || !scene?.beside?.scene) return scene;
    return { ...scene.beside, given: [], frames: Math.min(scene.frames, scene.beside.frames) };
  }

  // Returns the members that a request needs to select the side to which it applies.
  get flag() { return this.shown && this.right ? { beside: true } : {}; }

  set(scene) {
    this.scene = scene;
    if (!scene.beside) this.right = false;
    this.show();
  }

  follow(picture) {
    this.picture = picture;
    this.show();
  }

  captions() {
    const { beside } = this.scene;
    const right = beside.ownFile ? nameOf(beside.file) : beside.edits.map(([path, value]) => `${path} = ${value}`).join(", ");
    return [beside.ownFile ? "left" : "as it is", right.length > 60 ? `${beside.edits.length} other values` : right || "the same", "difference"];
  }

  show() {
    byId("beside").setAttribute("aria-pressed", this.shown);
    byId("pair").hidden = !this.shown;
    if (!this.shown) return;
    const { beside } = this.scene;
    const names = beside.ownFile ? { left: "Left", right: "Right" } : { left: "Both sides", right: "Right alone" };
    for (const button of byId("pairSides").children) {
      button.textContent = names[button.dataset.side];
      button.setAttribute("aria-pressed", (button.dataset.side === "right") === this.right);
    }
    byId("pairDifference").setAttribute("aria-pressed", beside.difference);
    byId("pairWords").textContent = this.words();
    byId("pairEdits").replaceChildren(...beside.edits.map(([path, value]) => element("span", { class: "chip", title: `Right alone: ${path} = ${value}` },
      `${path} = ${value.length > 24 ? "…" : value} `,
      element("button", { class: "undo", title: "Take back", "aria-label": `Take back ${path}`,
        onclick: () => this.on.send({ do: "forget", path, beside: true }) }, "×"))));
  }

  words() {
    const { picture } = this;
    if (this.scene.beside.mistakes) return "The right side has errors";
    if (!picture?.beside || picture.draft) return "…";
    const { different } = picture.beside;
    if (different === null) return "The pictures are of different sizes";
    if (different === 0) return "Every pixel is the same";
    const all = picture.width * picture.height;
    return `${different.toLocaleString("en")} of ${all.toLocaleString("en")} pixels differ (${Number(((100 * different) / all).toPrecision(3))}%)`;
  }
}
