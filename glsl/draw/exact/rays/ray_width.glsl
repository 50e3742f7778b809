// How wide a place is that a ray onwards stands for, m across: its share of the solid angle that all of the pixel's rays have (as Colbert and
// Krivanek, "GPU-Based Importance Sampling", GPU Gems 3, 2007), and what the pixel covers at that distance.
float rayWidth(vec3 origin, float t, float density) {
  precise float all_ = density * float(sampleMask + 1u);
  precise float angle = min(exactReciprocal(max(all_, 1e-6f)), 1.0f);
  float pixel = exactSqrt(exactDot(view.rayDown.xyz, view.rayDown.xyz));  // m across at depth 1
#ifdef PARALLEL
  float distance_ = pixel;  // at any
#else
  precise vec3 way = origin - view.eye.xyz;
  precise float distance_ = (exactSqrt(exactDot(way, way)) + t) * pixel;
#endif
  precise float square = t * t * angle + distance_ * distance_;
  return exactSqrt(square);
}
