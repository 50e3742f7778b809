// A shading point: the point of a surface that a pixel shows.
#include "draw/arithmetic.glsl"
#include "draw/exact/ground_plane.glsl"
#include "draw/exact/weights.glsl"
#include "draw/exact/unit_vector.glsl"
#if defined PALETTE || defined TRIPLANAR
#include "draw/surface/vertex_texel.glsl"
#endif
#ifdef PALETTE
layout(binding = paletteUnit) uniform samplerBuffer palette;
#endif

#ifdef VERTEX_COLORS
#include "draw/bindings.glsl"
layout(binding = paletteUnit) uniform samplerBuffer vertexTints;
#endif

struct Spot {
  ivec3 corners;      // vertex indices of the triangle's three corners
  vec3 a, b, c;       // corners of the triangle, projected to the picture
  vec3 weight;        // barycentric weights of the corners
  vec2 at;            // position in the picture (pixels)
  vec3 place;         // world position of the shading point (m)
  vec3 normal;        // unit normal of the shading point
  vec3 view;          // unit vector to the eye
  bool turned;        // true if the triangle's back side is visible
};

// Returns the world position of a point of the triangle. w holds the weights of the corners, whose depths are a, b and
// c. `ray` is the ray through the picture position.
vec3 placeUnder(vec3 w, float a, float b, float c, vec3 ray) {
  precise float depth = w.x * a + w.y * b + w.z * c;
  return placeOnRay(ray, depth);
}

Spot spotOf(ivec3 corners, ivec2 pixel, int firstSample) {
  uvec4 a = texelFetch(vertices, corners.x), b = texelFetch(vertices, corners.y), c = texelFetch(vertices, corners.z);
  Spot spot;
  spot.corners = corners;
  spot.a = placeOf(a);
  spot.b = placeOf(b);
  spot.c = placeOf(c);
  spot.at = shadingPlace(pixel, -1);
  Weights weights = weightsAt(spot.a, spot.b, spot.c, spot.at);
  if (!weights.within) {
    spot.at = shadingPlace(pixel, firstSample);
    weights = weightsAt(spot.a, spot.b, spot.c, spot.at);
  }
  vec3 w = weights.of;
  spot.weight = w;
  spot.turned = weights.turned;
  vec3 ray = rayThrough(spot.at);
  spot.place = placeUnder(w, spot.a.z, spot.b.z, spot.c.z, ray);
  precise vec3 mean = w.x * unpackedUnit(a.w) + w.y * unpackedUnit(b.w) + w.z * unpackedUnit(c.w);
  spot.normal = unitOf(mean);
  precise vec3 towards = -directionOf(ray);
  spot.view = unitOf(towards);
  return spot;
}

// Returns the barycentric weights on the triangle's plane at the pixel offset `aside`.
vec3 weightsBeside(Spot spot, vec2 aside) {
  precise vec2 at = spot.at + aside;
  return ofSumOne(weightsAround(spot.a, spot.b, spot.c, at));
}

#if defined REFLECTED || defined REFRACTED
// Returns the angle between the normals of neighbouring half pixels (radians): the larger of the angles along x and y.
float turnsOn(Spot spot) {
  vec3 a = unpackedUnit(texelFetch(vertices, spot.corners.x).w), b = unpackedUnit(texelFetch(vertices, spot.corners.y).w);
  vec3 c = unpackedUnit(texelFetch(vertices, spot.corners.z).w);
  float maximum = 0.0f;
  for (int i = 0; i < 2; ++i) {
    vec3 w = weightsBeside(spot, vec2(i == 0 ? 2.0f : 0.0f, i == 0 ? 0.0f : 2.0f));
    precise vec3 mean = w.x * a + w.y * b + w.z * c;
    precise vec3 turned = unitOf(mean) - spot.normal;
    maximum = max(maximum, exactDot(turned, turned));
  }
  return exactSqrt(maximum);
}
#endif

#ifdef VERTEX_COLORS
// Returns the interpolated vertex colour.
vec3 tintOn(Spot spot) {
  vec3 w = spot.weight;
  precise vec3 mean = w.x * texelFetch(vertexTints, spot.corners.x - firstVertex_).rgb +
                      w.y * texelFetch(vertexTints, spot.corners.y - firstVertex_).rgb +
                      w.z * texelFetch(vertexTints, spot.corners.z - firstVertex_).rgb;
  return mean;
}
#endif

#ifdef PALETTE
vec3 paletteOf(int vertex) {
  return texelFetch(palette, vertexColor(vertex - firstVertex_)).rgb;
}
vec3 paletteColor(Spot spot) {
  vec3 w = spot.weight;
  precise vec3 mean = w.x * paletteOf(spot.corners.x) + w.y * paletteOf(spot.corners.y) + w.z * paletteOf(spot.corners.z);
  return mean;
}
#endif
