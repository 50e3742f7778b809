#pragma once
#include "gl/kernel/fields.hpp"
#include "sim/core/drawable.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

/// Shader inputs of kernels that read a sim::Surface. Each struct declares the inputs of one GLSL include
/// file.
namespace simreel::draw {

/// Returns the resource, or an empty one if the pointer is null.
template <class Kind>
[[nodiscard]] gl::Resource orNone(const Kind* resource) {
  return resource != nullptr ? gl::Resource(*resource) : gl::Resource();
}

/// Uniforms, buffers and textures that draw/surface/vertex_texel.glsl declares.
struct VertexTexels {
  gl::In<"positions"> positions;
  gl::Uniform<"heightShape", glm::ivec4> heightShape;
  gl::Uniform<"heightGrid", glm::vec4> heightGrid;
  gl::Uniform<"heightRim", float> heightRim;
  gl::In<"vertexColors"> colors;  ///< vertex colours as indices into the palette
  gl::Uniform<"colorComponent", int> colorComponent;
};
[[nodiscard]] VertexTexels vertexTexels(const sim::Surface& surface);

/// Shader inputs of draw/surface/vertex_texel.glsl and deformed_vertex.glsl, and the model matrix.
struct PlacedSurface {
  VertexTexels texels;
  gl::In<"DeformBlock"> deform;
  gl::In<"trail"> trail;
  gl::Uniform<"model", glm::mat4> model;
};
[[nodiscard]] PlacedSurface placed(const sim::Surface& surface);

/// Uniforms, buffers and textures that draw/exact/triangles/world_vertex.glsl declares.
struct WorldVertices {
  PlacedSurface placed;
  gl::Uniform<"grid", glm::ivec2> grid;
  gl::In<"normals"> normals;
};
struct WorldVariant {
  gl::Flag<"GRID"> grid;
  gl::Flag<"DEFORMED"> deformed;
};
[[nodiscard]] WorldVertices worldVertices(const sim::Surface& surface);
[[nodiscard]] WorldVariant worldVariant(const sim::Surface& surface);

/// Uniforms, buffers and textures that draw/surface/material.glsl declares.
struct MaterialFields {
  gl::Uniform<"roughness", float> roughness;
  gl::Uniform<"metallic", float> metallic;
  gl::Uniform<"translucency", float> translucency;
};
[[nodiscard]] MaterialFields materialFields(const scene::Material& material);

}  // namespace simreel::draw
