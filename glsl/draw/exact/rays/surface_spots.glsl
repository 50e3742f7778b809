// Stores a visible point of a surface (spot, see spots.glsl) for the ray kernels.
#include "draw/exact/rays/spots.glsl"
#include "draw/exact/rays/rounded_place.glsl"

// Returns the world position of a triangle corner given in picture coordinates (draw/exact/corner_place.glsl).
vec3 cornerPlace(vec3 corner) {
#ifdef PARALLEL
  return placeOnRay(rayThrough(corner.xy), corner.z);
#endif
  precise vec3 p = vec3(view.eye) + vec3(view.ray) * corner.z + vec3(view.rayAcross) * corner.x + vec3(view.rayDown) * corner.y;
  return p;
}
vec3 cornerNormal(int vertex, bool turned) {
  vec3 n = unpackedUnit(texelFetch(vertices, vertex).w);
  return turned ? -n : n;
}

// Stores the spot. `owner` has the same meaning as in keepSpot(). `clear` is true for transmissive surfaces, where rays
// start at the flat triangle instead of the rounded position.
void keepSurfaceSpot(Spot spot, Look look, vec3 normal, int sampleAt, uint owner, bool clear) {
  vec3 a = cornerPlace(spot.a), b = cornerPlace(spot.b), c = cornerPlace(spot.c);
  precise vec3 first = b - a;
  precise vec3 second = c - a;
  vec3 across = exactCross(first, second);
  float square = exactDot(across, across);
  precise vec3 facing = square < 1e-30f ? spot.normal : across * exactInverseSqrt(square);
  facing = exactDot(facing, spot.view) < 0.0f ? -facing : facing;
  bool turned = exactDot(spot.normal, facing) < 0.0f;
  vec3 p = clear ? spot.place : roundedPlace(spot.place, a, b, c, cornerNormal(spot.corners.x, turned), cornerNormal(spot.corners.y, turned),
                        cornerNormal(spot.corners.z, turned), spot.weight);
  precise vec3 moved = p - spot.place;
  keepSpot(sampleAt, p, facing, exactDot(normal, facing) < 0.0f ? -normal : normal, look.base,
           vec3(look.roughness, look.metallic, look.translucency), 1.0f, owner | (turned ? 0x80000000u : 0u),
           turned ? -spot.normal : spot.normal, exactDot(moved, facing));
}
