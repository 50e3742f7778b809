#pragma once
#include "sim/nodes/node_tree.hpp"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

// Everything here is of + - * / and roots of doubles, so it has the same bits on every machine.

/// A fraction u (0 to 1) of the way from one unit quaternion to another along the shorter arc:
/// (sin((1-u) a) q0 + sin(u a) q1) / sin a, by Eberly's series of sin(u a) / sin(a) in cos(a) - 1 ("A Fast
/// and Accurate Algorithm for Computing SLERP", 2011), to an error below 1e-12.
[[nodiscard]] glm::dquat slerp(const glm::dquat& from, const glm::dquat& to, double u);

/// The value of a channel at `seconds`, before the first and after the last key that of the key: xyz, or a
/// unit quaternion's x y z w. Linear rotations by slerp, cubic ones componentwise, then made unit.
[[nodiscard]] glm::dvec4 sample(const FigureChannel& channel, double seconds);

/// Takes a property of a node to where a channel of it is at that time (s) of its motion.
void move(FigureNode& node, const FigureChannel& channel, double seconds);

/// Translation times rotation times scale of a node.
[[nodiscard]] glm::dmat4 transformOf(const glm::dvec3& translation, const glm::dquat& rotation,
                                     const glm::dvec3& scale);

}  // namespace simreel::sim
