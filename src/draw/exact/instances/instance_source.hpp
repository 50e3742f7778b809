#pragma once
#include "draw/instances/instance_values.hpp"
#include "gl/kernel/kernel.hpp"

// What kernels of the exact rasterizer read of instances, a group of fields for each file that they
// include.
namespace simreel::draw {

/// draw/exact/instances/instance_source.glsl.
struct InstanceSource {
  gl::Ambient<"FrameBlock"> frame;
  InstanceFields instance;
  gl::Uniform<"capacity", int> capacity;
  gl::Uniform<"firstId", unsigned> firstId;
};
[[nodiscard]] inline InstanceSource instanceSource(const sim::Instances& instances, float shapeRadius,
                                                   float minPixels, unsigned firstId) {
  return {.frame = {},
          .instance = instanceFields(instances, shapeRadius, minPixels),
          .capacity = instances.capacity,
          .firstId = firstId};
}

/// draw/exact/copies/copy_source.glsl.
struct CopySource {
  InstanceSource source;
  gl::In<"indices"> indices;
  gl::In<"shape"> shape;
  gl::Uniform<"alongVelocity", bool> alongVelocity;
  gl::Uniform<"triangles", unsigned> triangles;
};

}  // namespace simreel::draw
