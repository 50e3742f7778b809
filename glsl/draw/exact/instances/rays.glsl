// Rays of depth 1 from the eye through places of the picture (pixels). Compiles as GLSL and as C++.
struct Rays {
  vec3 first;   // through the picture's top left corner
  vec3 across;  // what a pixel to the right adds to it
  vec3 down;    // what a pixel downwards adds to it
};

FUNCTION vec3 rayAt(Rays rays, vec2 place) {
  precise vec3 ray = rays.first + rays.across * place.x + rays.down * place.y;
  return ray;
}
