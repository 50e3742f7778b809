// Small helpers of the page.

export const byId = (id) => document.getElementById(id);

export function element(name, attributes, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(key, value === true ? "" : value);
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

// Whether keys are letters to what has the focus. Sliders and boxes to tick hear no more than arrows and the space bar.
export const typing = (target) => target.matches("select, textarea, input:not([type='range'], [type='checkbox'], [type='color'])");

// Short, and as it would be written in a scene.
export function number(value) {
  if (!Number.isFinite(value)) return String(value);
  return String(Number(value.toPrecision(5)));
}
