#pragma once
#include "draw/exact/visibility.hpp"
#include "gl/kernel/kernel.hpp"

// Shader inputs of kernels in draw/exact/rays that read the ray scene.
namespace simreel::draw {

/// Shader inputs of looks.glsl, solid_words.glsl, lays.glsl and the material maps: materials of triangles.
struct RayLookFields {
  gl::In<"materials"> materials;
  gl::In<"corners"> corners;
  gl::In<"vertexWords"> words;
  gl::In<"lays"> lays;
  gl::In<"texelsOfMaps"> maps;
};

/// Shader inputs of met_triangle.glsl and found_facet.glsl: triangles and balls in hierarchy order.
struct SortedSolids {
  gl::In<"sortedSolids"> solids;
  gl::In<"solidIds"> ids;
  gl::In<"sortedBalls"> balls;
};

/// Shader inputs of traverse.glsl: hierarchies of triangles and balls.
struct SolidTrees {
  gl::In<"solidNodes"> solidNodes;
  gl::In<"ballNodes"> ballNodes;
  gl::Uniform<"solidCount", int> solidCount;
  gl::Uniform<"solidLeaves", int> solidLeaves;
  gl::Uniform<"ballCount", int> ballCount;
  gl::Uniform<"ballLeaves", int> ballLeaves;
};

/// Shader inputs of found_facet.glsl and skin_hit.glsl: materials of balls and skins.
struct FoundFields {
  gl::In<"ballLooks"> ballLooks;
  gl::In<"skinTexels"> skinTexels;
};

/// Uniforms, buffers and textures that emitters.glsl declares.
struct EmitterFields {
  gl::In<"emitters"> emitters;
  gl::In<"solidPlaces"> places;
  gl::Uniform<"emitterCount", int> count;
  gl::Uniform<"perEmission", float> perEmission;
};

/// Features of the ray scene. They select kernel variants.
struct RayFeatures {
  bool triangles = false, balls = false, ground = false;
  bool laid = false, skins = false, emitters = false, finished = false;
  bool passages = false;  ///< true if light may pass through any material (with holes, blending or
                          ///< transmission)
  bool raised = false;
};

struct TraceRays {
  static constexpr auto file = "draw/exact/rays/trace.comp";
  struct Variant {
    gl::Flag<"TRIANGLES"> triangles;
    gl::Flag<"BALLS"> balls;
    gl::Flag<"GROUND"> ground = {};
    gl::Flag<"LAID"> laid = {};
    gl::Flag<"PASSAGES"> passages = {};
    gl::Flag<"ANY_HIT"> anyHit = {};
    gl::Flag<"LISTED"> listed = {};   ///< the kernel traces only the rays of two lists, whose lengths are
                                      ///< in a buffer
    gl::Flag<"GOES_ON"> goesOn = {};  ///< the kernel traces only the rays of one list
  };
  gl::Ambient<"FrameBlock"> frame = {};
  SortedSolids solids;
  SolidTrees trees;
  RayLookFields materials = {};
  gl::In<"BoundsBlock"> bounds;
  gl::In<"rays"> rays;
  gl::In<"goingOn"> list = {};
  gl::In<"RayListCountBlock"> counts = {};
  gl::Uniform<"firstRay", int> firstRay;
  gl::Uniform<"rayCount", int> rayCount;
  gl::Out<"HitBlock"> hits;
};

}  // namespace simreel::draw
