#pragma once
#include "draw/instances/instance_shape.hpp"
#include "draw/surface_fields.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/drawable.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <vector>

namespace simreel::draw {

[[nodiscard]] inline bool isSprite(const sim::Instances& instances) {
  return instances.shape == sim::Instances::Shape::sprite;
}

/// Returns the texture for the input `turns` of glsl/draw/screen/copy_vertex.glsl, or any texture if the
/// shader does not read `turns`.
[[nodiscard]] inline const gl::Texture& turnsOf(const sim::Instances& instances) {
  return instances.turns != nullptr ? *instances.turns : *instances.velocities;
}
/// Returns the min radius (pixels) with which sprites are drawn; 0 for other shapes.
[[nodiscard]] float minPixelsOf(const sim::Instances& instances);

/// Uniforms, buffers and textures that glsl/draw/instances/instance.glsl declares.
struct InstanceFields {
  gl::In<"positions"> positions;
  gl::In<"velocities"> velocities;
  gl::Uniform<"size", float> size;
  gl::Uniform<"shapeRadius", float> shapeRadius;
  gl::Uniform<"massExponent", float> massExponent;
  gl::Uniform<"perMassReference", float> perMassReference;
  gl::Uniform<"minPixels", float> minPixels;
};
/// Returns the shader inputs of instances. `shapeRadius`: radius of the shape at size 1 (m).
[[nodiscard]] InstanceFields instanceFields(const sim::Instances& instances, float shapeRadius,
                                            float minPixels);
/// Inputs of glsl/draw/instances/instance_list.glsl that determine the colours.
struct InstanceLook {
  gl::In<"stops"> stops;
  gl::Uniform<"colorBy", int> colorBy;
  gl::Uniform<"colorFactor", float> colorFactor;
  gl::Uniform<"colorOffset", float> colorOffset;
  gl::Uniform<"stopCount", int> stopCount;
  gl::Uniform<"color", glm::vec3> color;
  gl::Uniform<"brightness", float> brightness;
  gl::Uniform<"fade", float> fade;
};
/// Further inputs of glsl/draw/instances/instance_list.glsl, which describe one level of a VisibleList.
struct ListFields {
  gl::In<"list"> list;
  gl::In<"arguments"> arguments;
  gl::Uniform<"level", int> level;
};

/// Shapes of instances, created on first use.
class InstanceShapes {
 public:
  /// `points`: as in InstanceShape::sprite().
  explicit InstanceShapes(bool points) : points_(points) {}
  const InstanceShape& of(const sim::Instances& instances);

 private:
  bool points_;
  std::unique_ptr<InstanceShape> sprite_, sphere_;
  std::map<std::filesystem::path, InstanceShape> meshes_;
};

struct BoundsOfInstances;

/// Extends the bounds of the sun's shadow map by instances that cast shadows; see ShadowPass::fit().
class InstanceBounds {
 public:
  void grow(const sim::Drawables& drawables, InstanceShapes& shapes, const gl::Buffer& bounds);

 private:
  gl::Kernels<BoundsOfInstances> kernels_;
};

/// Colours of instances on the GPU.
class InstanceColors {
 public:
  /// Uploads the current colours.
  void update(const sim::Instances& instances);
  [[nodiscard]] InstanceLook look(const sim::Instances& instances) const;

 private:
  std::vector<glm::vec3> stops_;
  gl::Buffer buffer_;
  gl::Texture view_;
};

}  // namespace simreel::draw
