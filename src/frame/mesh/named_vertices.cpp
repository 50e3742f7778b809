#include "frame/mesh/named_vertices.hpp"

namespace simreel::frame {

NamedVertices::NamedVertices(const sim::MeshTable& mesh) : place_(mesh.positions.size(), 0) {
  for (const unsigned i : mesh.indices) place_[i] = 1;
  for (std::size_t i = 0; i < place_.size(); ++i) {
    if (place_[i] == 0) continue;
    place_[i] = static_cast<unsigned>(kept_.size());
    kept_.push_back(static_cast<unsigned>(i));
  }
}

sim::MeshTable NamedVertices::of(const sim::MeshTable& mesh) const {
  sim::MeshTable named;
  named.doubleSided = mesh.doubleSided;
  for (const unsigned i : kept_) {
    named.positions.push_back(mesh.positions[i]);
    named.normals.push_back(mesh.normals[i]);
    if (!mesh.uvs.empty()) named.uvs.push_back(mesh.uvs[i]);
  }
  named.indices.reserve(mesh.indices.size());
  for (const unsigned i : mesh.indices) named.indices.push_back(place_[i]);
  return named;
}

}  // namespace simreel::frame
