// Handles keyframes: values at times of the scene in seconds.

// Interpolates linearly between keys, regardless of their easing. This keeps a new key close to the old curve.
function valueBetween(keys, time) {
  const after = keys.findIndex(([at]) => at > time);
  if (after === 0) return keys[0][1];
  if (after < 0) return keys[keys.length - 1][1];
  const [[from, a], [to, b]] = [keys[after - 1], keys[after]];
  const part = (time - from) / (to - from);
  const mix = (x, y) => Number((x + part * (y - x)).toPrecision(6));
  return Array.isArray(a) ? a.map((x, i) => mix(x, b[i])) : mix(a, b);
}

export const isMoved = (value) => value !== null && typeof value === "object" && Array.isArray(value.keys);

// Returns the value with a key added at the frame. If the frame already has a key, removes that key. A value without
// keys becomes constant.
export function withKey(value, frame, fps) {
  const time = Number((frame / fps).toPrecision(6));
  if (!isMoved(value)) return { keys: [[time, value]] };
  const near = (at) => Math.abs(at - time) * fps < 0.5;
  const others = value.keys.filter(([at]) => !near(at));
  if (others.length === 0) return value.keys[0][1];
  if (others.length < value.keys.length) return { ...value, keys: others };
  return { ...value, keys: [...others, [time, valueBetween(others, time)]].sort(([a], [b]) => a - b) };
}
