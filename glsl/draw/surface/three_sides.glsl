// Triplanar mapping: projects a texture onto a surface along the three axes of the object space and weights the three
// projections by the normal. Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"

// Texture positions (m) of the projections along x, y and z. They increase to the right and down as seen from outside.
struct ThreeSides {
  vec3 side;  // 1 or -1 per axis: side from which the surface is visible
  vec2 x, y, z;
  vec3 weight;  // weights of the three projections, with sum 1
};

// p, normal: position (m) and normal in object space.
FUNCTION ThreeSides threeSides(vec3 p, vec3 normal) {
  ThreeSides three;
  three.side = vec3(normal.x > 0.0f ? 1.0f : -1.0f, normal.y > 0.0f ? 1.0f : -1.0f, normal.z > 0.0f ? 1.0f : -1.0f);
  ROUNDED vec3 turned = three.side * vec3(p.z, p.z, p.x);
  three.x = vec2(-turned.x, -p.y);
  three.y = vec2(p.x, turned.y);
  three.z = vec2(turned.z, -p.y);
  ROUNDED vec3 weight = normal * normal;  // The 16th power of the normal makes the transitions between projections
                                          // narrow.
  weight = weight * weight;
  weight = weight * weight;
  weight = weight * weight;
  ROUNDED float sum = weight.x + weight.y + weight.z;
  weight = weight * inverse(max(sum, 1e-30f));
  three.weight = weight;
  return three;
}
