#include "draw/screen/panels.hpp"

#include "base/error.hpp"
#include "draw/screen/drawn_scene.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace simreel::draw {

namespace {

/// True if the panel shows only charts, and nothing of the world.
bool showsOnlyCharts(const scene::Panel& panel, const scene::Scene& scene) {
  return !panel.objects.empty() &&
         std::all_of(panel.objects.begin(), panel.objects.end(), [&](const auto& one) {
           return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const scene::Object& object) {
             return object.name == one.name && object.kind == "chart";
           });
         });
}

/// Returns the height in pixels of the capital letters of captions.
float captionCapital(glm::ivec2 cell) {
  return std::clamp(0.024F * static_cast<float>(std::min(cell.x, cell.y)), 7.0F, 40.0F);
}

/// Places charts one below the other, so that they fill the panel below its caption.
void fill(std::vector<sim::Chart>& charts, const scene::Panel& panel, glm::ivec2 cell) {
  const float capital = captionCapital(cell);
  const glm::vec2 margin = 1.2F * capital / glm::vec2(cell);
  const float top = panel.caption.empty() ? margin.y : 4.2F * capital / static_cast<float>(cell.y);
  const float row = (1 - top) / static_cast<float>(charts.size());
  for (std::size_t i = 0; i < charts.size(); ++i) {
    charts[i].corner = {margin.x, top + static_cast<float>(i) * row};
    charts[i].extent = {1 - 2 * margin.x, row - margin.y};
  }
}

/// Returns the drawables of the objects that a panel shows.
sim::Drawables shownOn(const scene::Panel& panel, const sim::Drawables& drawables) {
  sim::Drawables shown = drawables;
  if (panel.objects.empty()) return shown;
  const auto hides = [&](const std::string* object) {
    return object == nullptr || std::none_of(panel.objects.begin(), panel.objects.end(),
                                             [&](const auto& one) { return one.name == *object; });
  };
  std::erase_if(shown.surfaces, [&](const sim::Surface& one) { return hides(one.object); });
  std::erase_if(shown.instances, [&](const sim::Instances& one) { return hides(one.object); });
  std::erase_if(shown.charts, [&](const sim::Chart& one) { return hides(one.object); });
  std::erase_if(shown.writings, [&](const sim::Writing& one) { return hides(one.object); });
  // A field that is hidden may still be the texture of a surface.
  for (sim::Field& field : shown.fields)
    if (hides(field.name)) field.display = nullptr;
  return shown;
}

std::unique_ptr<scene::Scene> sceneOf(const scene::Panel& panel, const scene::Scene& scene,
                                      glm::ivec2 size) {
  std::unique_ptr<scene::Scene> shown = copyForDrawing(scene);
  shown->render.size = size;
  shown->render.overlay = panel.overlay.value_or(scene.render.overlay);
  // The background of overlays is dark and even.
  if (showsOnlyCharts(panel, scene)) shown->render.overlay = scene::Overlay::objects;
  shown->camera = scene::cameraOf(panel, scene.camera);
  return shown;
}

}  // namespace

Panels::Panels(const scene::Scene& scene, glm::ivec2 size, int samples, const RendererOptions& options)
    : grid_(scene::panelGrid(size, scene.panels.size())), picture_(size), writings_(size) {
  if (std::min(grid_.cell.x, grid_.cell.y) < 1)
    fail(ExitCode::usage, "{} panels need a larger picture than {}x{}", scene.panels.size(), size.x,
         size.y);
  views_.reserve(scene.panels.size());
  for (const scene::Panel& panel : scene.panels) {
    words_.require(panel.caption);
    std::unique_ptr<scene::Scene> shown = sceneOf(panel, scene, grid_.cell);
    SingleView renderer(*shown, grid_.cell, samples, options);
    views_.push_back({std::move(shown), &panel, showsOnlyCharts(panel, scene), std::move(renderer)});
  }
}

void Panels::draw(double seconds, const sim::Drawables& drawables, const StageWatch& watch) {
  constexpr std::array<GLubyte, 4> between = {24, 24, 26, 255};
  glClearTexImage(picture_.color.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, between.data());
  for (std::size_t i = 0; i < views_.size(); ++i) {
    View& view = views_[i];
    sim::Drawables shown = shownOn(*view.panel, drawables);
    if (view.charts) fill(shown.charts, *view.panel, grid_.cell);
    view.renderer.draw(seconds, shown, watch);
    const glm::ivec2 corner = grid_.corner(i);
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    glCopyImageSubData(view.renderer.picture().color.name(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       picture_.color.name(), GL_TEXTURE_2D, 0, corner.x, corner.y, 0, grid_.cell.x,
                       grid_.cell.y, 1);
  }
  caption();
  glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void Panels::caption() {
  const glm::vec2 size(picture_.color.width(), picture_.color.height());
  const float capital = captionCapital(grid_.cell);
  // Long captions are smaller, so that they end in their panel.
  const float space = static_cast<float>(grid_.cell.x) - 3.2F * capital;
  sim::Drawables captions;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const std::string& text = views_[i].panel->caption;
    if (text.empty()) continue;
    sim::Writing writing;
    const LabelWord& word = words_.of(text);
    writing.outlines = &word.outlines;
    writing.place = (glm::vec2(grid_.corner(i)) + glm::vec2(1.6F, 2.4F) * capital) / size;
    writing.height = std::min(capital, space / std::max(word.width, 1.0F)) / size.y;
    writing.color = glm::vec3(0.9F);
    writing.backdrop = 0.55F;
    captions.writings.push_back(writing);
  }
  writings_.draw(captions, picture_.color);
}

void Panels::setPreviousFrame(const sim::Drawables& before) {
  for (View& view : views_) view.renderer.setPreviousFrame(shownOn(*view.panel, before));
}

bool Panels::needsPreviousFrame() const {
  return std::any_of(views_.begin(), views_.end(),
                     [](const View& view) { return view.renderer.needsPreviousFrame(); });
}

}  // namespace simreel::draw
