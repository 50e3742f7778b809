#pragma once
#include "gl/kernel/fields.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

// Shader inputs of kernels that map textures onto surfaces. Each struct declares the inputs of one GLSL
// include file.
namespace simreel::draw {

/// Uniforms, buffers and textures that draw/exact/surface/vertex_uv.glsl declares.
struct VertexUv {
  gl::Uniform<"grid", glm::ivec2> grid;
  gl::Uniform<"perGrid", glm::vec2> perGrid;
  gl::Uniform<"perRow", float> perRow;
  gl::In<"uvs"> uvs;
};

/// Uniforms, buffers and textures that draw/exact/triangles/cutout.glsl declares.
struct Cutout {
  VertexUv uv;
  gl::Uniform<"textureScale", glm::vec2> textureScale;
  gl::Uniform<"colorMap", glm::ivec4> colorMap;
  gl::Uniform<"opacityLimit", glm::vec2> opacityLimit;
  gl::In<"texelsOfMaps"> texels;
};

}  // namespace simreel::draw
