#pragma once
#include "scene/outline.hpp"
#include "sim/body/figure.hpp"
#include "sim/core/kind.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// What a scene adds to the motion of a bone.
struct KeyedBone {
  std::string bone;
  scene::Animated<glm::vec3> rotate = glm::vec3(0);  ///< degrees, in the bone's own axes
  scene::Animated<glm::vec3> move = glm::vec3(0);    ///< m, in its parent's
};

/// Parameters of the kind body.
struct BodyParameters : ObjectParameters, scene::Outlined {
  std::filesystem::path file;
  std::string animation;                               ///< empty: none
  double speed = 1;                                    ///< of the motion
  double start = 0;                                    ///< s into the motion at time 0
  bool loop = true;                                    ///< whether it begins anew
  std::vector<KeyedBone> bones;                        ///< on top of the motion
  scene::Animated<glm::vec3> position = glm::vec3(0);  ///< m
  scene::Animated<glm::vec3> rotation = glm::vec3(0);  ///< degrees
  scene::Animated<float> scale = 1.0F;
  bool doubleSided = false;
  bool visible = true;
  bool collides = false;  ///< by capsules
  bool byFaces = false;   ///< with cloths in contact
  float grip = 25.3F;     ///< 1/s
  std::optional<double> friction;
  void describe(scene::Fields& fields) override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  void ports(Ports& ports) const override;
  /// Its skin along the motion, and at each key of its position.
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] std::vector<glm::vec3> outline() const override;

  /// What the file holds, read once. Throws what loadFigure() throws.
  [[nodiscard]] const std::shared_ptr<const Figure>& figure() const;

 private:
  [[nodiscard]] std::vector<glm::vec3> placesOnTheWay() const;
  mutable std::shared_ptr<const Figure> figure_;
};

}  // namespace simreel::sim
