#pragma once
#include "sim/core/drawable.hpp"
#include "sim/core/simulation.hpp"

#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the axes of a copy of a mesh as matrix columns, as glsl/draw/screen/copy_vertex.glsl computes
/// them. `turn` is the copy's velocity, direction or quaternion, depending on `turning`.
[[nodiscard]] glm::mat3 copyAxes(Instances::Turning turning, const glm::vec4& turn);

/// Returns copies of a mesh as one mesh. `places` holds the positions (xyz) and masses (w). w of
/// `velocities` is negative for copies that are not drawn. `turns` has one element per position, or is
/// empty.
[[nodiscard]] MeshTable copiesOf(const Instances& look, std::span<const glm::vec4> places,
                                 std::span<const glm::vec4> velocities, std::span<const glm::vec4> turns);

/// Appends a mesh. If one of the two meshes has no texture coordinates, it gets zeros.
void append(MeshTable& all, const MeshTable& more);

}  // namespace simreel::sim
