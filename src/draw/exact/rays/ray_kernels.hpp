#pragma once
#include "draw/exact/visibility.hpp"
#include "gl/kernel/kernel.hpp"

// What kernels of draw/exact/rays read of the things that rays meet.
namespace simreel::draw {

/// Looks of triangles: looks.glsl, solid_words.glsl, lays.glsl and the maps that are laid over them.
struct RayLookFields {
  gl::In<"looks"> looks;
  gl::In<"corners"> corners;
  gl::In<"vertexWords"> words;
  gl::In<"lays"> lays;
  gl::In<"texelsOfMaps"> maps;
};

/// Triangles and balls in their order: met_triangle.glsl and found_facet.glsl.
struct SortedSolids {
  gl::In<"sortedSolids"> solids;
  gl::In<"solidIds"> ids;
  gl::In<"sortedBalls"> balls;
};

/// The trees above them: traverse.glsl.
struct SolidTrees {
  gl::In<"solidNodes"> solidNodes;
  gl::In<"ballNodes"> ballNodes;
  gl::Uniform<"solidCount", int> solidCount;
  gl::Uniform<"solidLeaves", int> solidLeaves;
  gl::Uniform<"ballCount", int> ballCount;
  gl::Uniform<"ballLeaves", int> ballLeaves;
};

/// Looks of balls and of skins: found_facet.glsl and skin_hit.glsl.
struct FoundFields {
  gl::In<"ballLooks"> ballLooks;
  gl::In<"skinTexels"> skinTexels;
};

/// emitters.glsl.
struct EmitterFields {
  gl::In<"emitters"> emitters;
  gl::In<"solidPlaces"> places;
  gl::Uniform<"emitterCount", int> count;
  gl::Uniform<"perEmission", float> perEmission;
};

/// What of all this there is.
struct RayFeatures {
  bool triangles = false, balls = false, ground = false;
  bool laid = false, skins = false, emitters = false, finished = false;
  bool passages = false;  ///< glass or holes
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
    gl::Flag<"LISTED"> listed = {};   ///< rays of two lists,
    gl::Flag<"GOES_ON"> goesOn = {};  ///< or of one
  };
  gl::Ambient<"FrameBlock"> frame = {};
  SortedSolids solids;
  SolidTrees trees;
  RayLookFields looks = {};
  gl::In<"BoundsBlock"> bounds;
  gl::In<"rays"> rays;
  gl::In<"goingOn"> list = {};
  gl::In<"RayListCountBlock"> counts = {};
  gl::Uniform<"firstRay", int> firstRay;
  gl::Uniform<"rayCount", int> rayCount;
  gl::Out<"HitBlock"> hits;
};

}  // namespace simreel::draw
