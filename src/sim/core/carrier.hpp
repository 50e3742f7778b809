#pragma once
#include <functional>

#include <glm/mat4x4.hpp>

namespace simreel::sim {

/// Where something that carries others is: its own space to the world's at a time (s). Plain arithmetic of
/// doubles: the same bits on every machine. Within a frame what it carries goes from the frame's beginning
/// to its end in a straight line, as skinned vertices do.
using Carrier = std::function<glm::dmat4(double time)>;

}  // namespace simreel::sim
