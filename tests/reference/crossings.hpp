#pragma once
#include <vector>

#include <glm/vec3.hpp>

/// Edges that go through faces of which they have no corner, counted once for each face that has them; in
/// float64.
int crossings(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& faces);
