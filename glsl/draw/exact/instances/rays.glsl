// Rays of depth 1 from the eye through picture positions (pixels). Compiles as GLSL and as C++.
struct Rays {
  vec3 first;   // ray through the picture's top left corner
  vec3 across;  // change of the ray per pixel to the right
  vec3 down;    // change of the ray per pixel downwards
};

FUNCTION vec3 rayAt(Rays rays, vec2 place) {
  precise vec3 ray = rays.first + rays.across * place.x + rays.down * place.y;
  return ray;
}
