#include "sim/mesh/file/texture_place.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace simreel::sim {

namespace {

using Maps = std::array<MeshMap MeshMaterial::*, std::tuple_size_v<MapNames>>;
constexpr Maps mapsInOrder = {&MeshMaterial::colorMap,   &MeshMaterial::opacityMap,
                              &MeshMaterial::metalRough, &MeshMaterial::normals,
                              &MeshMaterial::occlusion,  &MeshMaterial::emissionMap};

bool liesAlike(const TexturePlace& a, const TexturePlace& b) {
  return a.turn == b.turn && a.shift == b.shift;
}

TexturePlace firstPlace(const MeshMaterial& material) {
  const auto first = std::find_if(mapsInOrder.begin(), mapsInOrder.end(),
                                  [&](const auto map) { return (material.*map).image >= 0; });
  return first == mapsInOrder.end() ? TexturePlace{} : (material.**first).place;
}

}  // namespace

void agreeOnPlace(MeshMaterial& material, const MapNames& names,
                  const std::function<void(const char*)>& without) {
  const TexturePlace place = firstPlace(material);
  for (std::size_t i = 0; i < mapsInOrder.size(); ++i) {
    MeshMap& map = material.*mapsInOrder[i];
    if (map.image < 0 || liesAlike(map.place, place)) continue;
    map = {};
    without(names[i]);
  }
}

void placeTextures(Mesh& mesh) {
  if (mesh.uvs.empty()) return;
  std::vector<TexturePlace> places;
  for (const MeshMaterial& material : mesh.materials) places.push_back(firstPlace(material));
  if (std::all_of(places.begin(), places.end(), [](const auto& place) { return liesAlike(place, {}); }))
    return;
  std::vector<bool> moved(mesh.uvs.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const int material = mesh.materialOf.at(i / 3);
    const unsigned vertex = mesh.indices[i];
    if (material < 0 || moved[vertex]) continue;
    const TexturePlace& place = places.at(static_cast<std::size_t>(material));
    mesh.uvs[vertex] = place.turn * mesh.uvs[vertex] + place.shift;
    moved[vertex] = true;
  }
}

}  // namespace simreel::sim
