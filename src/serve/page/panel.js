// Panel with all parameters of the scene, built from the schema. Values that the scene gives are highlighted. Other
// parameters show their default.
import { element } from "./dom.js";
import { control } from "./controls.js";
import { withKey } from "./keys.js";
import { forms, isGroup, wordsOf } from "./schema.js";

const skipped = new Set(["$schema", "version", "test", "checks"]);
const opened = new Set(["render", "camera"]); // paths of groups that are open; remembered while the page is open

export class Panel {
  constructor(node, schema, on) {
    this.node = node;
    this.schema = schema;
    this.on = on;
    this.rows = new Map();  // rows by parameter path; each row is {node, control}
    this.edits = new Map();
    this.filter = "";
    this.shape = "";
  }

  update(message) {
    this.scene = message.scene;
    this.edits = new Map(message.edits);
    this.given = new Set(message.given);
    const shape = shapeOf(this.scene);
    if (shape !== this.shape) this.build();
    this.shape = shape;
    for (const [path, row] of this.rows) this.refresh(path, row);
  }

  find(text) {
    this.filter = text.trim().toLowerCase();
    this.build();
    for (const [path, row] of this.rows) this.refresh(path, row);
  }

  build() {
    this.rows.clear();
    if (!this.scene) return;
    this.node.replaceChildren();
    // Objects come first, because they are the main content of a scene.
    const members = this.schema.membersOf(this.schema.json, this.scene).filter(([name]) => !skipped.has(name));
    const order = ["objects", "camera", "sun", "sky", "lights", "ground", "render", "time"];
    const rank = ([name]) => (order.indexOf(name) + order.length + 1) % (order.length + 1);
    members.sort((a, b) => rank(a) - rank(b));
    for (const [name, schema] of members) this.add(this.node, name, schema, this.scene[name], name, 0);
  }

  add(into, path, unresolved, value, name, depth) {
    const schema = this.schema.resolve(unresolved);
    const isList = schema.type === "array" && schema.items && !["number", "integer"].includes(schema.items.type);
    if (isList && Array.isArray(value) && value.length > 0 && isGroup(this.schema.resolve(schema.items))) {
      this.addGroup(into, path, name, value, depth, () =>
        value.map((item, i) => [String(i), schema.items, item]));
    } else if (isGroup(schema) && (value === undefined || (typeof value === "object" && !value.keys))) {
      const group = forms(schema).group ?? forms(schema).plain;
      this.addGroup(into, path, name, value, depth, () => {
        let members = this.schema.membersOf(group, value);
        // An object has one kind, so members of other kinds are not shown.
        if (/^objects\.[^.]+$/.test(path)) members = members.filter(([key]) => key === "material" || key in value);
        return members.map(([key, member]) => [key, member, value?.[key]]);
      });
    } else {
      this.addRow(into, path, schema, value, name);
    }
  }

  addGroup(into, path, name, value, depth, members) {
    const body = element("div", {});
    const node = element("details", { class: value === undefined ? "" : "given" }, element("summary", {}, name), body);
    const fill = () => {
      if (body.childElementCount > 0) return;
      for (const [key, schema, member] of members()) this.add(body, `${path}.${key}`, schema, member, key, depth + 1);
      for (const [at, row] of this.rows) if (at.startsWith(`${path}.`)) this.refresh(at, row);
    };
    if (this.filter) {
      // Searches only the first levels of absent optional groups, because a group may contain itself.
      if (depth < 6 && (value !== undefined || depth < 3)) fill();
      node.open = true;
      if (body.childElementCount > 0) into.append(node);
      return;
    }
    const first = depth <= 2 && path.startsWith("objects") && value !== undefined;
    node.open = opened.has(path) || (first && !opened.has(`-${path}`));
    if (node.open) fill();
    node.addEventListener("toggle", () => {
      opened.delete(node.open ? `-${path}` : path);
      opened.add(node.open ? path : `-${path}`);
      if (node.open) fill();
    });
    into.append(node);
  }

  addRow(into, path, schema, value, name) {
    const words = wordsOf(schema);
    if (this.filter && !`${path} ${words.text}`.toLowerCase().includes(this.filter)) return;
    const made = control(schema, value, (next, moving) => this.on.set(path, next, moving));
    const undo = element("button", { class: "undo", title: "Take back", "aria-label": `Take back ${name}`,
      onclick: () => this.on.forget(path) }, "↺");
    const known = () => valueAt(this.scene, path) ?? schema.default;
    if (forms(schema).moving && known() !== undefined)
      made.node.append(element("button", { class: "key", title: "A key at this frame, or none", "aria-label": `Key of ${name} at this frame`,
        onclick: () => this.on.set(path, withKey(known(), this.on.frame(), this.on.fps()), false) }, "◆"));
    if (words.unit) made.node.append(element("span", { class: "unit" }, words.unit));
    const node = element("div", { class: "row", "data-path": path },
      element("label", { title: path }, name), made.node, undo, element("div", { class: "doc" }, words.text));
    made.node.querySelector("input, select")?.setAttribute("aria-label", path);
    this.rows.set(path, { node, made, schema, undo });
    into.append(node);
  }

  refresh(path, { node, made, schema, undo }) {
    const value = valueAt(this.scene, path);
    // The value also counts as edited if only a key of it has been edited.
    const edited = [...this.edits.keys()].some((one) => one === path || one.startsWith(`${path}.`));
    node.classList.toggle("given", value !== undefined);
    node.classList.toggle("edited", edited);
    undo.hidden = !edited;
    if (node.contains(document.activeElement) && this.on.isHeld()) return;
    made.set(value ?? schema.default);
  }
}

export function valueAt(scene, path) {
  let value = scene;
  for (const key of path.split(".")) value = value?.[key];
  return value;
}

// Returns the structure of a value: its members and their types, without the values. If the structure changes, the rows
// are built again.
function shapeOf(value) {
  if (Array.isArray(value)) return value.length > 0 && typeof value[0] === "object" ? `[${value.map(shapeOf)}]` : "[]";
  if (value === null || typeof value !== "object") return typeof value === "number" ? "n" : typeof value;
  return `{${Object.entries(value).map(([key, member]) => `${key}:${shapeOf(member)}`)}}`;
}
