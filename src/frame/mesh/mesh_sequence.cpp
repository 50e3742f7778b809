#include "frame/mesh/mesh_sequence.hpp"

#include "frame/mesh/glb_sequence.hpp"
#include "frame/mesh/point_cache.hpp"

namespace simreel::frame {

std::unique_ptr<MeshSequence> openSequence(const std::string& format, const std::filesystem::path& file,
                                           SequencePlan plan) {
  if (format == "glb") return std::make_unique<GlbSequence>(file, std::move(plan));
  const auto cache = format == "pc2" ? PointCache::Format::pc2 : PointCache::Format::mdd;
  return std::make_unique<PointCache>(cache, file, std::move(plan));
}

}  // namespace simreel::frame
