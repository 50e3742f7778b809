#include "draw/instances_pass.hpp"

#include "draw/surface_pass.hpp"
#include "gl/context.hpp"
#include "sim/mesh_file.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include <glm/vec4.hpp>

namespace simreel::draw {

namespace {

constexpr const char* featureNames[] = {"SPRITE", "ADDITIVE", "TRANSLUCENT", "REFLECTIVE", "DEPTH_ONLY"};
enum Feature : unsigned { sprite = 1, additive = 2, translucent = 4, reflective = 8, depthOnly = 16 };

/// Smaller glows shimmer as they move over the pixels; smaller balls fall between samples.
constexpr float leastGlow = 1.25F;  // pixels of radius
constexpr float leastBall = 0.5F;

std::vector<glm::vec2> offsetsOf(const gl::Framebuffer& target, int samples) {
  std::vector<glm::vec2> offsets;
  if (samples <= 1) return offsets;
  target.bind();
  for (int i = 0; i < samples; ++i) {
    glm::vec2 place(0.5F);
    glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i), &place.x);
    offsets.push_back(place - 0.5F);
  }
  return offsets;
}

}  // namespace

InstancesPass::InstancesPass(const ShadowPass& shadow, const gl::Framebuffer& target, int samples)
    : shadowDefines_(shadow.defines()),
      shadowed_(shadow.on()),
      samples_(samples),
      sampleOffsets_(offsetsOf(target, samples)) {}

const InstanceShape& InstancesPass::shape(const sim::Instances& instances) {
  switch (instances.shape) {
    case sim::Instances::Shape::sprite:
      if (!square_) square_ = std::make_unique<InstanceShape>(InstanceShape::square());
      return *square_;
    case sim::Instances::Shape::sphere:
      if (!sphere_) sphere_ = std::make_unique<InstanceShape>(InstanceShape::sphere());
      return *sphere_;
    case sim::Instances::Shape::mesh:
      break;
  }
  const auto found = meshes_.find(instances.mesh);
  if (found != meshes_.end()) return found->second;
  const sim::Mesh mesh = sim::loadMesh(instances.mesh);
  return meshes_.emplace(instances.mesh, InstanceShape::mesh(mesh.positions, mesh.normals, mesh.indices))
      .first->second;
}

const CullPrograms& InstancesPass::cullPrograms(bool forLight, int levels) {
  return cullPrograms_.try_emplace(levels * 2 + (forLight ? 1 : 0), forLight, levels).first->second;
}

unsigned InstancesPass::features(const sim::Instances& instances) const {
  const unsigned form = instances.shape == sim::Instances::Shape::sprite ? sprite : 0U;
  if (instances.additive) return form | additive;
  const scene::Material& material = *instances.material;
  return form | (material.translucency > 0 ? translucent : 0U) | (isReflective(material) ? reflective : 0U);
}

const gl::Program& InstancesPass::program(unsigned wanted) {
  const auto found = programs_.find(wanted);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = {{"SAMPLES", std::to_string(samples_)}};
  // Neither light nor the depth of the light's map is shaded.
  if ((wanted & (additive | depthOnly)) == 0)
    defines.insert(defines.end(), shadowDefines_.begin(), shadowDefines_.end());
  for (unsigned i = 0; i < std::size(featureNames); ++i)
    if ((wanted >> i & 1U) != 0) defines.emplace_back(featureNames[i], "1");
  return programs_
      .emplace(wanted, gl::Program::graphics("draw/instances.vert", "draw/instances.frag", defines))
      .first->second;
}

InstancesPass::Entry& InstancesPass::entry(const sim::Instances& instances, std::size_t i) {
  if (entries_.size() <= i) entries_.resize(i + 1);
  Entry& entry = entries_[i];
  const auto levels = static_cast<int>(shape(instances).levels().size());
  const auto fits = [&](const std::unique_ptr<VisibleList>& list) {
    return list && list->capacity() == instances.capacity && list->levels() == levels;
  };
  if (!fits(entry.forCamera)) entry.forCamera = std::make_unique<VisibleList>(instances.capacity, levels);
  if (shadowed_ && !instances.additive && !fits(entry.forLight))
    entry.forLight = std::make_unique<VisibleList>(instances.capacity, levels);
  static const std::vector<glm::vec3> none(1, glm::vec3(1));
  const auto& stops = instances.colors != nullptr && !instances.colors->empty() ? *instances.colors : none;
  if (entry.stops != stops) {
    entry.stops = stops;
    std::vector<glm::vec4> texels;
    for (const glm::vec3& stop : stops) texels.emplace_back(stop, 1.0F);
    entry.stopView = {};
    entry.stopBuffer = gl::Buffer::of<glm::vec4>("colour stops", texels);
    entry.stopView = gl::Texture::view("colour stops", GL_RGBA32F, entry.stopBuffer);
  }
  return entry;
}

