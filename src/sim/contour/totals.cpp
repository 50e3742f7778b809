#include "sim/contour/totals.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <utility>

namespace simreel::sim {

struct TallySums {
  static constexpr auto file = "contour/sums.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"tile", int> tile;
  gl::In<"tallies"> tallies;
  gl::Out<"tileSums"> tileSums;
};

struct TallyTotal {
  static constexpr auto file = "contour/total.comp";
  gl::Uniform<"tiles", int> tiles;
  gl::Uniform<"fixedIndices", unsigned> fixedIndices;
  gl::Uniform<"sheetIndices", unsigned> sheetIndices;
  gl::Uniform<"pointIndices", unsigned> pointIndices;
  gl::Uniform<"pointRoom", unsigned> pointRoom;
  gl::Uniform<"indexRoom", unsigned> indexRoom;
  gl::InOut<"tileSums"> tileSums;
  gl::Out<"DrawBlock"> draw;
};

struct TallySpread {
  static constexpr auto file = "contour/spread.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"tile", int> tile;
  gl::InOut<"tallies"> tallies;
  gl::In<"tileSums"> tileSums;
};

namespace {

// Number of tallies that an invocation sums. It is limited because a software driver ends a shader's loops
// after 65,535 iterations.
constexpr int tallyTile = 64;

}  // namespace

Totals::Totals(const std::string& name, int count)
    : name_(name),
      count_(count),
      tiles_((count + tallyTile - 1) / tallyTile),
      tileSums_(name + " sums of tallies", tiles_),
      draw_(name + " draw", sizeof(shader::ContourDraw)),
      counted_(gl::Buffer::mapped(name + " counted", sizeof(shader::ContourDraw), false)) {
  const gl::Defines defines = gl::kernelDefines(false);
  sums_ = gl::Kernel<TallySums>(defines);
  total_ = gl::Kernel<TallyTotal>(defines);
  spread_ = gl::Kernel<TallySpread>(defines);
}

Totals& Totals::operator=(Totals&& other) noexcept {
  name_ = std::move(other.name_);
  count_ = other.count_;
  tiles_ = other.tiles_;
  tileSums_ = std::move(other.tileSums_);
  draw_ = std::move(other.draw_);
  counted_ = std::move(other.counted_);
  sums_ = std::move(other.sums_);
  total_ = std::move(other.total_);
  spread_ = std::move(other.spread_);
  std::swap(fence_, other.fence_);
  return *this;
}

void Totals::run(const gl::WordsArray& tallies, const Room& room) {
  gl::barrier();
  sums_.dispatch(tiles_, {.count = count_, .tile = tallyTile, .tallies = tallies, .tileSums = tileSums_});
  total_.dispatch(1, {.tiles = tiles_,
                      .fixedIndices = static_cast<unsigned>(room.fixed),
                      .sheetIndices = room.perSheet,
                      .pointIndices = room.perPoint,
                      .pointRoom = static_cast<unsigned>(room.points),
                      .indexRoom = static_cast<unsigned>(room.indices),
                      .tileSums = tileSums_,
                      .draw = draw_});
  spread_.dispatch(tiles_, {.count = count_, .tile = tallyTile, .tallies = tallies, .tileSums = tileSums_});
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
  glCopyNamedBufferSubData(draw_.name(), counted_.name(), 0, 0, sizeof(shader::ContourDraw));
  glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
  glDeleteSync(fence_);
  fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl::barrier();
}

bool Totals::wait() {
  if (fence_ == nullptr) return false;
  constexpr GLuint64 patience = 1'000'000'000;
  GLenum result = GL_TIMEOUT_EXPIRED;
  while (result == GL_TIMEOUT_EXPIRED)
    result = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, patience);
  if (result == GL_WAIT_FAILED)
    fail(ExitCode::device, "the device stopped responding while it made the surface of \"{}\"", name_);
  return true;
}

std::int64_t grownRoom(std::int64_t now, std::int64_t room, std::int64_t limit) {
  return now <= room ? room : std::max(now, std::min(now + now / 4, limit));
}

void checkBufferRoom(const char* whose, const std::string& name, const char* what, std::int64_t count,
                     int bytes, const char* smaller) {
  const gl::Limits& limits = gl::limits();
  if (count * bytes > limits.storageBlockBytes)
    fail(ExitCode::device,
         "{} \"{}\" has {} {}, {} bytes; this device allows {} in one buffer "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE); {}",
         whose, name, count, what, count * bytes, limits.storageBlockBytes, smaller);
  if (count > limits.texelBufferTexels && bytes >= 8)
    fail(ExitCode::device,
         "{} \"{}\" has {} {}; this device allows {} in one buffer (GL_MAX_TEXTURE_BUFFER_SIZE); {}", whose,
         name, count, what, limits.texelBufferTexels, smaller);
}

}  // namespace simreel::sim
