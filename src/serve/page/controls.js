// Makes one control for each type of value. A control has `node` and `set(value)`, and calls on(value, moving) after a
// change.
import { element, number } from "./dom.js";
import { forms, isColor } from "./schema.js";

const linear = (byte) => {
  const c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
};
const encoded = (light) => {
  const c = Math.min(1, Math.max(0, light));
  return Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055));
};
const hex = (rgb) => `#${rgb.map((light) => encoded(light).toString(16).padStart(2, "0")).join("")}`;

// Returns the range of a slider. This is the allowed range if it is narrow, and otherwise a range around the value.
function span(schema, value) {
  const { minimum = -1e9, maximum = 1e9 } = schema;
  if (maximum - minimum <= 1000 && (maximum - minimum <= 1 || Math.abs(value) > (maximum - minimum) / 50)) return [minimum, maximum];
  const reach = Math.abs(value) || 1;
  const whole = schema.type === "integer" ? Math.ceil(reach) : reach;
  return [Math.max(minimum, value >= 0 ? Math.min(0, value) : 2 * value), Math.min(maximum, value >= 0 ? 2 * whole : whole)];
}

function numberControl(schema, on) {
  const whole = schema.type === "integer";
  const slider = element("input", { type: "range", step: whole ? 1 : "any", tabindex: -1 });
  const box = element("input", { type: "number", step: whole ? 1 : "any", min: schema.minimum, max: schema.maximum });
  const read = (text) => (whole ? Math.round(Number(text)) : Number(Number(text).toPrecision(4)));
  const place = (value) => {
    const [low, high] = span(schema, value);
    [slider.min, slider.max, slider.value] = [low, high, value];
  };
  slider.addEventListener("input", () => { box.value = number(read(slider.value)); on(read(slider.value), true); });
  slider.addEventListener("change", () => { place(read(slider.value)); on(read(slider.value), false); });
  box.addEventListener("change", () => { if (box.value !== "") { place(Number(box.value)); on(Number(box.value), false); } });
  const node = element("span", { class: "value" }, slider, box);
  return { node, set: (value) => {
    const known = typeof value === "number";
    box.value = known ? number(value) : "";
    box.placeholder = known ? "" : "—";
    place(known ? value : Math.max(schema.minimum ?? 0, Math.min(schema.maximum ?? 1, 0.5)));
  } };
}

function severalControl(schema, on, color) {
  const count = schema.minItems ?? 3;
  const boxes = Array.from({ length: count }, () =>
    element("input", { type: "number", step: schema.items.type === "integer" ? 1 : "any" }));
  const picker = color ? element("input", { type: "color", "aria-label": "Colour" }) : null;
  let now = Array.from({ length: count }, () => 0); // exact values; the text boxes show them rounded
  boxes.forEach((box, i) => box.addEventListener("change", () => {
    now[i] = Number(box.value);
    if (picker) picker.value = hex(now);
    on([...now], false);
  }));
  const pick = (moving) => {
    const rgb = [1, 3, 5].map((at) => Number(linear(parseInt(picker.value.slice(at, at + 2), 16)).toPrecision(3)));
    boxes.forEach((box, i) => { box.value = number(rgb[i]); });
    now = rgb;
    on([...now], moving);
  };
  picker?.addEventListener("input", () => pick(true));
  picker?.addEventListener("change", () => pick(false));
  return { node: element("span", { class: "value three" }, picker, ...boxes), set: (value) => {
    const known = Array.isArray(value) && value.length === count;
    now = known ? [...value] : now.map(() => 0);
    boxes.forEach((box, i) => { box.value = known ? number(value[i]) : ""; });
    if (picker) picker.value = /^#[0-9a-f]{6}$/i.test(value) ? value : hex(known ? value : [0, 0, 0]);
  } };
}

function choiceControl(schema, on) {
  const words = schema.type === "boolean" ? [false, true] : schema.enum;
  if (schema.type === "boolean") {
    const box = element("input", { type: "checkbox" });
    box.addEventListener("change", () => on(box.checked, false));
    return { node: element("span", { class: "value" }, box), set: (value) => { box.checked = value === true; } };
  }
  const list = element("select", {}, element("option", { value: "" }, "—"),
    ...words.map((word, i) => element("option", { value: i }, String(word))));
  list.addEventListener("change", () => { if (list.value !== "") on(words[Number(list.value)], false); });
  return { node: element("span", { class: "value" }, list), set: (value) => {
    const at = words.indexOf(value);
    list.value = at < 0 ? "" : String(at);
  } };
}

// Makes a control for a value with keyframes, with one row per key.
function framesControl(plain, value, on) {
  const list = element("span", { class: "frames" });
  let now = structuredClone(value);
  const read = (text) => Number(text);
  const show = () => {
    const rows = now.keys.map(([time, at], i) => {
      const values = Array.isArray(at) ? at : [at];
      const boxes = [time, ...values].map((one, k) => element("input", { type: "number", step: "any", value: number(one),
        title: k === 0 ? "s" : "", onchange: (event) => {
          const changed = read(event.target.value);
          if (k === 0) now.keys[i][0] = changed;
          else if (Array.isArray(at)) now.keys[i][1][k - 1] = changed;
          else now.keys[i][1] = changed;
          on(now, false);
        } }));
      return element("span", {}, ...boxes);
    });
    list.replaceChildren(...rows);
  };
  show();
  return { node: element("span", { class: "value" }, list), set: (next) => { now = structuredClone(next); show(); } };
}

export function control(schema, value, on) {
  const { plain, moving } = forms(schema);
  if (moving && value && typeof value === "object" && Array.isArray(value.keys)) return framesControl(plain, value, on);
  if (plain?.type === "number" || plain?.type === "integer") return numberControl(plain, on);
  if (plain?.type === "array" && plain.items?.type && plain.minItems === plain.maxItems && plain.minItems <= 3)
    return severalControl(plain, on, isColor(schema));
  if (plain?.type === "boolean" || plain?.enum) return choiceControl(plain, on);
  const box = element("input", { type: "text", spellcheck: "false" });
  const isText = plain?.type === "string";
  box.addEventListener("change", () => {
    try {
      on(isText ? box.value : JSON.parse(box.value), false);
      box.setCustomValidity("");
    } catch {
      box.setCustomValidity("This is no JSON");
      box.reportValidity();
    }
  });
  return { node: element("span", { class: "value" }, box), set: (next) => {
    box.value = next === undefined ? "" : isText ? next : JSON.stringify(next);
  } };
}
