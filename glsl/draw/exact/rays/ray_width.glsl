// Returns the width (m) of the area that a continuation ray represents at its hit point. The ray represents an equal
// fraction of the solid angle of all rays of the pixel (as in Colbert and Krivanek, "GPU-Based Importance Sampling",
// GPU Gems 3, 2007). The width is combined with the size of a pixel at that distance.
float rayWidth(vec3 origin, float t, float density) {
  precise float all_ = density * float(sampleMask + 1u);
  precise float angle = min(exactReciprocal(max(all_, 1e-6f)), 1.0f);
  float pixel = exactSqrt(exactDot(view.rayDown.xyz, view.rayDown.xyz));  // size of a pixel at depth 1, in metres
#ifdef PARALLEL
  float distance_ = pixel;  // in orthographic views, a pixel has the same size at every depth
#else
  precise vec3 way = origin - view.eye.xyz;
  precise float distance_ = (exactSqrt(exactDot(way, way)) + t) * pixel;
#endif
  precise float square = t * t * angle + distance_ * distance_;
  return exactSqrt(square);
}
