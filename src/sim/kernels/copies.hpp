#pragma once
#include "sim/core/drawable.hpp"
#include "sim/core/simulation.hpp"

#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the axes of a copy of a mesh as columns, as glsl/draw/screen/copy_vertex.glsl computes them.
/// `turn`: the copy's velocity, direction or quaternion.
[[nodiscard]] glm::mat3 copyAxes(Instances::Turning turning, const glm::vec4& turn);

/// Returns copies of a mesh as one mesh. `places`: xyz position, w mass; `velocities`: w is negative for
/// copies that are not drawn; `turns`: one per place, or empty.
[[nodiscard]] MeshTable copiesOf(const Instances& look, std::span<const glm::vec4> places,
                                 std::span<const glm::vec4> velocities, std::span<const glm::vec4> turns);

/// Appends a mesh. Texture coordinates that one of the two lacks become zero.
void append(MeshTable& all, const MeshTable& more);

}  // namespace simreel::sim
