#include "draw/exact/triangle_bins.hpp"

#include "draw/exact/bindings.hpp"
#include "draw/exact/reserve.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <string>

namespace simreel::draw {

namespace {

constexpr int tileSide = 8;    // of glsl/draw/exact/fixed.glsl
constexpr int binRounds = 64;  // of bins.glsl, and
constexpr std::size_t cornerBytes = 48;
constexpr int ownNodes = 4;
constexpr int roundTriangles = 57344;  // whose lists no loop leaves early

}  // namespace

bool binsTriangles() {
  return gl::softwareDriver();
}

void TriangleBins::begin(glm::ivec2 size, int triangles) {
  const glm::ivec2 across = (size + tileSide - 1) / tileSide;
  tiles_ = across.x * across.y;
  triangles_ = triangles;
  rounds_ = (triangles + roundTriangles - 1) / roundTriangles;
  sharedNodes_ = triangles + 16 * tiles_;
  const auto words = [](int count) { return static_cast<std::size_t>(count) * sizeof(GLuint); };
  const std::size_t heads = words(binRounds + rounds_ * tiles_);
  reserve(bins_, binView_, "lists of triangles by tiles", heads + words(rounds_ * tiles_), GL_R32UI,
          sizeof(GLuint));
  reserve(nodes_, nodeView_, "triangles by tiles", words(2 * (ownNodes * triangles + sharedNodes_)),
          GL_RG32UI, 2 * sizeof(GLuint));
  reserve(corners_, cornerView_, "corners by tiles", static_cast<std::size_t>(triangles) * cornerBytes,
          GL_RGBA32UI, 16);
  reserve(groups_, "groups for triangles by tiles", static_cast<std::size_t>(rounds_) * GroupCounts::bytes);
  constexpr GLuint zero = 0;
  glClearNamedBufferSubData(bins_.name(), GL_R32UI, 0, static_cast<GLsizeiptr>(heads), GL_RED_INTEGER,
                            GL_UNSIGNED_INT, &zero);
}

void TriangleBins::bind(const gl::Program& program) const {
  bins_.bindStorage(binBinding);
  nodes_.bindStorage(nodeBinding);
  corners_.bindStorage(cornerBinding);
  program.set("binTiles", tiles_);
  program.set("rounds", rounds_);
  program.set("roundTriangles", roundTriangles);
  program.set("sharedNodes", sharedNodes_);
  program.set("firstSharedNode", static_cast<unsigned>(ownNodes * triangles_));
}

void TriangleBins::draw(const Visibility& into) {
  if (program_.name() == 0) {
    gl::Defines defines = {{"SAMPLES", std::to_string(samples_)}};
    if (sunMap_) defines.emplace_back("SUN_MAP", "1");
    program_ = gl::Program::compute("draw/exact/triangles/binned.comp", defines);
  }
  counts_.fill(bins_, {.firstCount = 1, .counts = rounds_}, groups_);
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
    program_.set("round_", round);
    program_.use();
    GroupCounts::dispatch(groups_, static_cast<std::size_t>(round));
    gl::barrier();
  }
}

}  // namespace simreel::draw
