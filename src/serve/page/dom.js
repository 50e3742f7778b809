// Helper functions for DOM elements and numbers.

export const byId = (id) => document.getElementById(id);

export function element(name, attributes, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(key, value === true ? "" : value);
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

// True if the focused element accepts typed text. Sliders and checkboxes only use the arrow keys and the space bar.
export const typing = (target) => target.matches("select, textarea, input:not([type='range'], [type='checkbox'], [type='color'])");

// Formats a number with at most five digits, in the notation of scenes.
export function number(value) {
  if (!Number.isFinite(value)) return String(value);
  return String(Number(value.toPrecision(5)));
}
