// Moves the camera with the mouse. Positions and targets are in metres, and y points up. `height` is the view height of
// an orthographic camera.

const subtract = (a, b) => a.map((value, i) => value - b[i]);
const add = (a, b, factor = 1) => a.map((value, i) => value + factor * b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.hypot(...a);
const unit = (a) => a.map((value) => value / (length(a) || 1));
const round = (a) => a.map((value) => Number(value.toPrecision(6)));

// Rotates the camera about its target by angles in radians, but not beyond the poles.
export function orbit({ eye, target, ...lens }, turn, rise) {
  const arm = subtract(eye, target);
  const distance = length(arm);
  const elevation = Math.asin(Math.min(1, Math.max(-1, arm[1] / (distance || 1))));
  const about = Math.atan2(arm[0], arm[2]) - turn;
  const up = Math.min(1.55, Math.max(-1.55, elevation + rise));
  const next = [Math.cos(up) * Math.sin(about), Math.sin(up), Math.cos(up) * Math.cos(about)];
  return { eye: round(add(target, next, distance)), target, ...lens };
}

// Moves the camera and its target so that the point under the mouse follows the mouse. `right` and `up` are fractions
// of the picture's height.
export function pan({ eye, target, ...lens }, right, up) {
  const arm = subtract(target, eye);
  const high = lens.height ?? 2 * length(arm) * Math.tan((lens.angle * Math.PI) / 360);
  const side = unit(cross(arm, [0, 1, 0]));
  const top = cross(side, unit(arm));
  const by = add(side.map((value) => -value * right * high), top, up * high);
  return { eye: round(add(eye, by)), target: round(add(target, by)), ...lens };
}

export function zoom({ eye, target, ...lens }, factor) {
  if (lens.height) return { eye, target, ...lens, height: Number((lens.height * factor).toPrecision(6)) };
  return { eye: round(add(target, subtract(eye, target), factor)), target, ...lens };
}
