#pragma once
#include "sim/nodes/node_tree.hpp"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

// All functions here use only + - * / and square roots of doubles, so the results are bit-identical on
// every machine.

/// Interpolates between two unit quaternions along the shorter arc at the fraction u (0 to 1): (sin((1-u)
/// a) q0 + sin(u a) q1) / sin a. Uses Eberly's series of sin(u a) / sin(a) in cos(a) - 1 ("A Fast and
/// Accurate Algorithm for Computing SLERP", 2011) with an error below 1e-12.
[[nodiscard]] glm::dquat slerp(const glm::dquat& from, const glm::dquat& to, double u);

/// Returns the value of a channel at `seconds`; before the first key and after the last one that key's
/// value. xyz, or the x y z w of a unit quaternion. Linear rotations use slerp(), cubic ones interpolate
/// each component and normalize.
[[nodiscard]] glm::dvec4 sample(const FigureChannel& channel, double seconds);

/// Sets a property of a node to the value of its channel at the animation time `seconds`.
void move(FigureNode& node, const FigureChannel& channel, double seconds);

/// Returns translation times rotation times scale.
[[nodiscard]] glm::dmat4 transformOf(const glm::dvec3& translation, const glm::dquat& rotation,
                                     const glm::dvec3& scale);

}  // namespace simreel::sim
