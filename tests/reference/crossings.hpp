#pragma once
#include <vector>

#include <glm/vec3.hpp>

/// Returns the number of pairs of a face and an edge that passes through the face, in double precision.
/// Edges that share a corner with the face are skipped. Points from `firstSolid` on belong to solids; pairs
/// of two solids are skipped.
int crossings(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& faces,
              unsigned firstSolid = ~0U);
