#include "frame/mesh/glb_sequence.hpp"

#include "base/error.hpp"

#include <limits>

namespace simreel::frame {

namespace {

using Json = nlohmann::ordered_json;

/// Max number of characters of a float in the JSON document: sign, 17 digits, point, and zeros or exponent.
constexpr std::uint64_t longestFloat = 24;

}  // namespace

GlbSequence::GlbSequence(const std::filesystem::path& file, SequencePlan plan)
    : plan_(std::move(plan)), file_(file) {}

std::string GlbSequence::text() const {
  Json document = document_;
  contents_.layout.into(document);
  return document.dump();
}

/// Adds views and accessors for the morph targets. Each morph target holds the positions and normals of one
/// frame after the first, minus the values of the first frame.
void GlbSequence::describeTargets(std::vector<Json>& primitives) {
  const std::size_t count = first_.positions.size();
  const std::uint64_t bytes = sizeof(glm::vec3) * std::uint64_t{count};
  const std::size_t view = contents_.layout.view(2 * bytes * targets(), gltfVertices, sizeof(glm::vec3));
  for (std::size_t i = 0; i < targets(); ++i) {
    bounded_.push_back(contents_.layout.accessor(view, 2 * bytes * i, gltfFloat, count, "VEC3"));
    contents_.layout.setBounds(bounded_.back(), Bounds());
    const std::size_t normals =
        contents_.layout.accessor(view, 2 * bytes * i + bytes, gltfFloat, count, "VEC3");
    for (Json& primitive : primitives)
      if (!primitive.is_null())
        primitive["targets"].push_back({{"POSITION", bounded_.back()}, {"NORMAL", normals}});
  }
}

void GlbSequence::describeAnimation(std::size_t times, std::size_t weights) {
  const Json sampler = {{"input", times}, {"interpolation", "LINEAR"}, {"output", weights}};
  const Json channel = {{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}};
  document_["animations"] = Json::array(
      {{{"name", plan_.name}, {"samplers", Json::array({sampler})}, {"channels", Json::array({channel})}}});
  // The morph targets are named after frames, by a convention of glTF importers.
  for (std::size_t i = 1; i < plan_.frames.size(); ++i)
    document_["meshes"][0]["extras"]["targetNames"].push_back(fmt::format("frame {}", plan_.frames[i]));
}

/// Writes the key times and weights. At frame i the weight of morph target i - 1 is 1, and all other
/// weights are 0.
void GlbSequence::writeTimesAndWeights() {
  std::vector<float> row(plan_.frames.size());
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = plan_.seconds(i);
  file_.append(std::as_bytes(std::span(row)));
  row.resize(targets());
  for (std::size_t i = 0; i <= targets(); ++i) {
    for (std::size_t k = 0; k < row.size(); ++k) row[k] = k + 1 == i ? 1.0F : 0.0F;
    file_.append(std::as_bytes(std::span(row)));
  }
}

void GlbSequence::begin() {
  const std::size_t frames = plan_.frames.size();
  document_ = gltfDocument(plan_.name, plan_.comments);
  std::vector<Json> primitives = addSurface(contents_, first_, plan_.looks);
  GltfMaterials materials(document_, contents_, plan_.skins);
  const Json numbers = materials.add(first_, plan_.looks, plan_.name);
  materials.finish();
  std::size_t times = 0, weights = 0;
  if (targets() > 0) {
    times = contents_.layout.list(0, gltfFloat, frames, "SCALAR");
    contents_.layout.setBounds(times, 0.0F, plan_.seconds(frames - 1));
    weights = contents_.layout.list(0, gltfFloat, frames * targets(), "SCALAR");
    describeTargets(primitives);
  }
  addMesh(document_, plan_.name, primitives, numbers);
  if (targets() > 0) describeAnimation(times, weights);
  room_ = (text().size() + 6 * longestFloat * targets() + 3) / 4 * 4;
  if (const std::uint64_t total = contents_.layout.bytes() + room_ + 64;
      total > std::numeric_limits<std::uint32_t>::max())
    fail(
        ExitCode::usage,
        "\"{}\": {} frames of {} vertices are {:.1f} GB, and GLB holds 4.2; take fewer --frames, or pc2 or "
        "mdd",
        plan_.name, frames, first_.positions.size(), static_cast<double>(total) * 1e-9);
  file_.append(glbHeader(room_, contents_.layout.bytes()));
  const std::string blank(room_, ' ');
  file_.append(std::as_bytes(std::span(blank)));
  file_.append(glbBinaryHeader(contents_.layout.bytes()));
  file_.append(contents_.bytes);
  contents_.bytes = {};
  if (targets() > 0) writeTimesAndWeights();
}

void GlbSequence::add(const sim::MeshTable& mesh) {
  const std::size_t i = surface_.seen();
  sim::MeshTable named = surface_.next(mesh);
  if (i == 0) {
    first_ = std::move(named);
    plan_.looks.colors = NamedVertices(mesh).of(plan_.looks.colors);
    return begin();
  }
  for (std::size_t k = 0; k < named.positions.size(); ++k) {
    named.positions[k] -= first_.positions[k];
    named.normals[k] -= first_.normals[k];
  }
  contents_.layout.setBounds(bounded_[i - 1], Bounds::of(named.positions));
  append(named.positions);
  append(named.normals);
}

void GlbSequence::finish() {
  const std::string document = text();
  SIMREEL_CHECK(document.size() <= room_);  // The unused part of the reserved space still contains blanks.
  file_.put(glbHeader(0, 0).size(), std::as_bytes(std::span(document)));
  file_.finish();
}

}  // namespace simreel::frame
