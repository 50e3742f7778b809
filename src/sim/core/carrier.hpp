#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Returns the transform from a carrier's local space to world space at `time` (seconds). Uses only plain
/// double arithmetic, so the result has the same bits on every machine. Within a frame, carried objects
/// move in a straight line from their pose at the frame's start to their pose at its end, like skinned
/// vertices.
using Carrier = std::function<glm::dmat4(double time)>;

/// Returns the world positions (metres) at `time` (seconds) of points attached to a skin, in the order in
/// which they were attached. The result has the same bits on every machine.
using SkinHolder = std::function<std::vector<glm::dvec3>(double time)>;
/// Attaches points (world space, metres) to the nearest surface points of a body's skin. Each point keeps
/// the offset from the skin that it has at `time` (seconds). Throws UserError(usage) if the body does not
/// exist or has no faces, and rethrows errors of the mesh file reader.
using HeldBySkin =
    std::function<SkinHolder(const std::string& body, std::span<const glm::dvec3> points, double time)>;

}  // namespace simreel::sim
