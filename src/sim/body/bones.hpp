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

/// The bodies of a scene as others know them without a device: where their bones are, and the capsules
/// around those. Files are read when somebody asks.
class Bones {
 public:
  static const PortInfo port;

  explicit Bones(const scene::Scene& scene);

  /// The bone of a body, from its own space to the world; may outlive this. Throws UserError(usage) for a
  /// body or a bone that is not there, and what the reader of its file throws.
  [[nodiscard]] Carrier named(const std::string& body, const std::string& bone) const;
  /// As HeldBySkin.
  [[nodiscard]] SkinHolder heldBySkin(const std::string& body, std::span<const glm::dvec3> points,
                                      double time) const;
  /// Appends the capsules of the bodies that collide. Throws what BodyMotion throws.
  void addCapsules(std::vector<ColliderShape>& shapes) const;

 private:
  [[nodiscard]] std::shared_ptr<const BodyMotion> motionOf(const std::string& body) const;

  std::map<std::string, const BodyParameters*> bodies_;
  mutable std::map<std::string, std::shared_ptr<const BodyMotion>> motions_;
};

/// Bones::named of the scene around a simulation, as plans take it.
[[nodiscard]] std::function<Carrier(const std::string& body, const std::string& bone)> boneNamedIn(
    const Setting& setting);
/// Bones::heldBySkin of that scene.
[[nodiscard]] HeldBySkin heldBySkinIn(const Setting& setting);

}  // namespace simreel::sim
