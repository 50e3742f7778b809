#pragma once
#include "sim/body/motion.hpp"
#include "sim/core/collider.hpp"
#include "sim/core/port.hpp"
#include "sim/core/simulation.hpp"

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace simreel::sim {

/// CPU access to a scene's bodies for other objects: the transforms of their bones, and capsules around the
/// bones. Reads each body's file on first use.
class Bones {
 public:
  static const PortInfo port;

  explicit Bones(const scene::Scene& scene);

  /// Returns a function that gives a bone's transform from bone space to world space at a time. The
  /// function may outlive this object. Throws UserError(usage) for an unknown body or bone, and the errors
  /// of the body's file reader.
  [[nodiscard]] Carrier named(const std::string& body, const std::string& bone) const;
  /// Attaches points to a body's skin; see HeldBySkin.
  [[nodiscard]] SkinHolder heldBySkin(const std::string& body, std::span<const glm::dvec3> points,
                                      double time) const;
  /// Appends the capsules of all bodies that collide. Throws the errors of BodyMotion.
  void addCapsules(std::vector<ColliderShape>& shapes) const;

 private:
  [[nodiscard]] std::shared_ptr<const BodyMotion> motionOf(const std::string& body) const;

  std::map<std::string, const BodyParameters*> bodies_;
  mutable std::map<std::string, std::shared_ptr<const BodyMotion>> motions_;
};

/// Returns a function that calls Bones::named() for the setting's scene.
[[nodiscard]] std::function<Carrier(const std::string& body, const std::string& bone)> boneNamedIn(
    const Setting& setting);
/// Returns a function that calls Bones::heldBySkin() for the setting's scene.
[[nodiscard]] HeldBySkin heldBySkinIn(const Setting& setting);

}  // namespace simreel::sim
