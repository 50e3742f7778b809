#pragma once
#include "scene/inked.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/text/content.hpp"
#include "sim/text/letters/layout.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Placement of text on the screen instead of in the world.
struct ScreenText {
  scene::Animated<float> x = 0.04F;       ///< position of the anchor as a fraction of the image's width,
                                          ///< from the left
  scene::Animated<float> y = 0.06F;       ///< position of the anchor as a fraction of the image's height,
                                          ///< from the top
  scene::Animated<float> height = 0.03F;  ///< height of capitals as a fraction of the image's height
  scene::Animated<glm::vec3> color = glm::vec3(1);  ///< colour in linear RGB
  bool colored = false;                             ///< true if the scene gives the colour
  scene::Animated<float> opacity = 1.0F;
  scene::Animated<float> backdrop = 0.0F;  ///< opacity of the dark panel behind the text
  void describe(scene::Fields& fields);
};

/// Parameters of the object kind "text".
struct TextParameters : ObjectParameters, scene::Inked {
  enum class Weight { regular, bold };
  std::string text = "simreel";
  std::filesystem::path font;  ///< font file; empty: the bundled font
  Weight weight = Weight::bold;
  TextAnchor anchor;
  float spacing = 1.0F;                                ///< line spacing, as a factor on the font's own
  float height = 0.5F;                                 ///< height of capitals in metres
  float depth = 0.1F;                                  ///< thickness in metres
  scene::Animated<glm::vec3> position = glm::vec3(0);  ///< position in metres
  scene::Animated<glm::vec3> rotation = glm::vec3(0);  ///< rotation in degrees
  scene::Animated<float> scale = 1.0F;
  bool onScreen = false;
  ScreenText screen;  ///< replaces height, depth, placement and material

  void describe(scene::Fields& fields) override;
  [[nodiscard]] const char* drawnWith() const override {
    return onScreen ? "the \"color\" of its \"screen\"" : nullptr;
  }
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  /// Does nothing for text in the world, nor on a dark panel.
  void ink(const glm::vec3& color) override;
  void ports(Ports& ports) const override;

  [[nodiscard]] std::filesystem::path fontFile() const;
  /// Returns the transform from the text's own space to world space.
  [[nodiscard]] glm::mat4 model(double seconds) const;
};

}  // namespace simreel::sim
