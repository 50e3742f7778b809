#pragma once
#include "draw/overlay/field_pass.hpp"
#include "gpu/draw/field_stage.hpp"
#include "reference/overlay_twin.hpp"

#include <algorithm>
#include <cstring>
#include <random>

#include <doctest/doctest.h>

/// Returns a picture of random bytes, with random opacities unless `opaque` is set. The driver's blending
/// equals the kernels' blending only for opaque pictures, because only the kernels support straight alpha.
inline OverlayPicture<OverlayBytes> someBytes(glm::ivec2 size, bool opaque = false) {
  OverlayPicture<OverlayBytes> picture{size, {}};
  std::minstd_rand random(7);
  for (int i = 0; i < size.x * size.y; ++i) {
    OverlayBytes bytes{};
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random() >> 8U);
    if (opaque) bytes[3] = 255;
    picture.pixels.push_back(bytes);
  }
  return picture;
}
inline OverlayPicture<glm::vec4> someLight(glm::ivec2 size) {
  OverlayPicture<glm::vec4> light{size, {}};
  std::minstd_rand random(9);
  const auto next = [&] { return static_cast<float>(random() % 1000U) / 500.0F; };
  for (int i = 0; i < size.x * size.y; ++i) {
    const float cover = static_cast<float>(random() % 5U) / 4.0F;
    light.pixels.push_back(glm::vec4(glm::vec3(next(), next(), next()) * cover, cover));
  }
  return light;
}

inline simreel::gl::Texture imageOf(const OverlayPicture<OverlayBytes>& picture) {
  auto image = simreel::gl::Texture::image("bytes", GL_RGBA8, picture.size.x, picture.size.y);
  glTextureSubImage2D(image.name(), 0, 0, 0, picture.size.x, picture.size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                      picture.pixels.data());
  return image;
}
inline simreel::gl::Texture imageOf(const OverlayPicture<glm::vec4>& light) {
  auto image = simreel::gl::Texture::image("light", GL_RGBA32F, light.size.x, light.size.y);
  glTextureSubImage2D(image.name(), 0, 0, 0, light.size.x, light.size.y, GL_RGBA, GL_FLOAT,
                      light.pixels.data());
  return image;
}
template <class T>
OverlayPicture<T> readBack(const simreel::gl::Texture& image) {
  OverlayPicture<T> picture{{image.width(), image.height()}, {}};
  picture.pixels.resize(static_cast<std::size_t>(image.width() * image.height()));
  glGetTextureImage(image.name(), 0, GL_RGBA, sizeof(T) == 4 ? GL_UNSIGNED_BYTE : GL_FLOAT,
                    static_cast<GLsizei>(picture.pixels.size() * sizeof(T)), picture.pixels.data());
  testContext().check();
  return picture;
}

/// Returns the number of pixels with different bits.
template <class T>
int differing(const OverlayPicture<T>& a, const OverlayPicture<T>& b) {
  REQUIRE(a.pixels.size() == b.pixels.size());
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    count += std::memcmp(&a.pixels[i], &b.pixels[i], sizeof(T)) != 0 ? 1 : 0;
  return count;
}

/// Max and mean difference of two pictures, in steps of 1/255.
struct Distance {
  int max = 0;
  double mean = 0;
};
inline Distance distance(const OverlayPicture<OverlayBytes>& a, const OverlayPicture<OverlayBytes>& b) {
  Distance distance;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const int pixelDifference = std::abs(a.pixels[i][k] - b.pixels[i][k]);
      distance.max = std::max(distance.max, pixelDifference);
      distance.mean += pixelDifference / (4.0 * static_cast<double>(a.pixels.size()));
    }
  return distance;
}

/// Runs the CPU version for the field of a stage on a picture. If the pass first averages blocks of cells,
/// so does the CPU version.
struct FieldOnPicture {
  FieldInputs inputs;
  glm::ivec4 part{0};
  glm::ivec2 texels{0};  ///< size of the averaged field; zero if cells are not averaged

  FieldOnPicture(const FieldStage& stage, glm::ivec2 picture) {
    const simreel::sim::Field& field = stage.field;
    const simreel::sim::FieldDisplay& display = stage.display;
    inputs.words = stage.buffer.readAll<glm::uvec4>();
    for (const glm::vec3& color : stage.colors) inputs.stops.emplace_back(color, 1.0F);
    inputs.cells = field.size;
    inputs.rowWords = field.rowWords;
    inputs.firstWord = field.firstWord;
    inputs.cellWords = field.cellWords;
    inputs.stopCount = static_cast<int>(stage.colors.size());
    inputs.rangeLow = field.range.x;
    inputs.rangeFactor = simreel::draw::rangeFactor(field.range);
    inputs.cellKind = static_cast<int>(field.cells);
    inputs.categories = field.categories;
    const bool ownColors = field.cells == simreel::sim::Field::Cells::colors;
    inputs.colored = field.categories || !display.smooth || ownColors;
    inputs.splined = display.smooth && !field.categories;
    inputs.tiled = display.tiled;
    inputs.relief = display.relief != 0 && !field.categories;
    inputs.encodes = display.layer == simreel::sim::FieldDisplay::Layer::over;
    inputs.border = display.border;
    inputs.opacity = display.opacity.at(0);
    const auto view = simreel::draw::fieldView(display, field.size, picture, 0);
    const int reduction = simreel::draw::FieldPass::reductionFor(field.size, view.perPixel);
    inputs.reduces = reduction > 1;
    if (inputs.reduces) texels = (field.size + reduction - 1) / reduction;
    const auto place = simreel::draw::fieldPlace(field, view, inputs.reduces ? texels : field.size);
    inputs.size = place.size;
    inputs.base = place.base;
    inputs.start = place.start;
    inputs.perPixel = place.perPixel;
    inputs.slope = place.slope;
    part = glm::ivec4(view.part);
  }
  [[nodiscard]] FieldTwin twin() const {
    FieldTwin twin(inputs);
    if (inputs.reduces) twin.setReduced(twin.averaged(texels));
    return twin;
  }
};