void InstancesPass::setInstance(const gl::Program& program, const sim::Instances& instances,
                                bool forLight) {
  const bool isSprite = instances.shape == sim::Instances::Shape::sprite;
  program.set("size", instances.size);
  program.set("shapeRadius", shape(instances).radius());
  program.set("massScale", glm::vec2(instances.massExponent, 1.0F / instances.massReference));
  program.set("leastPixels", !isSprite || forLight ? 0.0F : instances.additive ? leastGlow : leastBall);
  instances.positions->bind(positionUnit);
  instances.velocities->bind(velocityUnit);
}

void InstancesPass::fill(const sim::Instances& instances, std::size_t i, bool forLight) {
  const Entry& own = entry(instances, i);
  const InstanceShape& form = shape(instances);
  const CullPrograms& programs = cullPrograms(forLight, static_cast<int>(form.levels().size()));
  setInstance(programs.cull, instances, forLight);
  // Coarser on the CPU, where triangles cost most.
  programs.cull.set("levelError", gl::softwareDriver() ? 0.5F : 0.2F);
  (forLight ? own.forLight : own.forCamera)->fill(programs, form);
}

void InstancesPass::cull(const sim::Drawables& drawables) {
  for (std::size_t i = 0; i < drawables.instances.size(); ++i) fill(drawables.instances[i], i, false);
}

void InstancesPass::cullForLight(const sim::Drawables& drawables) {
  for (std::size_t i = 0; i < drawables.instances.size(); ++i)
    if (!drawables.instances[i].additive) fill(drawables.instances[i], i, true);
}

void InstancesPass::growBounds(const sim::Drawables& drawables) {
  constexpr int mostInvocations = 1 << 14;
  constexpr int each = 32;
  for (const sim::Instances& instances : drawables.instances) {
    if (instances.additive) continue;
    const bool boxed = instances.boundsMin != instances.boundsMax;
    gl::Program& bounds = boxed ? boxBounds_ : bounds_;
    if (bounds.name() == 0)
      bounds = gl::Program::compute("draw/shadow_bounds.comp", {{boxed ? "BOX" : "INSTANCES", "1"}});
    const int count = boxed ? 8 : instances.capacity;
    const int invocations = boxed ? 8 : std::clamp((count + each - 1) / each, 1, mostInvocations);
    bounds.set("vertexCount", count);
    bounds.set("invocations", invocations);
    if (boxed) {
      bounds.set("corners[0]", instances.boundsMin);
      bounds.set("corners[1]", instances.boundsMax);
    } else {
      setInstance(bounds, instances, true);
    }
    bounds.dispatch(invocations);
  }
}

void InstancesPass::drawLevels(const gl::Program& program, const sim::Instances& instances,
                               const VisibleList& list) {
  const InstanceShape& form = shape(instances);
  program.set("vertexBits", form.vertexBits());
  program.set("alongVelocity", static_cast<int>(instances.alongVelocity));
  instances.positions->bind(positionUnit);
  if (form.vertices()) form.vertices().bind(shapeUnit);
  list.bind();
  vertices_.bind(form.indices());
  program.use();
  for (std::size_t level = 0; level < form.levels().size(); ++level) {
    program.set("level", static_cast<int>(level));
    program.set("batch", form.levels()[level].batch);
    glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT,
                           reinterpret_cast<const void*>(level * VisibleList::argumentBytes));
  }
}

void InstancesPass::castShadows(const sim::Drawables& drawables) {
  for (std::size_t i = 0; i < drawables.instances.size(); ++i) {
    const sim::Instances& instances = drawables.instances[i];
    if (instances.additive) continue;
    const gl::Program& shader = program((features(instances) & sprite) | depthOnly);
    setInstance(shader, instances, true);
    drawLevels(shader, instances, *entries_[i].forLight);
  }
}

void InstancesPass::draw(const sim::Drawables& drawables, bool adding) {
  for (std::size_t i = 0; i < drawables.instances.size(); ++i) {
    const sim::Instances& instances = drawables.instances[i];
    if (instances.additive != adding) continue;
    const Entry& own = entries_[i];
    const unsigned wanted = features(instances);
    const gl::Program& shader = program(wanted);
    const scene::Material& material = *instances.material;
    // Sprites face the eye, but a mesh may be open.
    DrawState{.depthTest = true,
              .cullBack = instances.shape == sim::Instances::Shape::sphere,
              .depthOffset = false,
              .adding = adding}
        .set();
    setInstance(shader, instances, false);
    const glm::vec2 range = instances.colorRange;
    const float scale = 1.0F / (range.y > range.x ? range.y - range.x : 1e-20F);
    shader.set("colorBy", static_cast<int>(instances.colorBy));
    shader.set("colorScale", glm::vec2(scale, -range.x * scale));
    shader.set("stopCount", static_cast<int>(own.stops.size()));
    shader.set("color", material.color);
    shader.set("glow", glm::vec2(instances.brightness, instances.fade));
    shader.set("roughness", material.roughness);
    shader.set("metallic", material.metallic);
    shader.set("translucency", material.translucency);
    for (std::size_t s = 0; s < sampleOffsets_.size(); ++s)
      shader.set(("sampleOffsets[" + std::to_string(s) + "]").c_str(), sampleOffsets_[s]);
    own.stopView.bind(stopUnit);
    drawLevels(shader, instances, *own.forCamera);
  }
}

}  // namespace simreel::draw
