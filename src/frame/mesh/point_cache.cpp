#include "frame/mesh/point_cache.hpp"

#include "base/error.hpp"

#include <bit>

namespace simreel::frame {

namespace {

int stepOf(const SequencePlan& plan) {
  const std::vector<int>& frames = plan.frames;
  return frames.size() > 1 ? frames[1] - frames[0] : 1;
}

/// Checks that the format can hold the frames, and returns `file`. It is called before the file is created.
std::filesystem::path checked(PointCache::Format format, const SequencePlan& plan,
                              const std::filesystem::path& file) {
  const std::vector<int>& frames = plan.frames;
  for (std::size_t i = 1; format == PointCache::Format::pc2 && i < frames.size(); ++i)
    if (frames[i] - frames[i - 1] != stepOf(plan))
      fail(ExitCode::usage,
           "--frames: PC2 has one step from a frame to the next, but {} follows {} and {} follows {}; take "
           "mdd, or even steps",
           frames[1], frames[0], frames[i], frames[i - 1]);
  return file;
}

}  // namespace

PointCache::PointCache(Format format, const std::filesystem::path& file, SequencePlan plan)
    : plan_(std::move(plan)), format_(format), step_(stepOf(plan_)), file_(checked(format, plan_, file)) {}

void PointCache::append(std::uint32_t word) {
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned byte = format_ == Format::pc2 ? i : 3 - i;  // PC2 is little endian, and MDD is big
                                                               // endian.
    bytes_.push_back(static_cast<std::byte>(word >> (8 * byte) & 255U));
  }
}

void PointCache::append(float number) {
  append(std::bit_cast<std::uint32_t>(number));
}

void PointCache::flush() {
  file_.append(bytes_);
  bytes_.clear();
}

void PointCache::writeHeader(std::size_t points) {
  const std::vector<int>& frames = plan_.frames;
  if (format_ == Format::pc2) {
    // "POINTCACHE2" with its terminating zero byte
    for (const char c : "POINTCACHE2") bytes_.push_back(static_cast<std::byte>(c));
    append(std::uint32_t{1});
    append(static_cast<std::uint32_t>(points));
    append(static_cast<float>(frames.front()));
    append(static_cast<float>(step_));
    append(static_cast<std::uint32_t>(frames.size()));
    return;
  }
  append(static_cast<std::uint32_t>(frames.size()));
  append(static_cast<std::uint32_t>(points));
  for (std::size_t i = 0; i < frames.size(); ++i) append(plan_.seconds(i));
}

void PointCache::add(const sim::MeshTable& mesh) {
  const bool first = surface_.seen() == 0;
  const sim::MeshTable named = surface_.next(mesh);
  if (first) writeHeader(named.positions.size());
  for (const glm::vec3& p : named.positions)
    for (int k = 0; k < 3; ++k) append(p[k]);
  flush();
}

}  // namespace simreel::frame
