#pragma once
#include "draw/overlay/chart_labels.hpp"
#include "draw/overlay/writing_pass.hpp"
#include "draw/screen/single_view.hpp"
#include "draw/screen/targets.hpp"
#include "scene/panels.hpp"

#include <memory>
#include <vector>

namespace simreel::draw {

/// Draws the panels of a scene side by side, and their captions.
class Panels {
 public:
  Panels(const scene::Scene& scene, glm::ivec2 size, int samples, const RendererOptions& options);
  void draw(double seconds, const sim::Drawables& drawables, const StageWatch& watch);
  void setPreviousFrame(const sim::Drawables& before);
  [[nodiscard]] bool needsPreviousFrame() const;
  [[nodiscard]] const Picture& picture() const { return picture_; }

 private:
  struct View {
    std::unique_ptr<scene::Scene> scene;  ///< the scene as the panel shows it
    const scene::Panel* panel = nullptr;
    bool charts = false;  ///< true if the panel shows only charts
    SingleView renderer;
  };
  void caption();

  scene::PanelGrid grid_;
  Picture picture_;
  std::vector<View> views_;
  LabelWords words_;
  TextPass writings_;
};

}  // namespace simreel::draw
