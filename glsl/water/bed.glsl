// Height of the bed from another object's surface of heights. Compiles as GLSL and as C++ (tests/reference). The including
// file provides surfaceUnder() of mesh/height_model.glsl and waterFlush() of water/model.glsl.

struct WaterGround {
  vec2 corner;  // x and z of cell (0, 0) in the world, m
  float cell;   // Width of a cell, m
  float base;   // Height of level 0 in the world, m
};

// Returns a cell on the surface. Its depth stays the same, so that a rising bed lifts the water. Cells beside the surface
// keep their bed. If `fresh` is true, the level stays the same instead, or is the bed where that is higher.
FUNCTION vec4 waterOnBed(vec4 texel, ivec2 at, WaterGround ground, bool fresh) {
  precise float x = ground.corner.x + ground.cell * float(at.x);
  precise float z = ground.corner.y + ground.cell * float(at.y);
  SurfacePoint surface = surfaceUnder(x, z);
  precise float height = surface.height - ground.base;
  float bed = surface.there ? waterFlush(height) : texel.w;
  precise float depth = texel.x - texel.w;
  depth = max(depth, 0.0f);
  precise float lifted = bed + depth;
  float level = fresh ? max(texel.x, bed) : bed == texel.w ? texel.x : waterFlush(lifted);
  return vec4(level, texel.y, texel.z, bed);
}
