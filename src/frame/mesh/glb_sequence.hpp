#pragma once
#include "base/file.hpp"
#include "frame/mesh/gltf_parts.hpp"
#include "frame/mesh/mesh_sequence.hpp"
#include "frame/mesh/same_surface.hpp"

namespace simreel::frame {

/// Writes a surface sequence as binary glTF with one morph target for each frame after the first. The JSON
/// document comes before the binary data, but contains the bounds of every morph target. Its size is known
/// after the first frame, so space for it is reserved first and filled last.
class GlbSequence : public MeshSequence {
 public:
  GlbSequence(const std::filesystem::path& file, SequencePlan plan);

  void add(const sim::MeshTable& mesh) override;
  void finish() override;

 private:
  void begin();
  void describeTargets(std::vector<nlohmann::ordered_json>& primitives);
  void describeAnimation(std::size_t times, std::size_t weights);
  void writeTimesAndWeights();
  void append(const std::vector<glm::vec3>& items) { file_.append(std::as_bytes(std::span(items))); }
  [[nodiscard]] std::size_t targets() const { return plan_.frames.size() - 1; }
  [[nodiscard]] std::string text() const;

  SequencePlan plan_;
  SameSurface surface_{plan_};
  PartFile file_;
  sim::MeshTable first_;
  nlohmann::ordered_json document_;
  GltfContents contents_;             ///< document parts and pending binary data; the bytes are dropped
                                      ///< when they have been written
  std::vector<std::size_t> bounded_;  ///< accessor indices of the morph targets' positions
  std::uint64_t room_ = 0;            ///< number of bytes reserved for the JSON document
};

}  // namespace simreel::frame
