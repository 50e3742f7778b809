#pragma once
#include "sim/nodes/node_tree.hpp"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

// All functions of this file use only + - * / and square roots of doubles, so the results have the same
// bits on every machine.

/// Interpolates between two unit quaternions q0 and q1 along the shorter arc (angle a) at the fraction u (0
/// to 1): (sin((1-u) a) q0 + sin(u a) q1) / sin a. Uses Eberly's series of sin(u a) / sin(a) in cos(a) - 1
/// ("A Fast and Accurate Algorithm for Computing SLERP", 2011) with an error below 1e-12.
[[nodiscard]] glm::dquat slerp(const glm::dquat& from, const glm::dquat& to, double u);

/// Returns the value of a channel at `seconds`: xyz, or x y z w of a unit quaternion. Before the first key
/// and after the last key, it is the value of that key. Linear rotations use slerp(). Cubic rotations are
/// interpolated in each component and then normalized.
[[nodiscard]] glm::dvec4 sample(const FigureChannel& channel, double seconds);

/// Sets a property of a node to the value of its channel at the animation time `seconds`.
void move(FigureNode& node, const FigureChannel& channel, double seconds);

/// Returns the matrix product of translation, rotation and scale.
[[nodiscard]] glm::dmat4 transformOf(const glm::dvec3& translation, const glm::dquat& rotation,
                                     const glm::dvec3& scale);

}  // namespace simreel::sim
