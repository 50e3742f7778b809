// Pixels of the finished picture, 8 bits a component, exactly. Compiles as GLSL and as C++.

// The numbers 0 to 255 of what an image of that format gives, whichever way a driver divides by 255.
FUNCTION vec4 bytesOf(vec4 loaded) {
  ROUNDED vec4 bytes = loaded * 255.0f + 0.5f;
  return floor(bytes);
}

// What such an image is given for them: every driver rounds it back to the same.
FUNCTION vec4 storedBytes(vec4 bytes) {
  ROUNDED vec4 stored = clamp(bytes, 0.0f, 255.0f) * 0.00392156863f;
  return stored;
}

// A colour times its opacity, and its opacity, over the bytes that are there. Those are straight: where they hide nothing they
// have no part in the colour.
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

// Light times coverage, and coverage: `front` stays in front of what is laid behind it.
FUNCTION vec4 laidBehind(vec4 front, vec4 behind) {
  ROUNDED vec4 sum = front + behind * (1.0f - front.w);
  return sum;
}
