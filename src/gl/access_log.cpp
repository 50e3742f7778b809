#include "gl/access_log.hpp"

#include "gl/access_together.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace simreel::gl {

namespace {

/// Time measured in barriers. An access after the n-th barrier has the time n + 1.
using Time = std::uint64_t;
struct Stamp {
  Time read = 0, written = 0, together = 0;
};

constexpr std::array<GLbitfield, 5> kinds = {
    GL_SHADER_STORAGE_BARRIER_BIT, GL_SHADER_IMAGE_ACCESS_BARRIER_BIT, GL_TEXTURE_FETCH_BARRIER_BIT,
    GL_UNIFORM_BARRIER_BIT, GL_COMMAND_BARRIER_BIT};

Time now = 1;
std::array<Time, kinds.size()> lastBarrier{};
Time together = 0;  ///< start time of the current AccessTogether object; 0 if none exists

/// Returns the stamp of a buffer or texture, found by its OpenGL name (names start at 1). Names that differ
/// by a multiple of 65,536 share a stamp, and a new object inherits the stamp of a deleted object with the
/// same name. Both cases cause at most one unneeded barrier.
Stamp& stampOf(AccessLog::Memory memory) {
  constexpr std::size_t maximum = 1 << 16;
  static std::vector<Stamp> stamps[2];
  std::vector<Stamp>& all = stamps[memory.texture ? 1 : 0];
  const std::size_t index = memory.name % maximum;
  if (index >= all.size()) all.resize(index + 64);
  return all[index];
}

}  // namespace

GLbitfield AccessLog::needed(Memory memory, GLbitfield kind, AccessKind way) {
  std::size_t index = 0;
  while (kinds[index] != kind) ++index;
  const Stamp& stamp = stampOf(memory);
  const Time last = lastBarrier[index];
  const auto due = [&](Time access) { return access > last && (together == 0 || access < together); };
  const bool any = due(stamp.written) || (way != AccessKind::read && due(stamp.read)) ||
                   (way != AccessKind::together && due(stamp.together));
  return any ? kind : 0;
}

void AccessLog::note(Memory memory, AccessKind way) {
  Stamp& stamp = stampOf(memory);
  (way == AccessKind::read ? stamp.read : way == AccessKind::write ? stamp.written : stamp.together) = now;
}

void AccessLog::barrier(GLbitfield bits) {
  glMemoryBarrier(bits);
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if ((bits & kinds[i]) != 0) lastBarrier[i] = now;
  ++now;
}

AccessTogether::AccessTogether() {
  together = ++now;
}

AccessTogether::~AccessTogether() {
  together = 0;
}

}  // namespace simreel::gl
