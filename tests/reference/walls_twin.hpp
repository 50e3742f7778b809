#pragma once
#include "sim/contour/wall_plan.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// CPU twin of a solid for collisions. It contains the solid's field, and the classes of the field's
/// samples, which are computed independently.
class WallsTwin {
 public:
  /// `value`: function that returns the value of the field's cell (x, y).
  WallsTwin(const simreel::sim::SolidShape& shape, std::function<float(int x, int y)> value,
            const glm::vec3& position, float grip)
      : shape_(shape), value_(std::move(value)), position_(position), grip_(grip), heights_(shape.heights) {
    cut();
  }

  /// Recomputes the classes. Must be called after the field's values or the heights have changed.
  void cut() {
    classes_.clear();
    for (int y = -1; y <= shape_.size.y; ++y)
      for (int x = -1; x <= shape_.size.x; ++x) {
        int reached = 0;
        for (const float level : shape_.levels) reached += valueAt(x, y) >= level ? 1 : 0;
        const bool inside = x >= 0 && y >= 0 && x < shape_.size.x && y < shape_.size.y;
        classes_.push_back(inside ? reached : shape_.outside);
      }
  }
  void setHeights(const std::vector<float>& heights) { heights_ = heights; }

  /// Returns the class of a sample, which is the number of levels that the sample's value reaches. The
  /// field's cells begin at sample (1, 1).
  [[nodiscard]] int classAt(int x, int y) const {
    return classes_[static_cast<std::size_t>(y * (shape_.size.x + 2) + x)];
  }
  /// Returns the value of a cell. Outside the field, returns the value of the nearest cell.
  [[nodiscard]] float valueAt(int x, int y) const {
    const float value = value_(std::clamp(x, 0, shape_.size.x - 1), std::clamp(y, 0, shape_.size.y - 1));
    return std::isfinite(value) ? std::clamp(value, -1e20F, 1e20F) : -1e20F;
  }
  [[nodiscard]] simreel::shader::WallGrid grid(const simreel::sim::WallContact& contact) const {
    return simreel::sim::wallGrid(shape_, heights_, position_, grip_, contact);
  }

 private:
  simreel::sim::SolidShape shape_;
  std::function<float(int, int)> value_;
  glm::vec3 position_;
  float grip_;
  std::vector<float> heights_;
  std::vector<int> classes_;
};
