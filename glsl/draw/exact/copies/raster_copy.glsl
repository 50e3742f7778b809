// Code that the kernels that rasterize mesh copies have in common. An index identifies a pair of a visible copy and a
// triangle; it starts at 0 in each dispatch. Defines: as for raster_triangle.glsl.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/triangles/raster_triangle.glsl"
#include "draw/exact/copies/copy_source.glsl"
#ifdef SUN_MAP
#include "draw/exact/light_place.glsl"
#else
#include "draw/exact/copies/copy_place.glsl"
#endif
#ifdef ADDS
#include "draw/instances/instance_list.glsl"
#include "draw/exact/haze.glsl"
#endif
layout(binding = listUnit) uniform usamplerBuffer listedCopies;
uniform int firstListed;  // index of the first entry of these copies in the list of visible copies
uniform int skipped;      // number of list entries that earlier dispatches have handled

struct CopyTriangle {
  vec3 a, b, c;        // projected corners. x and y: pixels to the right and down, times depth; z: depth. In the sun's
                       // shadow map, x and y: texels; z: 1
  float na, nb, nc;    // nearness of the corners to the sun; used only for the sun's shadow map
  uint id;
};

#ifdef SUN_MAP
vec3 seenFrom(vec3 p, out float near) {
  vec3 place = lightPlace(p);
  precise vec2 texel = place.xy * float(mapTexels);
  precise float n = 1.0f - place.z;
  near = max(n, 0.0f);
  return vec3(texel, 1.0f);
}
Corner cornerAt(vec3 v, float near) {
  Corner corner = cornerOf(v, 0.0f);
  corner.near = near;
  return corner;
}
#else
vec3 seenFrom(vec3 p, out float near) {
  near = 0.0f;
  return rasterPlace(onPicture(p));
}
Corner cornerAt(vec3 v, float near) {
  return cornerOf(v, view.near);
}
#endif

CopyTriangle copyTriangle(uint pair) {
  uint triangle = pair % triangles;
  int slot = int(texelFetch(listedCopies, firstListed + skipped + int(pair / triangles)).x);
  Copy copy = copyOf(slot);
  ivec3 corners = cornersOf(triangle);
  CopyTriangle t;
  t.a = seenFrom(pointOf(copy, corners.x), t.na);
  t.b = seenFrom(pointOf(copy, corners.y), t.nb);
  t.c = seenFrom(pointOf(copy, corners.z), t.nc);
  t.id = firstId + uint(slot) * triangles + triangle;
#ifdef ADDS
  vec4 position = texelFetch(positions, slot), velocity = texelFetch(velocities, slot);
  precise vec3 light = tintOf(position, velocity) * brightnessAt(velocity.w);
#ifdef HAZE
  light = light * passed(hazeBefore(position.xyz));
#endif
  addedLight = light;
#endif
  return t;
}
