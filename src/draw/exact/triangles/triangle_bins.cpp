#include "draw/exact/triangles/triangle_bins.hpp"

#include "draw/exact/reserve.hpp"
#include "gl/context.hpp"

#include <algorithm>
#include <cstdint>

namespace simreel::draw {

struct BinnedTriangles {
  static constexpr auto file = "draw/exact/triangles/binned.comp";
  struct Variant {
    SampleVariant samples;
    gl::Flag<"SUN_MAP"> sunMap;
    gl::Flag<"LAMP_MAP"> lampMap;
  };
  gl::Ambient<"ViewBlock"> view;
  SamplesRead samples;
  gl::InOut<"NearBlock"> nearest;
  gl::InOut<"IdBlock"> ids;
  gl::Uniform<"mapTexels", int> mapTexels;
  gl::Uniform<"firstKey", int> firstKey;
  gl::Uniform<"keyStride", int> keyStride;
  gl::In<"binned"> corners;
  gl::In<"nodes"> nodes;
  gl::In<"bins"> bins;
  gl::Uniform<"binTiles", int> tiles;
  gl::Uniform<"rounds", int> rounds;
  gl::Uniform<"round_", int> round;
};

namespace {

constexpr int tileSide = 8;     // pixels per tile side, as in glsl/draw/exact/fixed.glsl
constexpr int binCounts = 512;  // This constant and the next three have the same values in bins.glsl.
constexpr int firstTileCount = 2;
constexpr int firstFaceCount = 256;
constexpr int ownNodes = 4;
constexpr std::size_t cornerBytes = 48;
constexpr int roundTriangles = 57344;  // triangles per round; the limit keeps every loop below the
                                       // iteration limit of drivers
constexpr int maxTriangles = 1 << 20;  // max number of binned triangles of a picture
constexpr int maxOfFaces = 1 << 18;    // max number of binned triangles of all shadow map faces together;
                                       // further triangles are drawn like large triangles

int roundsOf(int triangles) {
  return std::max((triangles + roundTriangles - 1) / roundTriangles, 1);
}

}  // namespace

int binnedTriangles() {
  return gl::softwareDriver() ? maxTriangles : 0;
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

BinFields TriangleBins::fields(int face) const {
  return {.bins = bins_,
          .nodes = nodes_,
          .corners = corners_,
          .tiles = tiles_,
          .roundTriangles = roundTriangles,
          .face = face,
          .faceRounds = faceRounds_,
          .rounds = rounds_,
          .cornerRoom = room_,
          .sharedNodes = sharedNodes_,
          .firstSharedNode = static_cast<unsigned>(ownNodes * room_)};
}

void TriangleBins::draw(Target target, const Visibility& into,
                        const std::function<const MapFace&(int face)>& faceOf) {
  const gl::Kernel<BinnedTriangles>& kernel = kernels_.of({.samples = into.variant(),
                                                           .sunMap = target == Target::sunMap,
                                                           .lampMap = target == Target::lampMap});
  counts_.fill(bins_, {.firstCount = firstTileCount, .counts = rounds_}, groups_);
  const gl::Buffer& ids = into.idBuffer().name() != 0 ? into.idBuffer() : into.nearestBuffer();
  for (int round = 0; round < rounds_; ++round) {
    const MapFace face = faceOf ? faceOf(round / faceRounds_) : MapFace();
    GroupCounts::dispatch(kernel, groups_, static_cast<std::size_t>(round),
                          {.view = viewOf(face),
                           .samples = into.read(),
                           .nearest = into.nearestBuffer(),
                           .ids = ids,
                           .mapTexels = into.size().x,
                           .firstKey = face.part.firstKey,
                           .keyStride = face.part.keyStride,
                           .corners = cornerView_,
                           .nodes = nodeView_,
                           .bins = binView_,
                           .tiles = tiles_,
                           .rounds = rounds_,
                           .round = round});
  }
}

}  // namespace simreel::draw
