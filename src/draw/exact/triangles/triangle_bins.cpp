#include "draw/exact/triangles/triangle_bins.hpp"

#include "draw/exact/bindings.hpp"
#include "draw/exact/reserve.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace simreel::draw {

namespace {

constexpr int tileSide = 8;     // of glsl/draw/exact/fixed.glsl
constexpr int binCounts = 512;  // of bins.glsl,
constexpr int firstTileCount = 2;
constexpr int firstFaceCount = 256;
constexpr int ownNodes = 4;
constexpr std::size_t cornerBytes = 48;
constexpr int roundTriangles = 57344;  // whose lists no loop leaves early
constexpr int maxTriangles = 1 << 20;  // of a picture,
constexpr int maxOfFaces = 1 << 18;    // and of all faces; what is more is drawn as large ones are

int roundsOf(int triangles) {
  return std::max((triangles + roundTriangles - 1) / roundTriangles, 1);
}

}  // namespace

int binnedTriangles() {
  return gl::softwareDriver() ? maxTriangles : 0;
}

TriangleBins::TriangleBins(gl::Defines defines, int samples) : defines_(std::move(defines)) {
  defines_.emplace_back("SAMPLES", std::to_string(samples));
}

bool TriangleBins::holds(int triangles, int faces) {
  return faces == 0 ? triangles <= maxTriangles
                    : faces * roundsOf(triangles) <= firstFaceCount - firstTileCount;
}

void TriangleBins::begin(glm::ivec2 size, int triangles, int room, int faces) {
  const glm::ivec2 across = (size + tileSide - 1) / tileSide;
  tiles_ = across.x * across.y;
  faceRounds_ = roundsOf(triangles);
  rounds_ = std::max(faces, 1) * faceRounds_;
  const std::int64_t all = std::int64_t{std::max(faces, 1)} * triangles;
  room_ = static_cast<int>(std::min<std::int64_t>({all, room, faces > 0 ? maxOfFaces : maxTriangles}));
  sharedNodes_ = static_cast<int>(std::min<std::int64_t>(
      room_ + std::int64_t{16} * tiles_ * std::max(faces, 1), std::int64_t{4} * room));
  const auto words = [](int count) { return static_cast<std::size_t>(count) * sizeof(GLuint); };
  const std::size_t heads = words(binCounts + rounds_ * tiles_);
  reserve(bins_, binView_, "lists of triangles by tiles", heads + words(rounds_ * tiles_), GL_R32UI,
          sizeof(GLuint));
  reserve(nodes_, nodeView_, "triangles by tiles", words(2 * (ownNodes * room_ + sharedNodes_)), GL_RG32UI,
          2 * sizeof(GLuint));
  reserve(corners_, cornerView_, "corners by tiles", static_cast<std::size_t>(room_) * cornerBytes,
          GL_RGBA32UI, 16);
  reserve(groups_, "groups for triangles by tiles", static_cast<std::size_t>(rounds_) * GroupCounts::bytes);
  constexpr GLuint zero = 0;
  glClearNamedBufferSubData(bins_.name(), GL_R32UI, 0, static_cast<GLsizeiptr>(heads), GL_RED_INTEGER,
                            GL_UNSIGNED_INT, &zero);
}

void TriangleBins::bind(const gl::Program& program, int face) const {
  bins_.bindStorage(binBinding);
  nodes_.bindStorage(nodeBinding);
  corners_.bindStorage(cornerBinding);
  program.set("binTiles", tiles_);
  program.set("rounds", rounds_);
  program.set("face", face);
  program.set("faceRounds", faceRounds_);
  program.set("roundTriangles", roundTriangles);
  program.set("cornerRoom", room_);
  program.set("sharedNodes", sharedNodes_);
  program.set("firstSharedNode", static_cast<unsigned>(ownNodes * room_));
}

void TriangleBins::draw(const Visibility& into,
                        const std::function<void(int face, const gl::Program& program)>& bindFace) {
  if (!program_) program_ = gl::Program::compute("draw/exact/triangles/binned.comp", defines_);
  counts_.fill(bins_, {.firstCount = firstTileCount, .counts = rounds_}, groups_);
  gl::barrier();
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
  into.bind();
  cornerView_.bind(vertexUnit);
  nodeView_.bind(indexUnit);
  binView_.bind(tileListUnit);
  program_.set("binTiles", tiles_);
  program_.set("rounds", rounds_);
  program_.set("mapTexels", into.size().x);
  for (int round = 0; round < rounds_; ++round) {
    if (bindFace && round % faceRounds_ == 0) bindFace(round / faceRounds_, program_);
    program_.set("round_", round);
    GroupCounts::dispatch(program_, groups_, static_cast<std::size_t>(round));
    gl::barrier();
  }
}

}  // namespace simreel::draw
