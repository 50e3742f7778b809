#pragma once
#include "draw/instances/instance_values.hpp"
#include "gl/kernel/kernel.hpp"

// Shader inputs of kernels that read instances. Each struct declares the inputs of one GLSL include file.
namespace simreel::draw {

/// Uniforms, buffers and textures that draw/exact/instances/instance_source.glsl declares.
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

/// Uniforms, buffers and textures that draw/exact/copies/copy_source.glsl declares.
struct CopySource {
  InstanceSource source;
  gl::In<"indices"> indices;
  gl::In<"shape"> shape;
  gl::In<"turns"> turns;
  gl::Uniform<"turning", int> turning;
  gl::Uniform<"triangles", unsigned> triangles;
};

}  // namespace simreel::draw
