#include "sim/reaction/mesh_maps.hpp"

#include "base/error.hpp"
#include "base/ieee.hpp"
#include "sim/reaction/rule/model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simreel::sim {

namespace {

using MapsOf = ReactionMesh::Maps;

/// Wraps coordinates outside 0 to 1, so that an image repeats.
double repeated(double at) {
  return at < 0 || at > 1 ? at - std::floor(at) : at;
}

int partsOf(double share) {
  constexpr int parts = shader::reaction::mapParts;
  if (!std::isfinite(share)) return 0;  // Mesh files may contain non-finite texture coordinates.
  return static_cast<int>(std::clamp(std::floor(share * parts), 0.0, double(parts - 1)));
}

/// Returns the texture coordinates of a longitude-latitude sphere for a point on a sphere.
glm::dvec2 longitudeAndLatitude(const glm::dvec3& at) {
  const double around = ieee::atan2(at.x, at.z) / (2 * std::numbers::pi);
  const double polar = ieee::atan2(std::sqrt(at.x * at.x + at.z * at.z), at.y) / std::numbers::pi;
  return {around < 0 ? around + 1 : around, polar};
}

std::vector<glm::dvec2> textureShares(const ReactionMesh& parameters, const Mesh& mesh,
                                      const MeshCells& cells) {
  std::vector<glm::dvec2> shares;
  if (mesh.uvs.empty()) {
    if (parameters.shape == ReactionMesh::Shape::sphere)
      for (const glm::dvec3& place : cells.places) shares.push_back(longitudeAndLatitude(place));
    return shares;
  }
  shares.resize(cells.places.size());
  std::vector<bool> known(cells.places.size(), false);
  for (const unsigned vertex : mesh.indices) {
    const auto cell = static_cast<std::size_t>(cells.cellOf[vertex]);
    if (known[cell]) continue;
    known[cell] = true;
    const glm::dvec2 uv(mesh.uvs[vertex]);
    shares[cell] = {repeated(uv.x), repeated(uv.y)};
  }
  return shares;
}

}  // namespace

std::vector<glm::ivec2> mapPlaces(const ReactionMesh& parameters, const Mesh& mesh, const MeshCells& cells,
                                  const std::string& whose) {
  std::vector<glm::dvec2> shares;
  if (parameters.maps.value_or(MapsOf::texture) == MapsOf::texture)
    shares = textureShares(parameters, mesh, cells);
  if (shares.empty() && parameters.maps == MapsOf::texture)
    fail(ExitCode::usage,
         "{}: the mesh has no texture coordinates{}; let its \"maps\" lie on it from the \"front\" or the "
         "\"top\"",
         whose, parameters.refine > 0 ? ", for \"refine\" closes its seams" : "");
  if (shares.empty()) {
    const bool top = parameters.maps == MapsOf::top;
    const int down = top ? 2 : 1;
    const glm::dvec3 extent = glm::max(cells.high - cells.low, glm::dvec3(1e-30));
    for (const glm::dvec3& place : cells.places) {
      const glm::dvec3 share = (place - cells.low) / extent;
      shares.emplace_back(share.x, top ? share[down] : 1 - share[down]);
    }
  }
  std::vector<glm::ivec2> places;
  places.reserve(shares.size());
  for (const glm::dvec2& share : shares) places.emplace_back(partsOf(share.x), partsOf(share.y));
  return places;
}

}  // namespace simreel::sim
