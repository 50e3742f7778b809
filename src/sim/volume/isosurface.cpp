#include "sim/volume/isosurface.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"
#include "gl/program.hpp"
#include "sim/contour/totals.hpp"
#include "sim/grid/color_map.hpp"
#include "sim/volume/cubes.hpp"
#include "sim/volume/model.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace simreel::sim {

struct Isosurface::State {
  State(const std::string& label, const IsosurfaceShape& given, const std::vector<glm::vec3>& colors)
      : name(label),
        shape(given),
        samples(given.size + (given.closed ? 2 : 0)),
        rowElements((samples.x + 31) / 32),
        elements(std::int64_t{rowElements} * samples.y * samples.z) {
    checkBufferRoom("the surface of", name, "groups of samples", elements, 16, smaller);
    const auto count = static_cast<int>(elements);
    if (!shape.cubes) cubes = gl::WordsArray(name + " cubes", cubeWords());
    classes = gl::WordsArray(name + " samples", count);
    tallies = gl::WordsArray(name + " tallies", count);
    masks = gl::WordsArray(name + " masks", count);
    totals = Totals(name, count);
    gl::Defines defines = gl::kernelDefines(false);
    classify = gl::Program::compute("volume/classify.comp", defines);
    if (!shape.cubes) triangles = gl::Program::compute("volume/triangles.comp", defines);
    gl::Defines counting = defines;
    if (shape.cubes) counting.emplace_back("CUBES", "1");
    tally = gl::Program::compute("volume/count.comp", counting);
    if (!colors.empty()) {
      palette = gl::Vec4Array(name + " colours", paletteOf(colors, shader::volume::volumeColors));
      defines.emplace_back("TINTED", "1");
    }
    points = gl::Program::compute(shape.cubes ? "volume/boxes.comp" : "volume/points.comp", defines);
    for (const gl::Program* program : {&classify, &tally, &triangles, &points}) {
      if (!*program) continue;
      program->set("volume", glm::ivec4(shape.size, shape.closed ? 1 : 0));
      program->set("rowElements", rowElements);
    }
    points.set("corner", glm::vec4(shape.corner(), shape.spacing));
    // About what a ball within it has; what needs more gets it.
    const std::int64_t faces = std::int64_t{samples.x} * samples.y + std::int64_t{samples.y} * samples.z +
                               std::int64_t{samples.z} * samples.x;
    getRoom(2 * faces, 12 * faces);
  }

  void getRoom(std::int64_t newPoints, std::int64_t newIndices) {
    checkBufferRoom("the surface of", name, "points", newPoints + shader::volume::boxCorners, 16, smaller);
    checkBufferRoom("the surface of", name, "indices", newIndices, 4, smaller);
    pointRoom = newPoints;
    indexRoom = newIndices;
    const auto vertices = static_cast<std::size_t>(pointRoom + shader::volume::boxCorners);
    positions = gl::Buffer(name + " positions", vertices * 16);
    normals = gl::Buffer(name + " normals", vertices * 16);
    std::vector<glm::vec4> box;
    box.reserve(shader::volume::boxCorners);
    const float half = shape.closed ? 0.5F : 0.0F;
    const glm::vec3 low = shape.corner() - half * shape.spacing;
    const glm::vec3 high = low + shape.spacing * (glm::vec3(shape.size) - 1.0F + 2 * half);
    for (int i = 0; i < shader::volume::boxCorners; ++i)
      box.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                       (i & 4) != 0 ? high.z : low.z, 0);
    positions.write(0, std::as_bytes(std::span(box)));
    indices = gl::Buffer(name + " indices", static_cast<std::size_t>(indexRoom) * 4);
    positionView = gl::Texture::view(name + " positions", GL_RGBA32F, positions);
    normalView = gl::Texture::view(name + " normals", GL_RGBA32F, normals);
  }

  void make() {
    const int across = rowElements * samples.y;
    const auto setValues = [&](const gl::Program& program) {
      program.set("valueLayout", glm::ivec2(values.rowWords, values.firstWord));
      program.set("level", level);
      values.words->bind(shader::volume::valuesUnit);
    };
    gl::barrier();
    setValues(classify);
    classes.bindState(shader::volume::classesBinding);
    classify.dispatch(across, samples.z);
    gl::barrier();
    if (!shape.cubes) cubes.bindInput(shader::volume::cubesBinding);
    classes.bindInput(shader::volume::classesBinding);
    tallies.bindState(shader::volume::talliesBinding);
    masks.bindState(shader::volume::masksBinding);
    tally.dispatch(across, samples.z);
    totals.run(tallies, {0, 0, 0, pointRoom, indexRoom});
    tallies.bindInput(shader::volume::talliesBinding);
    masks.bindInput(shader::volume::masksBinding);
    if (!shape.cubes) setValues(points);
    points.set("pointRoom", static_cast<unsigned>(pointRoom));
    if (tint.values.words != nullptr) {
      tint.values.words->bind(shader::volume::tintsUnit);
      points.set("tintLayout", glm::ivec2(tint.values.rowWords, tint.values.firstWord));
      points.set("tintRange", glm::vec2(tint.range.x, 1 / (tint.range.y - tint.range.x)));
    }
    positions.bindStorage(shader::volume::positionsBinding);
    normals.bindStorage(shader::volume::normalsBinding);
    if (shape.cubes) {
      classes.bindInput(shader::volume::classesBinding);
      indices.bindStorage(shader::volume::boxIndicesBinding);
      points.set("indexRoom", static_cast<unsigned>(indexRoom));
      points.dispatch(across, samples.z);
    } else {
      points.dispatch(across, samples.z);
      cubes.bindInput(shader::volume::cubesBinding);
      classes.bindInput(shader::volume::classesBinding);
      indices.bindStorage(shader::volume::indicesBinding);
      triangles.set("indexRoom", static_cast<unsigned>(indexRoom));
      triangles.dispatch(across, samples.z);
    }
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    gl::barrier();
  }

  static constexpr const char* smaller = "make the volume smaller";
  std::string name;
  IsosurfaceShape shape;
  glm::ivec3 samples;
  int rowElements;
  std::int64_t elements;
  std::int64_t pointRoom = 0, indexRoom = 0;
  gl::WordsArray cubes, classes, tallies, masks;
  gl::Vec4Array palette;
  Totals totals;
  gl::Buffer positions, normals, indices;
  gl::Texture positionView, normalView;
  gl::Program classify, tally, points, triangles;
  VolumeValues values;
  float level = 0;
  IsosurfaceTint tint;
};

