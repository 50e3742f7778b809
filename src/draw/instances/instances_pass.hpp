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

/// Draws instances by indirect draws whose arguments a kernel fills. The commands of a frame do not depend
/// on the number of instances. Programs and shapes are made when first needed.
class InstancesPass {
 public:
  InstancesPass(const ShadowPass& shadow, const Lamps& lamps, const gl::Framebuffer& target,
                glm::ivec2 size, int samples);

  /// Grows the shadow's bounds.
  void growBounds(const sim::Drawables& drawables, const gl::Buffer& bounds) {
    bounds_.grow(drawables, shapes_, bounds);
  }
  /// Finds those in the light's box (its map is bound), then draws them into the bound shadow map.
  void cullForLight(const sim::Drawables& drawables);
  void castShadows(const sim::Drawables& drawables);
  /// The same for the shadow maps of lamps, each `cells` of them.
  void cullForLamps(const sim::Drawables& drawables);
  void castLampShadows(const sim::Drawables& drawables, int cells);
  /// Finds those in the camera's sight.
  void cull(const sim::Drawables& drawables);
  /// Into the bound framebuffer. Opaque ones, then (after everything opaque) those that add light.
  void drawOpaque(const sim::Drawables& drawables) { draw(drawables, false); }
  void drawAdditive(const sim::Drawables& drawables) { draw(drawables, true); }
  /// Adds the light of those that GlowSums takes, before what `depth` holds.
  void sumUp(const sim::Drawables& drawables, const gl::Texture& depth, const GlowSums& sums);

  /// Of drawables.instances[i], for tests.
  [[nodiscard]] const VisibleList& visible(std::size_t i) const { return *entries_.at(i).forCamera; }
  [[nodiscard]] const VisibleList& visibleToSun(std::size_t i) const { return *entries_.at(i).forLight; }

 private:
  /// What belongs to drawables.instances[i].
  struct Entry {
    std::unique_ptr<VisibleList> forCamera, forLight, forLamps;
    InstanceColors colors;
  };

  Entry& entry(const sim::Instances& instances, std::size_t i);
  const InstanceShape& shape(const sim::Instances& instances) { return shapes_.of(instances); }
  /// For all levels of detail but the small ones of sprites.
  const gl::Program& program(const sim::Instances& instances);
  const gl::Program& shadowProgram(const sim::Instances& instances);
  const gl::Program& lampShadowProgram(const sim::Instances& instances);
  const gl::Program& cached(const char* vertexPath, const char* fragmentPath, const gl::Defines& defines);
  void fill(const sim::Instances& instances, std::size_t i, Viewer viewer);
  InstanceFields seenBy(Viewer viewer, const sim::Instances& instances);
  void draw(const sim::Drawables& drawables, bool additive);
  /// Draws the sprites of few pixels, level 0.
  void drawSmall(const SmallSprites::Kind& kind, const SpriteFields& all, const sim::Instances& instances,
                 const VisibleList& list, glm::ivec2 target);
  void drawLevel(const gl::Program& program, const sim::Instances& instances, const VisibleList& list,
                 std::size_t level);

  gl::Defines lightDefines_;  ///< of shading: sun and lamps
  gl::Defines lampDefines_;   ///< of the lamps' shadow maps; empty: there are none
  bool shadowed_;
  glm::ivec2 shadowSize_, size_;  ///< of the targets, pixels
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
