#include "draw/screen/renderer.hpp"

#include "base/error.hpp"
#include "draw/screen/panels.hpp"

#include <optional>

namespace simreel::draw {

struct Renderer::State {
  std::optional<SingleView> view;  ///< empty if the scene has panels
  std::optional<Panels> panels;    ///< empty if the scene has none
  PassPicture* passes = nullptr;   ///< receives the finished picture of panels; may be null
};

Renderer::Renderer(const scene::Scene& scene, glm::ivec2 size, int samples, const RendererOptions& options)
    : state_(std::make_unique<State>()) {
  if (scene.panels.empty())
    state_->view.emplace(scene, size, samples, options);
  else
    state_->panels.emplace(scene, size, samples, options);
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::draw(double seconds, const sim::Drawables& drawables, const StageWatch& watch) {
  if (!state_->panels) return state_->view->draw(seconds, drawables, watch);
  state_->panels->draw(seconds, drawables, watch);
  if (state_->passes == nullptr) return;
  *state_->passes = {};
  state_->passes->keepBytes("picture", "finished", state_->panels->picture().color);
}

void Renderer::setPreviousFrame(const sim::Drawables& before) {
  state_->panels ? state_->panels->setPreviousFrame(before) : state_->view->setPreviousFrame(before);
}

bool Renderer::needsPreviousFrame() const {
  return state_->panels ? state_->panels->needsPreviousFrame() : state_->view->needsPreviousFrame();
}

void Renderer::keepPasses(PassPicture* passes) {
  state_->passes = passes;
  if (state_->view) state_->view->keepPasses(passes);
}

void Renderer::keepLayers(const LightRequest& wanted) {
  if (state_->panels)
    fail(ExitCode::usage,
         "layers, OpenEXR and 16 bits show a single view, and this scene has \"panels\"; leave them out "
         "with "
         "-D panels=null");
  state_->view->keepLayers(wanted);
}

PictureLayers Renderer::takeLayers() {
  SIMREEL_CHECK(state_->view.has_value());
  return state_->view->takeLayers();
}

const gl::Framebuffer& Renderer::target() const {
  return (state_->panels ? state_->panels->picture() : state_->view->picture()).framebuffer;
}

}  // namespace simreel::draw
