#pragma once
#include "draw/draw_state.hpp"
#include "draw/instances/glow_sums.hpp"
#include "draw/instances/instance_shape.hpp"
#include "draw/instances/instance_values.hpp"
#include "draw/instances/small_sprites.hpp"
#include "draw/instances/visible_list.hpp"
#include "draw/lights/lamps.hpp"
#include "draw/surface/shadow_pass.hpp"
#include "gl/program.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace simreel::draw {

/// Draws instances with indirect draws whose arguments kernels compute. The number of commands per frame is
/// independent of the number of instances. Programs and shapes are created on first use.
class InstancesPass {
 public:
  InstancesPass(const ShadowPass& shadow, const Lamps& lamps, const gl::Framebuffer& target,
                glm::ivec2 size, int samples);

  /// Extends the bounds of the sun's shadow map by the instances.
  void growBounds(const sim::Drawables& drawables, const gl::Buffer& bounds) {
    bounds_.grow(drawables, shapes_, bounds);
  }
  /// cullForLight() lists the instances in the box of the sun's shadow map, whose transform must be bound.
  /// castShadows() draws them into the bound shadow map.
  void cullForLight(const sim::Drawables& drawables);
  void castShadows(const sim::Drawables& drawables);
  /// These functions do the same for the lamps' shadow maps. `cells`: number of shadow maps.
  void cullForLamps(const sim::Drawables& drawables);
  void castLampShadows(const sim::Drawables& drawables, int cells);
  /// Lists the instances that the camera may show.
  void cull(const sim::Drawables& drawables);
  /// These functions draw into the bound framebuffer. Draw opaque instances first, and additive ones after
  /// all opaque objects.
  void drawOpaque(const sim::Drawables& drawables) { draw(drawables, false); }
  void drawAdditive(const sim::Drawables& drawables) { draw(drawables, true); }
  /// Adds the light of the instances that GlowSums handles to its sums, as far as they are in front of
  /// `depth`.
  void sumUp(const sim::Drawables& drawables, const gl::Texture& depth, const GlowSums& sums);

  /// These functions return the lists of visible instances of drawables.instances[i], for tests.
  [[nodiscard]] const VisibleList& visible(std::size_t i) const { return *entries_.at(i).forCamera; }
  [[nodiscard]] const VisibleList& visibleToSun(std::size_t i) const { return *entries_.at(i).forLight; }

 private:
  /// Cached data of drawables.instances[i].
  struct Entry {
    std::unique_ptr<VisibleList> forCamera, forLight, forLamps;
    InstanceColors colors;
  };

  Entry& entry(const sim::Instances& instances, std::size_t i);
  const InstanceShape& shape(const sim::Instances& instances) { return shapes_.of(instances); }
  /// These functions return programs for all levels of detail except the smallest sprites.
  const gl::Program& program(const sim::Instances& instances);
  const gl::Program& shadowProgram(const sim::Instances& instances);
  const gl::Program& lampShadowProgram(const sim::Instances& instances);
  const gl::Program& cached(const char* vertexPath, const char* fragmentPath, const gl::Defines& defines);
  void fill(const sim::Instances& instances, std::size_t i, Viewer viewer);
  InstanceFields seenBy(Viewer viewer, const sim::Instances& instances);
  void draw(const sim::Drawables& drawables, bool additive);
  /// Draws the sprites of level 0, which cover a few pixels.
  void drawSmall(const SmallSprites::Kind& kind, const SpriteFields& all, const sim::Instances& instances,
                 const VisibleList& list, glm::ivec2 target);
  void drawLevel(const gl::Program& program, const sim::Instances& instances, const VisibleList& list,
                 std::size_t level);

  gl::Defines lightDefines_;  ///< defines for shading with sun and lamps
  gl::Defines lampDefines_;   ///< defines of the lamps' shadow maps; empty if no lamp casts shadows
  bool shadowed_;
  glm::ivec2 shadowSize_, size_;  ///< sizes (pixels) of the sun's shadow map and of the picture
  int samples_;
  std::vector<glm::vec2> sampleOffsets_;
  std::vector<Entry> entries_;
  InstanceShapes shapes_{SmallSprites::points()};
  CullKernels culling_;
  std::map<std::string, gl::Program> programs_;
  InstanceBounds bounds_;
  SmallSprites small_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
