// The sky's gradient by the height y of a unit direction, and the light it gives.
vec3 skyRadiance(float y) {
  float up = 1.0 - clamp(y, 0.0, 1.0);
  up *= up;
  float down = clamp(-3.0 * y, 0.0, 1.0);
  vec3 above = mix(frame.zenith.rgb, frame.horizon.rgb, up * up * up);
  return mix(above, frame.nadir.rgb, down * down * (3.0 - 2.0 * down));
}

// Irradiance / pi on a surface whose normal has height y.
vec3 ambientLight(float y) {
  return frame.ambientSide.rgb + max(y, 0.0) * (frame.ambientUp.rgb - frame.ambientSide.rgb) +
         max(-y, 0.0) * (frame.ambientDown.rgb - frame.ambientSide.rgb);
}
