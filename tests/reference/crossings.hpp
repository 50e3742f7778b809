#pragma once
#include <vector>

#include <glm/vec3.hpp>

/// Returns the number of edges that cross faces without sharing a vertex, once per face that owns the edge;
/// in double precision. Solids (points from `firstSolid` on) are not tested against each other.
int crossings(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& faces,
              unsigned firstSolid = ~0U);
