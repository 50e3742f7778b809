#include "draw/instances/instances_pass.hpp"

#include "draw/surface/surface_pass.hpp"
#include "gl/context.hpp"
#include "gl/kernel/give.hpp"

#include <algorithm>
#include <string>

namespace simreel::draw {

namespace {

/// Max point size (pixels). Some drivers support only points up to 255 pixels.
constexpr float maxPointGlow = 64.0F;
/// The light of glows with a larger radius (pixels) is summed by all invocations of a workgroup instead of
/// by one.
constexpr float maxSmallSum = 5.0F;

gl::Defines lightingDefines(const ShadowPass& shadow, const Lamps& lamps) {
  gl::Defines defines = shadow.defines();
  defines.insert(defines.end(), lamps.defines().begin(), lamps.defines().end());
  return defines;
}

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

InstancesPass::InstancesPass(const ShadowPass& shadow, const Lamps& lamps, const gl::Framebuffer& target,
                             glm::ivec2 size, int samples)
    : lightDefines_(lightingDefines(shadow, lamps)),
      lampDefines_(lamps.order().shadowed > 0 ? lamps.shadowDefines() : gl::Defines()),
      shadowed_(shadow.on()),
      shadowSize_(shadow.size()),
      size_(size),
      samples_(samples),
      sampleOffsets_(offsetsOf(target, samples)),
      culling_(lampDefines_),
      small_(lightDefines_) {}

const gl::Program& InstancesPass::cached(const char* vertexPath, const char* fragmentPath,
                                         const gl::Defines& defines) {
  std::string key = std::string(vertexPath) + " " + fragmentPath;
  for (const auto& [name, value] : defines) key += " " + name;
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  return programs_.emplace(key, gl::Program::graphics(vertexPath, fragmentPath, defines)).first->second;
}

const gl::Program& InstancesPass::program(const sim::Instances& instances) {
  if (instances.additive)
    return isSprite(instances)
               ? cached("draw/instances/glow.vert", "draw/instances/glow.frag", {})
               : cached("draw/screen/copy.vert", "draw/screen/copy.frag", {{"ADDITIVE", "1"}});
  gl::Defines defines = lightDefines_;
  if (isReflective(*instances.material)) defines.emplace_back("REFLECTIVE", "1");
  if (instances.material->translucency > 0) defines.emplace_back("TRANSLUCENT", "1");
  defines.emplace_back("SAMPLES", std::to_string(samples_));
  if (isSprite(instances)) return cached("draw/instances/ball.vert", "draw/instances/ball.frag", defines);
  // A mesh may be open, so the inner sides of its triangles can be visible.
  if (instances.shape == sim::Instances::Shape::mesh) defines.emplace_back("DOUBLE_SIDED", "1");
  return cached("draw/screen/copy.vert", "draw/screen/copy.frag", defines);
}

const gl::Program& InstancesPass::shadowProgram(const sim::Instances& instances) {
  constexpr const char* vertices = "draw/instances/instance_shadow.vert";
  return isSprite(instances) ? cached(vertices, "draw/instances/disk_shadow.frag", {{"SPRITE", "1"}})
                             : cached(vertices, "draw/surface/shadow.frag", {});
}

const gl::Program& InstancesPass::lampShadowProgram(const sim::Instances& instances) {
  constexpr const char* vertices = "draw/lights/lamp_instance.vert";
  gl::Defines defines = lampDefines_;
  if (isSprite(instances)) defines.emplace_back("SPRITE", "1");
  return cached(vertices,
                isSprite(instances) ? "draw/instances/disk_shadow.frag" : "draw/surface/shadow.frag",
                defines);
}

InstancesPass::Entry& InstancesPass::entry(const sim::Instances& instances, std::size_t i) {
  if (entries_.size() <= i) entries_.resize(i + 1);
  Entry& entry = entries_[i];
  const auto levels = static_cast<int>(shape(instances).levels().size());
  const auto fits = [&](const std::unique_ptr<VisibleList>& list) {
    return list && list->capacity() == instances.capacity && list->levels() == levels;
  };
  if (!fits(entry.forCamera)) entry.forCamera = std::make_unique<VisibleList>(instances.capacity, levels);
  if (shadowed_ && castsShadow(instances) && !fits(entry.forLight))
    entry.forLight = std::make_unique<VisibleList>(instances.capacity, levels);
  if (!lampDefines_.empty() && castsShadow(instances) && !fits(entry.forLamps))
    entry.forLamps = std::make_unique<VisibleList>(instances.capacity, levels);
  entry.colors.update(instances);
  return entry;
}

InstanceFields InstancesPass::seenBy(Viewer viewer, const sim::Instances& instances) {
  return instanceFields(instances, shape(instances).radius(),
                        viewer == Viewer::camera ? minPixelsOf(instances) : 0.0F);
}

void InstancesPass::fill(const sim::Instances& instances, std::size_t i, Viewer viewer) {
  const Entry& own = entry(instances, i);
  const InstanceShape& form = shape(instances);
  const bool forLight = viewer != Viewer::camera;
  // Software drivers use coarser meshes, because triangles are expensive there. Shadows always use fine
  // meshes, because each texel of a small ball's shadow may be visible.
  const bool coarse = !forLight && gl::softwareDriver() && !isSprite(instances);
  // Up to this size (pixels) balls are drawn as squares whose area equals the area of the disc. The edge of
  // the square differs from the edge of the disc by 1/8 of the radius. Glows look the same if they are
  // drawn as points.
  const float maxGlow = GlowSums::takes(instances) ? maxSmallSum : maxPointGlow;
  const SightFields sight{.instance = seenBy(viewer, instances),
                          .pointPixels = instances.additive ? maxGlow
                                         : forLight         ? 4.0F
                                                            : 1.6F,
                          .levelError = coarse ? 0.5F : 0.2F};
  const auto& list = viewer == Viewer::camera ? own.forCamera
                     : viewer == Viewer::sun  ? own.forLight
                                              : own.forLamps;
  list->fill(culling_, viewer, sight, form);
}

void InstancesPass::cull(const sim::Drawables& drawables) {
  for (std::size_t i = 0; i < drawables.instances.size(); ++i)
    fill(drawables.instances[i], i, Viewer::camera);
}

void InstancesPass::cullForLight(const sim::Drawables& drawables) {
  for (std::size_t i = 0; i < drawables.instances.size(); ++i)
    if (castsShadow(drawables.instances[i])) fill(drawables.instances[i], i, Viewer::sun);
}

void InstancesPass::cullForLamps(const sim::Drawables& drawables) {
  for (std::size_t i = 0; i < drawables.instances.size(); ++i)
    if (castsShadow(drawables.instances[i])) fill(drawables.instances[i], i, Viewer::lamps);
}

void InstancesPass::drawLevel(const gl::Program& program, const sim::Instances& instances,
                              const VisibleList& list, std::size_t level) {
  const InstanceShape& form = shape(instances);
  program.set("vertexBits", form.vertexBits());
  program.set("turning", static_cast<int>(instances.turning));
  turnsOf(instances).bind(turnUnit);
  gl::give(program, list.fields(static_cast<int>(level)));
  program.set("batch", form.levels()[level].batch);
  program.set("swell", form.levels()[level].swell);
  if (form.vertices()) form.vertices().bind(shapeUnit);
  list.bind();
  vertices_.bind(form.indices());
  program.use();
  glDrawElementsIndirect(form.levels()[level].mode, GL_UNSIGNED_INT,
                         // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes an offset for a pointer.
                         reinterpret_cast<const void*>(level * VisibleList::argumentBytes));
}

void InstancesPass::drawSmall(const SmallSprites::Kind& kind, const SpriteFields& all,
                              const sim::Instances& instances, const VisibleList& list, glm::ivec2 target) {
  small_.prepare(kind, all, instances.capacity);
  const gl::Program& shader = small_.shader(kind.use);
  shader.set("targetSize", glm::vec2(target));
  drawLevel(shader, instances, list, 0);
}

void InstancesPass::castShadows(const sim::Drawables& drawables) {
  for (std::size_t i = 0; i < drawables.instances.size(); ++i) {
    const sim::Instances& instances = drawables.instances[i];
    if (!castsShadow(instances)) continue;
    DrawState{.depthTest = true,
              .cullBack = instances.shape == sim::Instances::Shape::sphere,
              .depthOffset = true}
        .set();
    const VisibleList& list = *entries_[i].forLight;
    const InstanceFields seen = seenBy(Viewer::sun, instances);
    if (isSprite(instances))
      drawSmall({.use = SmallSprites::Use::shadow}, {.instance = seen, .listed = list.fields(0)}, instances,
                list, shadowSize_);
    const gl::Program& shader = shadowProgram(instances);
    gl::give(shader, seen);
    for (std::size_t level = isSprite(instances) ? 1 : 0; level < shape(instances).levels().size(); ++level)
      drawLevel(shader, instances, list, level);
  }
}

void InstancesPass::castLampShadows(const sim::Drawables& drawables, int cells) {
  for (std::size_t i = 0; i < drawables.instances.size(); ++i) {
    const sim::Instances& instances = drawables.instances[i];
    if (!castsShadow(instances)) continue;
    const gl::Program& shader = lampShadowProgram(instances);
    gl::give(shader, seenBy(Viewer::lamps, instances));
    for (int cell = 0; cell < cells; ++cell) {
      shader.set("cell", cell);
      // For lamps, level 1 contains all sprites, however small.
      for (std::size_t level = isSprite(instances) ? 1 : 0; level < shape(instances).levels().size();
           ++level)
        drawLevel(shader, instances, *entries_[i].forLamps, level);
    }
  }
}

void InstancesPass::draw(const sim::Drawables& drawables, bool adding) {
  for (std::size_t i = 0; i < drawables.instances.size(); ++i) {
    const sim::Instances& instances = drawables.instances[i];
    if (instances.additive != adding || GlowSums::takes(instances)) continue;
    DrawState{.depthTest = true,
              .cullBack = instances.shape == sim::Instances::Shape::sphere,
              .depthOffset = false,
              .adding = adding}
        .set();
    const VisibleList& list = *entries_[i].forCamera;
    const SpriteFields all{.instance = seenBy(Viewer::camera, instances),
                           .look = entries_[i].colors.look(instances),
                           .material = materialFields(*instances.material),
                           .listed = list.fields(0)};
    if (isSprite(instances))
      drawSmall({.use = adding ? SmallSprites::Use::glow : SmallSprites::Use::ball,
                 .reflective = isReflective(*instances.material),
                 .translucent = instances.material->translucency > 0},
                all, instances, list, size_);
    const gl::Program& shader = program(instances);
    gl::give(shader, all);
    for (std::size_t s = 0; s < sampleOffsets_.size(); ++s)
      shader.set(("sampleOffsets[" + std::to_string(s) + "]").c_str(), sampleOffsets_[s]);
    for (std::size_t level = isSprite(instances) ? 1 : 0; level < shape(instances).levels().size(); ++level)
      drawLevel(shader, instances, list, level);
  }
}

void InstancesPass::sumUp(const sim::Drawables& drawables, const gl::Texture& depth, const GlowSums& sums) {
  for (std::size_t i = 0; i < drawables.instances.size(); ++i) {
    const sim::Instances& instances = drawables.instances[i];
    if (!GlowSums::takes(instances)) continue;
    for (int level = 0; level < 2; ++level)
      sums.add(level == 1,
               {.instance = seenBy(Viewer::camera, instances),
                .look = entries_[i].colors.look(instances),
                .listed = entries_[i].forCamera->fields(level),
                .roundPixels = maxPointGlow},
               depth, instances.capacity);
  }
}

}  // namespace simreel::draw
