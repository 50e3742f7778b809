// Pixels of the finished picture, 8 bits per component, converted exactly. Compiles as GLSL and as C++.

// Returns the bytes (0 to 255) of a value loaded from an 8-bit image, independent of how the driver divides by 255.
FUNCTION vec4 bytesOf(vec4 loaded) {
  ROUNDED vec4 bytes = loaded * 255.0f + 0.5f;
  return floor(bytes);
}

// Returns the value to store in an 8-bit image for the given bytes; every driver rounds it back to the same bytes.
FUNCTION vec4 storedBytes(vec4 bytes) {
  ROUNDED vec4 stored = clamp(bytes, 0.0f, 255.0f) * 0.00392156863f;
  return stored;
}

// Blends a pixel (premultiplied colour, opacity) over the bytes of the picture. The picture's alpha is straight, so the
// colour of a fully transparent pixel does not contribute.
FUNCTION vec4 laidOver(vec4 bytes, vec4 pixel) {
  ROUNDED vec4 sum = pixel * 255.0f + bytes * (1.0f - pixel.w) + 0.5f;
  if (bytes.w > 254.5f || pixel.w >= 1.0f) return floor(sum);
  ROUNDED float hidden = bytes.w * 0.00392156863f * (1.0f - pixel.w);
  ROUNDED float cover = pixel.w + hidden;
  if (cover < 1e-4f) return vec4(0.0f);
  ROUNDED vec3 color = (vec3(pixel) * 255.0f + vec3(bytes) * hidden) * inverse(cover) + 0.5f;
  ROUNDED float alpha = cover * 255.0f + 0.5f;
  return floor(vec4(color, alpha));
}

// Adds `behind` behind `front`. Both hold light, premultiplied by coverage, and coverage.
FUNCTION vec4 laidBehind(vec4 front, vec4 behind) {
  ROUNDED vec4 sum = front + behind * (1.0f - front.w);
  return sum;
}
