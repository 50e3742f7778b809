#pragma once
#include "scene/inked.hpp"
#include "scene/set_apart.hpp"
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

/// Settings for text that is drawn over the picture instead of in the world.
struct ScreenText {
  scene::Animated<float> x = 0.04F;       ///< position of the anchor from the left, as a fraction of the
                                          ///< picture's width
  scene::Animated<float> y = 0.06F;       ///< position of the anchor from the top, as a fraction of the
                                          ///< picture's height
  scene::Animated<float> height = 0.03F;  ///< cap height as a fraction of the picture's height
  scene::Animated<glm::vec3> color = glm::vec3(1);  ///< colour in linear RGB
  bool colored = false;                             ///< true if the scene gives the colour
  scene::Animated<float> opacity = 1.0F;
  scene::Animated<float> backdrop = 0.0F;  ///< opacity of the dark panel behind the text
  void describe(scene::Fields& fields);
};

/// Parameters of the object kind "text".
struct TextParameters : ObjectParameters, scene::HasInk, scene::SetApart {
  enum class Weight { regular, bold };
  std::string text = "simreel";
  std::filesystem::path font;  ///< font file; if empty, the bundled font
  Weight weight = Weight::bold;
  TextAnchor anchor;
  float spacing = 1.0F;                                ///< factor on the line height of the font
  float height = 0.5F;                                 ///< cap height in metres
  float depth = 0.1F;                                  ///< thickness in metres
  scene::Animated<glm::vec3> position = glm::vec3(0);  ///< position in metres
  scene::Animated<glm::vec3> rotation = glm::vec3(0);  ///< rotation in degrees
  scene::Animated<float> scale = 1.0F;
  bool placed = false;  ///< true if the scene gives the position
  bool onScreen = false;
  ScreenText screen;  ///< for text over the picture; replaces height, depth, placement and material

  void describe(scene::Fields& fields) override;
  [[nodiscard]] const char* drawnWith() const override {
    return onScreen ? "the \"color\" of its \"screen\"" : nullptr;
  }
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  /// Sets the colour of the text. Does nothing for text in the world or on a dark panel.
  void ink(const glm::vec3& color) override;
  void standAbove(const scene::Box& others) override;
  void ports(Ports& ports) const override;

  [[nodiscard]] std::filesystem::path fontFile() const;
  /// Returns the transform from the text's local space to world space.
  [[nodiscard]] glm::mat4 model(double seconds) const;
};

}  // namespace simreel::sim
