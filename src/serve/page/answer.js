// Shows the information about a clicked pixel.
import { element, number } from "./dom.js";

export function showAnswer(into, message) {
  const close = element("button", { class: "undo", title: "Close", onclick: () => { into.hidden = true; } }, "×");
  const rows = message.rows.map(([name, value, bits]) => element("tr", {}, element("td", { class: "quiet" }, name),
    element("td", {}, typeof value === "number" ? number(value) : String(value)), element("td", { class: "bits" }, bits ?? "")));
  into.replaceChildren(element("h2", {}, element("span", {}, message.title), close), element("table", {}, element("tbody", {}, ...rows)));
  into.hidden = false;
}
