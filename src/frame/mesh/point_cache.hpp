#pragma once
#include "base/file.hpp"
#include "frame/mesh/mesh_sequence.hpp"
#include "frame/mesh/same_surface.hpp"

#include <cstdint>

namespace simreel::frame {

/// Writes the vertex positions of each frame as PC2 or MDD. These formats do not contain triangles, so
/// readers take them from another file.
class PointCache : public MeshSequence {
 public:
  enum class Format { pc2, mdd };
  /// Throws UserError(usage) if the format is PC2 and the frames are not evenly spaced.
  PointCache(Format format, const std::filesystem::path& file, SequencePlan plan);

  void add(const sim::MeshTable& mesh) override;
  void finish() override { file_.finish(); }

 private:
  void writeHeader(std::size_t points);
  void append(std::uint32_t word);
  void append(float number);
  void flush();

  SequencePlan plan_;
  Format format_;
  SameSurface surface_{plan_};
  int step_;  ///< step between consecutive frame numbers
  PartFile file_;
  std::vector<std::byte> bytes_;  ///< bytes not yet written to the file
};

}  // namespace simreel::frame
