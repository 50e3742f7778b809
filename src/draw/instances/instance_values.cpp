#include "draw/instances/instance_values.hpp"

#include "base/log.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <algorithm>
#include <span>

#include <glm/vec4.hpp>

namespace simreel::draw {

struct BoundsOfInstances {
  static constexpr auto file = "draw/surface/shadow_bounds.comp";
  struct Variant {
    gl::Flag<"INSTANCES"> instances;
    gl::Flag<"BOX"> box;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  InstanceFields instance;
  gl::Uniforms<"corners", glm::vec3, 2> corners;
  gl::Uniform<"vertexCount", int> vertexCount;
  gl::Uniform<"invocations", int> invocations;
  gl::Shared<"BoundsBlock"> bounds;
};

namespace {

/// Smaller glows would look like squares of 2x2 pixels, and their light would differ by more than 5% from
/// place to place within a pixel. Smaller balls would be missed if they lie between samples.
constexpr float minGlow = 1.75F;  // min radius of glows in pixels
constexpr float minBall = 0.57F;

template <class Make>
const InstanceShape& made(std::unique_ptr<InstanceShape>& shape, Make make) {
  if (!shape) shape = std::make_unique<InstanceShape>(make());
  return *shape;
}

}  // namespace

float minPixelsOf(const sim::Instances& instances) {
  if (!isSprite(instances)) return 0;
  return instances.additive ? minGlow : minBall;
}

InstanceFields instanceFields(const sim::Instances& instances, float shapeRadius, float minPixels) {
  return {.positions = *instances.positions,
          .velocities = *instances.velocities,
          .size = instances.size,
          .shapeRadius = shapeRadius,
          .massExponent = instances.massExponent,
          .perMassReference = 1.0F / instances.massReference,
          .minPixels = minPixels};
}

const InstanceShape& InstanceShapes::of(const sim::Instances& instances) {
  switch (instances.shape) {
    case sim::Instances::Shape::sprite:
      return made(sprite_, [&] { return InstanceShape::sprite(points_); });
    case sim::Instances::Shape::sphere:
      return made(sphere_, InstanceShape::sphere);
    case sim::Instances::Shape::mesh:
      break;
  }
  const auto found = meshes_.find(instances.mesh);
  if (found != meshes_.end()) return found->second;
  const sim::Mesh mesh = sim::loadMesh(instances.mesh);
  if (!mesh.materials.empty() || !mesh.colors.empty())
    warn("{}: each copy has a single colour; {} of {} are not drawn", objectName(instances),
         mesh.materials.empty() ? "the colours of vertices"
         : mesh.colors.empty()  ? "the materials"
                                : "the materials and the colours of vertices",
         instances.mesh.string());
  return meshes_.emplace(instances.mesh, InstanceShape::mesh(mesh.positions, mesh.normals, mesh.indices))
      .first->second;
}

void InstanceBounds::grow(const sim::Drawables& drawables, InstanceShapes& shapes,
                          const gl::Buffer& bounds) {
  constexpr int maxInvocations = 1 << 14;
  constexpr int each = 32;
  for (const sim::Instances& instances : drawables.instances) {
    if (!castsShadow(instances)) continue;
    const bool boxed = instances.boundsMin != instances.boundsMax;
    const int count = boxed ? 8 : instances.capacity;
    const int invocations = boxed ? 8 : std::clamp((count + each - 1) / each, 1, maxInvocations);
    kernels_.of({.instances = !boxed, .box = boxed})
        .dispatch(invocations, {.instance = instanceFields(instances, shapes.of(instances).radius(), 0),
                                .corners = std::vector{instances.boundsMin, instances.boundsMax},
                                .vertexCount = count,
                                .invocations = invocations,
                                .bounds = bounds});
  }
}

void InstanceColors::update(const sim::Instances& instances) {
  static const std::vector<glm::vec3> none(1, glm::vec3(1));
  const auto& stops = instances.colors != nullptr && !instances.colors->empty() ? *instances.colors : none;
  if (stops_ == stops) return;
  const bool sameSize = stops_.size() == stops.size();
  stops_ = stops;
  std::vector<glm::vec4> texels;
  texels.reserve(stops.size());
  for (const glm::vec3& stop : stops) texels.emplace_back(stop, 1.0F);
  if (sameSize) {
    buffer_.write(0, std::as_bytes(std::span(texels)));
    return;
  }
  view_ = {};
  buffer_ = gl::Buffer::of<glm::vec4>("colour stops", texels);
  view_ = gl::Texture::view("colour stops", GL_RGBA32F, buffer_);
}

InstanceLook InstanceColors::look(const sim::Instances& instances) const {
  const glm::vec2 range = instances.colorRange;
  const float scale = 1.0F / (range.y > range.x ? range.y - range.x : 1e-20F);
  return {.stops = view_,
          .colorBy = static_cast<int>(instances.colorBy),
          .colorFactor = scale,
          .colorOffset = -range.x * scale,
          .stopCount = static_cast<int>(stops_.size()),
          .color = instances.material->color,
          .brightness = instances.brightness,
          .fade = instances.fade};
}

}  // namespace simreel::draw
