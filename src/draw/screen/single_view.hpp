#pragma once
#include "draw/exact/passes.hpp"
#include "draw/exact/scene/picture_layers.hpp"
#include "draw/screen/targets.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <functional>
#include <memory>
#include <optional>

#include <glm/vec2.hpp>

namespace simreel::draw {

struct RendererOptions {
  std::optional<scene::Rasterizer> rasterizer;  ///< if set, replaces the scene's choice of rasterizer
  /// Max bytes of the exact rasterizer's visibility buffer. Pictures that need more are drawn in bands of
  /// rows, with the same result.
  std::size_t visibilityBytes = std::size_t{256} << 20;
};

/// Callback after the commands of a stage have been issued. Stages without work are omitted; a stage may
/// be reported several times. Names of the exact rasterizer: the stages in draw/exact/pass_list.hpp and
/// "fields". Names of the driver's rasterizer: "shadow", "surfaces", "instances", "ground", "bloom",
/// "tone map", "fields".
using StageWatch = std::function<void(const char* stage)>;

/// Draws frames of a scene through its camera; the members are those of Renderer. Ignores the scene's
/// panels.
class SingleView {
 public:
  SingleView(const scene::Scene& scene, glm::ivec2 size, int samples, const RendererOptions& options);
  ~SingleView();
  SingleView(SingleView&&) noexcept;
  SingleView& operator=(SingleView&&) = delete;
  SingleView(const SingleView&) = delete;
  SingleView& operator=(const SingleView&) = delete;

  void draw(double seconds, const sim::Drawables& drawables, const StageWatch& watch);
  void setPreviousFrame(const sim::Drawables& before);
  [[nodiscard]] bool needsPreviousFrame() const;
  void keepPasses(PassPicture* passes);
  void keepLayers(const LightRequest& wanted);
  [[nodiscard]] PictureLayers takeLayers();
  [[nodiscard]] const Picture& picture() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::draw
