#include "sim/volume/isosurface.hpp"

#include "base/error.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/limits.hpp"
#include "sim/contour/totals.hpp"
#include "sim/grid/color_map.hpp"
#include "sim/volume/cubes.hpp"
#include "sim/volume/model.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace simreel::sim {

namespace {

/// Part of a kernel interface: members of glsl/volume/samples.glsl.
struct SamplesPart {
  gl::Uniform<"volume", glm::ivec4> volume;
  gl::Uniform<"rowElements", int> rowElements;
};

/// Part of a kernel interface: members of glsl/volume/values.glsl.
struct ValuesPart {
  gl::Uniform<"valueLayout", glm::ivec2> layout;
  gl::Uniform<"level", float> level;
  gl::In<"valueWords"> values;
};

/// Part of a kernel interface: members of glsl/volume/tint.glsl, and other inputs common to the kernels for
/// points and for boxes.
struct VolumePointsPart {
  SamplesPart samples;
  ValuesPart values;
  gl::Uniform<"pointRoom", unsigned> pointRoom;
  gl::Uniform<"corner", glm::vec4> corner;
  gl::Uniform<"tintLayout", glm::ivec2> tintLayout;
  gl::Uniform<"tintRange", glm::vec2> tintRange;
  gl::In<"tintWords"> tints;
  gl::In<"tallies"> tallies;
  gl::In<"masks"> masks;
  gl::Out<"PositionBlock"> positions;
  gl::Out<"NormalBlock"> normals;
};

struct ClassifyKernel {
  static constexpr auto file = "volume/classify.comp";
  SamplesPart samples;
  ValuesPart values;
  gl::Out<"classes"> classes;
};

struct CountKernel {
  static constexpr auto file = "volume/count.comp";
  struct Variant {
    gl::Flag<"CUBES"> cubes;
  };
  SamplesPart samples;
  gl::In<"cubes"> cubes;
  gl::In<"classes"> classes;
  gl::Out<"tallies"> tallies;
  gl::Out<"masks"> masks;
};

struct PointsKernel {
  static constexpr auto file = "volume/points.comp";
  struct Variant {
    gl::Flag<"TINTED"> tinted;
  };
  VolumePointsPart part;
};

struct BoxesKernel {
  static constexpr auto file = "volume/boxes.comp";
  using Variant = PointsKernel::Variant;
  VolumePointsPart part;
  gl::Uniform<"indexRoom", unsigned> indexRoom;
  gl::In<"classes"> classes;
  gl::Out<"IndexBlock"> indices;
};

struct TrianglesKernel {
  static constexpr auto file = "volume/triangles.comp";
  SamplesPart samples;
  gl::Uniform<"indexRoom", unsigned> indexRoom;
  gl::In<"cubes"> cubes;
  gl::In<"classes"> classes;
  gl::In<"tallies"> tallies;
  gl::In<"masks"> masks;
  gl::Out<"IndexBlock"> indices;
};

}  // namespace

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
    const gl::Defines defines = gl::kernelDefines(false);
    classify = gl::Kernel<ClassifyKernel>(defines);
    tally = gl::Kernel<CountKernel>(defines, {.cubes = shape.cubes});
    const bool tinted = !colors.empty();
    if (tinted) palette = gl::Vec4Array(name + " colours", paletteOf(colors, shader::volume::volumeColors));
    if (shape.cubes) {
      boxes = gl::Kernel<BoxesKernel>(defines, {.tinted = tinted});
    } else {
      points = gl::Kernel<PointsKernel>(defines, {.tinted = tinted});
      triangles = gl::Kernel<TrianglesKernel>(defines);
    }
    // The initial size is enough for a sphere that fills the volume; grow() enlarges it if necessary.
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
    const glm::ivec2 all(rowElements * samples.y, samples.z);
    const SamplesPart part = {.volume = glm::ivec4(shape.size, shape.closed ? 1 : 0),
                              .rowElements = rowElements};
    const ValuesPart given = {
        .layout = glm::ivec2(values.rowWords, values.firstWord), .level = level, .values = *values.words};
    gl::barrier();
    classify.dispatch(all, {.samples = part, .values = given, .classes = classes});
    tally.dispatch(
        all, {.samples = part, .cubes = cubes, .classes = classes, .tallies = tallies, .masks = masks});
    gl::barrier();
    totals.run(tallies, {0, 0, 0, pointRoom, indexRoom});
    const bool tinted = tint.values.words != nullptr;
    const VolumePointsPart found = {.samples = part,
                                    .values = given,
                                    .pointRoom = static_cast<unsigned>(pointRoom),
                                    .corner = glm::vec4(shape.corner(), shape.spacing),
                                    .tintLayout = glm::ivec2(tint.values.rowWords, tint.values.firstWord),
                                    .tintRange = glm::vec2(tint.range.x, 1 / (tint.range.y - tint.range.x)),
                                    .tints = tinted ? gl::Resource(*tint.values.words) : gl::Resource(),
                                    .tallies = tallies,
                                    .masks = masks,
                                    .positions = positions,
                                    .normals = normals};
    const auto room = static_cast<unsigned>(indexRoom);
    if (shape.cubes) {
      boxes.dispatch(all, {.part = found, .indexRoom = room, .classes = classes, .indices = indices});
    } else {
      points.dispatch(all, {.part = found});
      triangles.dispatch(all, {.samples = part,
                               .indexRoom = room,
                               .cubes = cubes,
                               .classes = classes,
                               .tallies = tallies,
                               .masks = masks,
                               .indices = indices});
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
  gl::Kernel<ClassifyKernel> classify;
  gl::Kernel<CountKernel> tally;
  gl::Kernel<PointsKernel> points;
  gl::Kernel<BoxesKernel> boxes;
  gl::Kernel<TrianglesKernel> triangles;
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
  const std::int64_t maximum = gl::limits().storageBlockBytes;
  s.getRoom(grownRoom(found.points, s.pointRoom, maximum / 16 - shader::volume::boxCorners),
            grownRoom(found.indices, s.indexRoom, maximum / 4));
  s.make();
  return true;
}

Surface Isosurface::surface() const {
  const State& s = *state_;
  Surface surface;
  surface.positions = &s.positionView;
  surface.normals = &s.normalView;
  surface.vertexCount = shader::volume::boxCorners;
  surface.vertexCapacity = static_cast<int>(s.pointRoom) + shader::volume::boxCorners;
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
