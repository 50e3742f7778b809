#pragma once
#include <vector>

#include <glm/vec3.hpp>

/// Returns the number of pairs of a face and an edge in which the edge passes through the face. Computes in
/// double precision. Skips edges that share a corner with the face. Points from index `firstSolid` on
/// belong to solids. Skips pairs of two solids.
int crossings(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& faces,
              unsigned firstSolid = ~0U);
