#include "draw/lights/lamps.hpp"

#include "draw/draw_state.hpp"
#include "gl/context.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace simreel::draw {

static_assert(sizeof(shader::Lamp) == shader::lampTexels * sizeof(glm::vec4));

Lamps::Lamps(const scene::Scene& scene, Rasterizer rasterizer)
    : scene_(scene), exact_(rasterizer == Rasterizer::exact), order_(scene) {
  if (!on()) return;
  const std::size_t count = order_.lights.size();
  float softest = 0;
  for (int i = 0; i < order_.shadowed; ++i)
    softest = std::max(softest, order_.lights[static_cast<std::size_t>(i)]->shadowSoftness);
  defines_ = {{"LAMPS", std::to_string(count)},
              {"SHADOWED_LAMPS", std::to_string(order_.shadowed)},
              {"RANGED_LAMPS", std::to_string(order_.ranged)},
              {"LAMP_TAPS", softest <= 2.0F ? "4" : "16"}};
  if (std::ranges::any_of(order_.lights,
                          [](const auto* light) { return light->type == scene::Light::Type::spot; }))
    defines_.emplace_back("SPOTS", "1");
  if (std::ranges::any_of(order_.lights,
                          [](const auto* light) { return light->type == scene::Light::Type::area; }))
    defines_.emplace_back("AREAS", "1");
  if (std::ranges::any_of(order_.lights, [](const auto* light) { return light->range > 0; }))
    defines_.emplace_back("RANGES", "1");
  shadowDefines_ = {{"LAMPS", std::to_string(order_.shadowed)}};
  if (gl::memoryPath() == gl::MemoryPath::storage)
    for (gl::Defines* defines : {&defines_, &shadowDefines_}) defines->emplace_back("LAMP_BLOCK", "1");
  lamps_ = gl::Buffer("lamps", count * sizeof(shader::Lamp));
  lampsView_ = gl::Texture::view("lamps", GL_RGBA32F, lamps_);

  glowPlaces_ = gl::Buffer("glows of lamps", count * sizeof(glm::vec4));
  glowAges_ = gl::Buffer("colours of lamps", count * sizeof(glm::vec4));
  glowPlacesView_ = gl::Texture::view("glows of lamps", GL_RGBA32F, glowPlaces_);
  glowAgesView_ = gl::Texture::view("colours of lamps", GL_RGBA32F, glowAges_);
  // A glow is an instance. Its mass holds the glow's radius, and its age selects the lamp's colour in the
  // colour map.
  glows_.positions = &glowPlacesView_;
  glows_.velocities = &glowAgesView_;
  glows_.capacity = static_cast<int>(count);
  glows_.size = 2.0F;
  glows_.massExponent = 1.0F;
  glows_.colorBy = sim::Instances::ColorBy::age;
  glows_.colors = &glowColors_;
  glows_.additive = true;
  // If no lamp ever glows, the pass for glows is skipped.
  glow_ = std::ranges::any_of(order_.lights, [](const scene::Light* light) {
    return light->type != scene::Light::Type::area &&
           std::ranges::any_of(light->glow.keys(), [](const auto& key) { return key.value > 0; });
  });
  // Glows are discs in world space. A circle in screen space would extend less far into the picture if its
  // centre were outside the picture.
  glows_.discs = true;
  glows_.material = &glowMaterial_;
}

void Lamps::update(double seconds, const sim::Drawables& drawables) {
  values_ = lampValues(order_, scene_.seed, seconds, drawables);
  if (exact_) setTexels(values_, order_);
  lamps_.write(0, std::as_bytes(std::span(values_)));
  lamps_.bindUniform(lampBinding, 0, lamps_.bytes());
  lampsView_.bind(lampUnit);
  if (order_.ranged > 0) {
    const std::vector<std::uint32_t> cells = lampCells(values_, order_.ranged);
    if (cells_.name() == 0) {
      cells_ = gl::Buffer("lamps of places", cells.size() * sizeof(std::uint32_t));
      cellsView_ = gl::Texture::view("lamps of places", GL_R32UI, cells_, sizeof(std::uint32_t));
    }
    cells_.write(0, std::as_bytes(std::span(cells)));
    cellsView_.bind(lampCellUnit);
  }
  updateGlows(seconds);
}

void Lamps::updateGlows(double seconds) {
  // A colour map needs at least two entries.
  glowColors_.assign(std::max<std::size_t>(values_.size(), 2), glm::vec3(0));
  std::vector<glm::vec4> places;
  std::vector<glm::vec4> ages;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const shader::Lamp& lamp = values_[i];
    // The mean of (1 - (r/R)^2)^2 over the disc is 1/3. `power` includes the factor 1 / pi.
    const bool isRectangle = order_.lights[i]->type == scene::Light::Type::area;
    const float glow = isRectangle ? 0.0F : order_.lights[i]->glow.at(seconds);
    glowColors_[i] = glm::vec3(lamp.power) * (3.0F * lamp.power.w * glow);
    places.emplace_back(glm::vec3(lamp.place), lamp.place.w);
    const float last = static_cast<float>(glowColors_.size() - 1);
    ages.emplace_back(0, 0, 0, glow > 0 ? static_cast<float>(i) / last : -1.0F);
  }
  glowPlaces_.write(0, std::as_bytes(std::span(places)));
  glowAges_.write(0, std::as_bytes(std::span(ages)));
}

sim::Drawables Lamps::withGlows(const sim::Drawables& drawables) const {
  sim::Drawables all = drawables;
  if (!glow_) return all;
  all.instances.push_back(glows_);
  return all;
}

}  // namespace simreel::draw
