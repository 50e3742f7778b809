#pragma once
#include "base/file.hpp"
#include "frame/mesh/mesh_sequence.hpp"
#include "frame/mesh/same_surface.hpp"

#include <cstdint>

namespace simreel::frame {

/// The positions of a surface in each frame as PC2 or MDD; whoever reads it has the triangles from another
/// file.
class PointCache : public MeshSequence {
 public:
  enum class Format { pc2, mdd };
  /// Throws UserError(usage) for frames that PC2 has no numbers for.
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
  int step_;  ///< frames from one to the next
  PartFile file_;
  std::vector<std::byte> bytes_;  ///< not yet written
};

}  // namespace simreel::frame
