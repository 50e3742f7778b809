#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Where something that carries others is: its own space to the world's at a time (s). Plain arithmetic of
/// doubles: the same bits on every machine. Within a frame what it carries goes from the frame's beginning
/// to its end in a straight line, as skinned vertices do.
using Carrier = std::function<glm::dmat4(double time)>;

/// Where points that are attached to a skin are at a time (s): m, world, in their order; as Carrier.
using SkinHolder = std::function<std::vector<glm::dvec3>(double time)>;
/// Attaches points (m, world) to the nearest places of the skin of a body, each as far off as it is at
/// `time`. Throws UserError(usage) for a body that is not there, or has no faces, and what its file's
/// reader throws.
using HeldBySkin =
    std::function<SkinHolder(const std::string& body, std::span<const glm::dvec3> points, double time)>;

}  // namespace simreel::sim
