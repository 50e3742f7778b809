#pragma once
#include <vector>

#include <glm/vec3.hpp>

/// Edges that go through faces of which they have no corner, counted once for each face that has them; in
/// float64. Of solids, whose points are those from `firstSolid` on, none with each other.
int crossings(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& faces,
              unsigned firstSolid = ~0U);
