// Rectangles of pixels. xy: first pixel; zw: last pixel (inclusive).
int pixelsIn(ivec4 box) {
  return (box.z - box.x + 1) * (box.w - box.y + 1);
}

// Returns the next pixel of the rectangle, in row-major order.
ivec2 nextIn(ivec4 box, ivec2 pixel) {
  return pixel.x < box.z ? ivec2(pixel.x + 1, pixel.y) : ivec2(box.x, pixel.y + 1);
}
