#include "sim/body/motion.hpp"

#include "sim/body/sample.hpp"
#include "sim/core/collider.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Properties of a node before they are a matrix.
struct Local {
  glm::dvec3 translation;
  glm::dquat rotation;
  glm::dvec3 scale;
};

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
  const std::vector<FigureNode>& nodes = figure_->nodes;
  std::vector<Local> locals;
  locals.reserve(nodes.size());
  for (const FigureNode& node : nodes) locals.push_back({node.translation, node.rotation, node.scale});
  if (animation_ != nullptr) {
    const double at = motionTime(time);
    for (const FigureChannel& channel : animation_->channels) {
      const glm::dvec4 value = sample(channel, at);
      Local& local = locals[static_cast<std::size_t>(channel.node)];
      switch (channel.path) {
        case FigureChannel::Path::translation:
          local.translation = glm::dvec3(value);
          break;
        case FigureChannel::Path::rotation:
          local.rotation = glm::dquat(value.w, value.x, value.y, value.z);
          break;
        case FigureChannel::Path::scale:
          local.scale = glm::dvec3(value);
          break;
      }
    }
  }
  std::vector<glm::dmat4> matrices;
  matrices.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    matrices.push_back(nodes[i].hasMatrix
                           ? nodes[i].matrix
                           : transformOf(locals[i].translation, locals[i].rotation, locals[i].scale));
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
