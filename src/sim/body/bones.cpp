#include "sim/body/bones.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "scene/json/words.hpp"
#include "scene/scene.hpp"
#include "sim/body/capsules.hpp"
#include "sim/body/skin_points.hpp"

#include <utility>

namespace simreel::sim {

namespace {

Carrier carrierOf(std::shared_ptr<const BodyMotion> motion, int node) {
  return [motion = std::move(motion), node](double time) { return motion->nodeAt(node, time); };
}

}  // namespace

constinit const PortInfo Bones::port = {
    .name = "bones", .lacks = ", which has no bones", .none = "the scene has no body"};

Bones::Bones(const scene::Scene& scene) {
  for (const scene::Object& object : scene.objects)
    if (const auto* body = dynamic_cast<const BodyParameters*>(object.parameters.get()))
      bodies_[object.name] = body;
}

std::shared_ptr<const BodyMotion> Bones::motionOf(const std::string& body) const {
  std::shared_ptr<const BodyMotion>& motion = motions_[body];
  if (!motion) motion = std::make_shared<const BodyMotion>(body, *bodies_.at(body));
  return motion;
}

SkinHolder Bones::heldBySkin(const std::string& body, std::span<const glm::dvec3> points,
                             double time) const {
  if (!bodies_.contains(body)) fail(ExitCode::usage, "no object named {} is a body", scene::inQuotes(body));
  return [held = SkinPoints(body, motionOf(body), points, time)](double now) { return held.at(now); };
}

Carrier Bones::named(const std::string& body, const std::string& bone) const {
  if (!bodies_.contains(body)) fail(ExitCode::usage, "no object named {} is a body", scene::inQuotes(body));
  const auto motion = motionOf(body);
  return carrierOf(motion, motion->boneNamed(bone));
}

void Bones::addCapsules(std::vector<ColliderShape>& shapes) const {
  for (const auto& [name, body] : bodies_) {
    if (!body->collides) continue;
    const auto motion = motionOf(name);
    for (const BoneCapsule& capsule : fitCapsules(motion->figure())) {
      ColliderShape shape;
      shape.kind = ColliderShape::Kind::capsule;
      shape.carrier = carrierOf(motion, capsule.node);
      for (std::size_t end = 0; end < 2; ++end) shape.ends[end] = glm::vec3(capsule.ends[end]);
      shape.radius = static_cast<float>(capsule.radius);
      shape.grip = body->grip;
      shape.friction = body->friction;
      shapes.push_back(shape);
      detail("body \"{}\": around bone \"{}\" a capsule of {:.3f} m, {:.3f} m long", name,
             motion->figure().nodes[static_cast<std::size_t>(capsule.node)].name, shape.radius,
             glm::length(capsule.ends[1] - capsule.ends[0]));
    }
  }
}

std::function<Carrier(const std::string& body, const std::string& bone)> boneNamedIn(
    const Setting& setting) {
  return [bones = setting.find<Bones>()](const std::string& body, const std::string& bone) {
    return bones->named(body, bone);
  };
}

HeldBySkin heldBySkinIn(const Setting& setting) {
  return [bones = setting.find<Bones>()](const std::string& body, std::span<const glm::dvec3> points,
                                         double time) { return bones->heldBySkin(body, points, time); };
}

}  // namespace simreel::sim
