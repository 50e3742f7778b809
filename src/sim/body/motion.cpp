#include "sim/body/motion.hpp"

#include "sim/core/collider.hpp"
#include "sim/nodes/sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

double inSteps(double time) {
  constexpr double perSecond = 16'777'216;
  return std::floor(time * perSecond + 0.5) / perSecond;
}

}  // namespace

BodyMotion::BodyMotion(const std::string& name, const BodyParameters& parameters)
    : name_(fmt::format("body \"{}\"", name)), parameters_(parameters), figure_(parameters.figure()) {
  if (!parameters.animation.empty()) animation_ = &figure_->animationNamed(parameters.animation, name_);
  for (const KeyedBone& keyed : parameters.bones) keyed_.push_back(boneNamed(keyed.bone));
  for (Pose& pose : poses_) pose.time = std::numeric_limits<double>::quiet_NaN();
}

int BodyMotion::boneNamed(const std::string& bone) const {
  return figure_->nodeNamed(bone, name_);
}

double BodyMotion::motionTime(double time) const {
  const double at = parameters_.start + parameters_.speed * time;
  const double length = animation_->seconds;
  if (!parameters_.loop || !(length > 0)) return std::clamp(at, 0.0, length);
  return at - std::floor(at / length) * length;
}

std::vector<glm::dmat4> BodyMotion::pose(double time) const {
  std::vector<FigureNode> nodes = figure_->nodes;
  if (animation_ != nullptr) {
    const double at = motionTime(time);
    for (const FigureChannel& channel : animation_->channels)
      move(nodes[static_cast<std::size_t>(channel.node)], channel, at);
  }
  std::vector<glm::dmat4> matrices;
  matrices.reserve(nodes.size());
  for (const FigureNode& node : nodes)
    matrices.push_back(node.hasMatrix ? node.matrix
                                      : transformOf(node.translation, node.rotation, node.scale));
  for (std::size_t i = 0; i < keyed_.size(); ++i) {
    glm::dmat4& matrix = matrices[static_cast<std::size_t>(keyed_[i])];
    matrix = matrix * glm::dmat4(rotationMatrix(parameters_.bones[i].rotate.at(time)));
    matrix[3] += glm::dvec4(glm::dvec3(parameters_.bones[i].move.at(time)), 0);
  }
  glm::dmat4 placed(rotationMatrix(parameters_.rotation.at(time)));
  for (int i = 0; i < 3; ++i) placed[i] *= double{parameters_.scale.at(time)};
  placed[3] = glm::dvec4(glm::dvec3(parameters_.position.at(time)), 1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int parent = nodes[i].parent;
    matrices[i] = (parent < 0 ? placed : matrices[static_cast<std::size_t>(parent)]) * matrices[i];
  }
  return matrices;
}

const std::vector<glm::dmat4>& BodyMotion::poseAt(double time) const {
  const double at = inSteps(time);
  for (const Pose& known : poses_)
    if (known.time == at) return known.nodes;
  newest_ = 1 - newest_;
  poses_[newest_] = {at, pose(at)};
  return poses_[newest_].nodes;
}

std::vector<glm::vec4> BodyMotion::rowsAt(double time) const {
  const std::vector<glm::dmat4>& nodes = poseAt(time);
  std::vector<glm::vec4> rows;
  rows.reserve(3 * figure_->joints.size());
  for (const FigureJoint& joint : figure_->joints) {
    const glm::dmat4 m = nodes[static_cast<std::size_t>(joint.node)] * joint.inverseBind;
    for (int row = 0; row < 3; ++row) rows.emplace_back(m[0][row], m[1][row], m[2][row], m[3][row]);
  }
  return rows;
}

}  // namespace simreel::sim
