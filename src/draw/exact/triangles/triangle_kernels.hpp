#pragma once
#include "draw/exact/triangles/laid_fields.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/exact/visibility.hpp"
#include "draw/surface_fields.hpp"
#include "gl/kernel/kernel.hpp"

// Interfaces of the kernels that TriangleRaster runs.
namespace simreel::draw {

struct VertexKernel {
  static constexpr auto file = "draw/exact/triangles/vertices.comp";
  struct Variant {
    WorldVariant surface;
    gl::Flag<"PARALLEL"> parallel;
    gl::Flag<"SUN_MAP"> sunMap;
  };
  gl::Ambient<"ViewBlock"> view = {};
  gl::Ambient<"light"> light = {};
  WorldVertices surface;
  gl::Uniform<"vertexCount", int> vertexCount;
  gl::Uniform<"firstVertex", int> firstVertex;
  gl::Uniform<"mapTexels", float> mapTexels;
  gl::Shared<"VertexBlock"> vertices;
};

/// Uniforms, buffers and textures that draw/exact/triangles/raster.glsl declares.
struct RasterTriangles {
  gl::Ambient<"FrameBlock"> frame = {};
  SampleTarget into;
  TriangleSource source;
  gl::Uniform<"firstId", unsigned> firstId;
  gl::Uniform<"slopeOffset", float> slopeOffset;
  gl::Uniform<"doubleSided", bool> doubleSided;
  gl::Uniform<"firstView", int> firstView = {};
  gl::In<"owners"> owners = {};
  Cutout cutout = {};
  gl::Uniform<"firstLayer", bool> firstLayer = {};
  gl::In<"layerKeys"> layerKeys = {};  ///< visibility of the previous blended layer
  gl::In<"layerIds"> layerIds = {};
  gl::In<"opaqueKeys"> opaqueKeys = {};
  gl::Uniform<"draw_", int> draw;
  gl::Uniform<"draws", int> draws;
};
struct RasterVariant {
  TargetVariant target;
  gl::Flag<"PARALLEL"> parallel;
  gl::Flag<"COUNTED"> counted;     ///< the triangle count of the surface is in a GPU buffer
  gl::Flag<"JOINED"> joined;       ///< the triangles belong to joined surfaces
  gl::Range<"FACES", 1, 2> faces;  ///< set if all faces of lamp maps are drawn in one dispatch; the value
                                   ///< is the workgroup coordinate (1: y, 2: z) that selects the face
  gl::Flag<"CUTOUT"> cut;          ///< the surface has holes
  gl::Flag<"GRID"> grid;           ///< the surface with holes is a grid
  gl::Flag<"LAYER"> layer;         ///< the surface is blended
};

struct SmallTriangles {
  static constexpr auto file = "draw/exact/triangles/triangles.comp";
  struct Variant {
    RasterVariant raster;
    LaneVariant lanes;
    gl::Flag<"BINS"> bins;
  };
  RasterTriangles raster;
  BinFields bins;
  gl::Uniform<"smallPixels", int> smallPixels;
  gl::Uniform<"mediumPixels", int> mediumPixels;
  gl::Shared<"LargeBlock"> large;
  gl::Shared<"CounterBlock"> counters;
};

struct MediumTriangles {
  static constexpr auto file = "draw/exact/triangles/medium.comp";
  using Variant = RasterVariant;
  RasterTriangles raster;
  gl::In<"large"> large;
  gl::In<"counters"> counters;
};

/// Uniforms, buffers and textures that draw/exact/triangles/fans.glsl declares.
struct FanFields {
  gl::Uniform<"fanRoom", int> fanRoom;
  gl::Uniform<"firstFan", int> firstFan;
};

struct LargeTriangles {
  static constexpr auto file = "draw/exact/triangles/large.comp";
  struct Variant {
    RasterVariant raster;
    gl::Flag<"BINS"> bins;
    gl::Flag<"CLIPS"> clips;  ///< selects the variant that handles the triangles that are not clipped yet
  };
  RasterTriangles raster;
  FanFields fan;
  gl::In<"fans"> fans;
  gl::In<"large"> large;
  gl::In<"counters"> counters;
};

struct ClipTriangles {
  static constexpr auto file = "draw/exact/triangles/clip_large.comp";
  struct Variant {
    RasterVariant raster;
    gl::Flag<"BINS"> bins;
  };
  RasterTriangles raster;
  BinFields bins;
  FanFields fan;
  gl::Shared<"FanBlock"> fans;
  gl::In<"large"> large;
  gl::In<"counters"> counters;
  gl::Shared<"LargeBlock"> left;
  gl::Shared<"CounterBlock"> leftCounts;
};

}  // namespace simreel::draw