Isosurface::Isosurface(const std::string& name, const IsosurfaceShape& shape,
                       const std::vector<glm::vec3>& colors)
    : state_(std::make_unique<State>(name, shape, colors)) {}
Isosurface::~Isosurface() = default;
Isosurface::Isosurface(Isosurface&&) noexcept = default;
Isosurface& Isosurface::operator=(Isosurface&&) noexcept = default;

void Isosurface::make(const VolumeValues& values, float level, const IsosurfaceTint& tint) {
  SIMREEL_CHECK(values.rowWords % 4 == 0 && values.firstWord % 4 == 0);
  state_->values = values;
  state_->level = level;
  state_->tint = tint;
  state_->make();
}

bool Isosurface::grow() {
  State& s = *state_;
  if (!s.totals.wait()) return false;
  const shader::ContourDraw found = s.totals.found();
  if (found.points <= s.pointRoom && found.indices <= s.indexRoom) return false;
  const std::int64_t most = gl::limits().storageBlockBytes;
  s.getRoom(grownRoom(found.points, s.pointRoom, most / 16 - shader::volume::boxCorners),
            grownRoom(found.indices, s.indexRoom, most / 4));
  s.make();
  return true;
}

Surface Isosurface::surface() const {
  const State& s = *state_;
  Surface surface;
  surface.positions = &s.positionView;
  surface.normals = &s.normalView;
  surface.vertexCount = shader::volume::boxCorners;
  surface.vertexRoom = static_cast<int>(s.pointRoom) + shader::volume::boxCorners;
  surface.indices = &s.indices;
  surface.indexCount = static_cast<int>(s.indexRoom);
  surface.arguments = &s.totals.draw();
  surface.doubleSided = !s.shape.closed;
  if (s.palette.buffer().bytes() > 0) surface.palette = &s.palette.view();
  return surface;
}

MeshTable Isosurface::mesh() const {
  const State& s = *state_;
  MeshTable table;
  std::vector<glm::vec4> wide(s.totals.found().points);
  const auto narrowed = [&](const gl::Buffer& buffer) {
    buffer.read(shader::volume::boxCorners * sizeof(glm::vec4), std::as_writable_bytes(std::span(wide)));
    return std::vector<glm::vec3>(wide.begin(), wide.end());
  };
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  table.positions = narrowed(s.positions);
  table.normals = narrowed(s.normals);
  table.indices.resize(s.totals.found().indices);
  s.indices.read(0, std::as_writable_bytes(std::span(table.indices)));
  for (unsigned& index : table.indices) index -= shader::volume::boxCorners;
  table.doubleSided = !s.shape.closed;
  return table;
}

}  // namespace simreel::sim
