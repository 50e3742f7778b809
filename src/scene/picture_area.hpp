#pragma once
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::scene {

/// Rectangle of the picture, as fractions of its width and height from the top left.
struct PictureArea {
  glm::vec2 from{0}, to{0};
};

/// Interface of the parameters of objects that cover an area of the picture, such as a chart.
class TakesArea {
 public:
  virtual ~TakesArea() = default;
  [[nodiscard]] virtual PictureArea area() const = 0;
};

/// Interface of the parameters of objects over the picture that move if their default place is taken.
class MovesAside {
 public:
  virtual ~MovesAside() = default;
  /// Moves the object out of the areas. An object that the scene places does not move.
  virtual void moveAside(const std::vector<PictureArea>& taken) = 0;
};

struct Scene;

/// Moves objects over the picture that the scene does not place out of the areas of charts.
void moveAside(Scene& scene);

}  // namespace simreel::scene
