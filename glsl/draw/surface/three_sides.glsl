// A surface seen along the three axes of its own space: where a picture that is laid on from there lies, and how much of
// each of the three shows. Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"

// Along x, y and z, m: to the right and down as it is seen from outside.
struct ThreeSides {
  vec3 side;  // 1 or -1: from where each is seen
  vec2 x, y, z;
  vec3 weight;  // of sum 1
};

// p in the surface's own space (m), and the normal there.
FUNCTION ThreeSides threeSides(vec3 p, vec3 normal) {
  ThreeSides three;
  three.side = vec3(normal.x > 0.0f ? 1.0f : -1.0f, normal.y > 0.0f ? 1.0f : -1.0f, normal.z > 0.0f ? 1.0f : -1.0f);
  ROUNDED vec3 turned = three.side * vec3(p.z, p.z, p.x);
  three.x = vec2(-turned.x, -p.y);
  three.y = vec2(p.x, turned.y);
  three.z = vec2(turned.z, -p.y);
  ROUNDED vec3 weight = normal * normal;  // to the 16th power: sharp borders, yet no edges
  weight = weight * weight;
  weight = weight * weight;
  weight = weight * weight;
  ROUNDED float sum = weight.x + weight.y + weight.z;
  weight = weight * inverse(max(sum, 1e-30f));
  three.weight = weight;
  return three;
}
