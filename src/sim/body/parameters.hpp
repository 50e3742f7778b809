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

/// Motion that a scene adds to a bone.
struct KeyedBone {
  std::string bone;
  scene::Animated<glm::vec3> rotate = glm::vec3(0);  ///< rotation in degrees about the bone's local axes
  scene::Animated<glm::vec3> move = glm::vec3(0);    ///< translation in metres along the axes of the bone's
                                                     ///< parent
};

/// Parameters of the object kind "body".
struct BodyParameters : ObjectParameters, scene::Outlined {
  std::filesystem::path file;
  std::string animation;                               ///< name of the animation; empty if none exists
  double speed = 1;                                    ///< factor on the animation's speed
  double start = 0;                                    ///< time in seconds within the animation at scene
                                                       ///< time 0
  bool loop = true;                                    ///< true if the animation repeats
  std::vector<KeyedBone> bones;                        ///< motion of bones, applied after the animation
  scene::Animated<glm::vec3> position = glm::vec3(0);  ///< position in metres
  scene::Animated<glm::vec3> rotation = glm::vec3(0);  ///< rotation in degrees
  scene::Animated<float> scale = 1.0F;
  bool doubleSided = false;
  bool visible = true;
  bool collides = false;  ///< true if the body collides, by its capsules
  bool byFaces = false;   ///< true if the body's faces collide with cloths in contact
  float grip = 25.3F;     ///< decay rate (1/s) of the tangential velocity of objects that slide on the body
  std::optional<double> friction;
  void describe(scene::Fields& fields) override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  void ports(Ports& ports) const override;
  /// Returns the bounds of the skin over the whole animation and at all position keys.
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] std::vector<glm::vec3> outline() const override;

  /// Returns the content of the file, which is read once. Throws the errors of loadFigure().
  [[nodiscard]] const std::shared_ptr<const Figure>& figure() const;

 private:
  [[nodiscard]] std::vector<glm::vec3> placesOnTheWay() const;
  mutable std::shared_ptr<const Figure> figure_;
};

}  // namespace simreel::sim
