#include "sim/contour/solid.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"
#include "sim/contour/solid_state.hpp"
#include "sim/grid/field_part.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace simreel::sim {

/// Part of a kernel interface: members of glsl/contour/vertices.glsl.
struct SolidVertices {
  gl::Uniform<"corner", glm::vec2> corner;
  gl::Uniform<"spacing", float> spacing;
  gl::Uniforms<"heights", float, maxSolidLevels + 1> heights;
  gl::Uniform<"fixedIndices", unsigned> fixedIndices;
  gl::Uniform<"indexRoom", unsigned> indexRoom;
  gl::In<"DrawBlock"> draw;
  gl::Out<"PositionBlock"> positions;
};

struct SolidClassify {
  static constexpr auto file = "contour/classify.comp";
  struct Variant {
    gl::Range<"LEVELS", 1, maxSolidLevels> levels;
    FieldCells cells;
  };
  SolidSamples samples;
  FieldPart field;
  gl::Uniforms<"levels", float, maxSolidLevels> levels;
  gl::Out<"classes"> classes;
};

struct SolidCount {
  static constexpr auto file = "contour/count.comp";
  using Variant = SolidCeiling;
  SolidSamples samples;
  gl::In<"classes"> classes;
  gl::Out<"tallies"> tallies;
};

struct SolidSheet {
  static constexpr auto file = "contour/sheet.comp";
  struct Variant {
    SolidVariant shape;
    gl::Flag<"FRESH"> fresh;
  };
  SolidSamples samples;
  SolidVertices vertices;
  gl::In<"classes"> classes;
  gl::In<"tallies"> tallies;
  gl::Out<"IndexBlock"> indices;
  gl::Out<"NormalBlock"> normals;
};

struct SolidList {
  static constexpr auto file = "contour/list.comp";
  using Variant = SolidCeiling;
  SolidSamples samples;
  gl::Uniform<"fixedIndices", unsigned> fixedIndices;
  gl::Uniform<"sheetIndices", unsigned> sheetIndices;
  gl::Uniform<"pointRoom", unsigned> pointRoom;
  gl::In<"classes"> classes;
  gl::In<"tallies"> tallies;
  gl::In<"DrawBlock"> draw;
  gl::Out<"squares"> squares;
};

struct SolidRaise {
  static constexpr auto file = "contour/raise.comp";
  struct Variant {
    SolidVariant shape;
    FieldCells cells;
  };
  SolidSamples samples;
  SolidVertices vertices;
  FieldPart field;
  gl::Uniforms<"levels", float, maxSolidLevels> levels;
  gl::Uniform<"firstPoint", unsigned> firstPoint;
  gl::Uniform<"pointRoom", unsigned> pointRoom;
  gl::Uniform<"sheetIndices", unsigned> sheetIndices;
  gl::In<"classes"> classes;
  gl::In<"squares"> squares;
  gl::Out<"NormalBlock"> normals;
  gl::Out<"IndexBlock"> indices;
  gl::Out<"NextBlock"> next;
};

namespace {

constexpr std::int64_t maxVertices = 2'000'000'000;

}  // namespace

Solid::State::State(const std::string& label, const SolidShape& given)
    : name(label),
      shape(given),
      samples(given.size + 2),
      rowElements((samples.x + 15) / 16),
      corners(std::int64_t{samples.x} * samples.y),
      elements(std::int64_t{rowElements} * samples.y) {
  checkLimits();
  const auto count = static_cast<int>(elements);
  classes = gl::WordsArray(name + " classes", count);
  tallies = gl::WordsArray(name + " tallies", count);
  totals = Totals(name, count);
  const gl::Defines defines = gl::kernelDefines(false);
  tally = gl::Kernel<SolidCount>(defines, variant().ceiling);
  freshSheet = gl::Kernel<SolidSheet>(defines, {.shape = variant(), .fresh = true});
  list = gl::Kernel<SolidList>(defines, variant().ceiling);
  cornerVertices = shape.ceiling ? 2 * corners : corners;
  heights = shape.heights;
  border = solidBorder(shape, heights, static_cast<unsigned>(cornerVertices));
  // In a cave, at most every fourth corner has a contour point. The buffers start with half of that number
  // and are enlarged later if necessary.
  const std::int64_t points = std::max<std::int64_t>(64, corners / 8);
  getRoom(points,
          static_cast<std::int64_t>(border.indices.size()) + sheetIndices() * corners + 12 * points);
}

void Solid::State::checkRoom(const char* what, std::int64_t count, int bytes) const {
  checkBufferRoom("the solid of", name, what, count, bytes, "make the field smaller");
}

void Solid::State::checkLimits() const {
  checkRoom("vertices", (shape.ceiling ? 2 : 1) * corners, 16);
  checkRoom("groups of samples", elements, 16);
}

/// Allocates buffers for this number of contour points and indices, and writes the constant vertices and
/// indices.
void Solid::State::getRoom(std::int64_t points, std::int64_t indexCount) {
  const std::int64_t vertices = firstPoint() + 4 * points;
  SIMREEL_CHECK(vertices < maxVertices);
  checkRoom("vertices", vertices, 16);
  checkRoom("indices", indexCount, 4);
  pointRoom = points;
  indexRoom = indexCount / 2 * 2;
  const auto bytes = static_cast<std::size_t>(vertices);
  positions = gl::Buffer(name + " positions", bytes * 16);
  normals = gl::Buffer(name + " normals", bytes * 16);
  indices = gl::Buffer(name + " indices", static_cast<std::size_t>(indexRoom) * 4);
  next = gl::Buffer(name + " next points", static_cast<std::size_t>(points) * 4);
  squares = gl::WordsArray(name + " squares", static_cast<int>(points));
  positionView = gl::Texture::view(name + " positions", GL_RGBA32F, positions);
  normalView = gl::Texture::view(name + " normals", GL_RGBA32F, normals);
  const auto first = static_cast<std::size_t>(cornerVertices);
  positions.write(first * 16, std::as_bytes(std::span(border.positions)));
  normals.write(first * 16, std::as_bytes(std::span(border.normals)));
  indices.write(0, std::as_bytes(std::span(border.indices)));
  fresh = true;
}

const FieldKernels& Solid::State::kernelsFor(Field::Cells cells) {
  const auto found = kernels.find(cells);
  if (found != kernels.end()) return found->second;
  const gl::Defines defines = gl::kernelDefines(false);
  return kernels
      .emplace(cells, FieldKernels{gl::Kernel<SolidClassify>(defines,
                                                             {.levels = variant().levels, .cells = cells}),
                                   gl::Kernel<SolidRaise>(defines, {.shape = variant(), .cells = cells})})
      .first->second;
}

SolidVertices Solid::State::vertices() const {
  return {.corner = solidCorner(shape),
          .spacing = shape.spacing,
          .heights = heights,
          .fixedIndices = static_cast<unsigned>(border.indices.size()),
          .indexRoom = static_cast<unsigned>(indexRoom),
          .draw = totals.draw(),
          .positions = positions};
}

/// Computes the classes of the samples, the tallies, and the prefix sums of the tallies.
void Solid::State::count(const FieldKernels& made) {
  const auto all = static_cast<int>(elements);
  gl::barrier();
  made.classify.dispatch(
      all, {.samples = samplesPart(), .field = partOf(field), .levels = shape.levels, .classes = classes});
  tally.dispatch(all, {.samples = samplesPart(), .classes = classes, .tallies = tallies});
  totals.run(tallies, {static_cast<std::int64_t>(border.indices.size()),
                       static_cast<unsigned>(sheetIndices()), 6, pointRoom, indexRoom});
}

void Solid::State::emit(const FieldKernels& made) {
  const auto sheets = static_cast<unsigned>(sheetIndices()), room = static_cast<unsigned>(pointRoom);
  if (!fresh && !sheet) sheet = gl::Kernel<SolidSheet>(gl::kernelDefines(false), {variant(), false});
  (fresh ? freshSheet : sheet)
      .dispatch(samples, {.samples = samplesPart(),
                          .vertices = vertices(),
                          .classes = classes,
                          .tallies = tallies,
                          .indices = indices,
                          .normals = normals});
  fresh = false;
  list.dispatch(static_cast<int>(elements), {.samples = samplesPart(),
                                             .fixedIndices = static_cast<unsigned>(border.indices.size()),
                                             .sheetIndices = sheets,
                                             .pointRoom = room,
                                             .classes = classes,
                                             .tallies = tallies,
                                             .draw = totals.draw(),
                                             .squares = squares});
  made.raise.dispatch(static_cast<int>(pointRoom), {.samples = samplesPart(),
                                                    .vertices = vertices(),
                                                    .field = partOf(field),
                                                    .levels = shape.levels,
                                                    .firstPoint = static_cast<unsigned>(firstPoint()),
                                                    .pointRoom = room,
                                                    .sheetIndices = sheets,
                                                    .classes = classes,
                                                    .squares = squares,
                                                    .normals = normals,
                                                    .indices = indices,
                                                    .next = next});
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
  gl::barrier();
}

void Solid::State::make() {
  const FieldKernels& made = kernelsFor(field.cells);
  count(made);
  emit(made);
}

Solid::Solid(const std::string& name, const SolidShape& shape)
    : state_(std::make_unique<State>(name, shape)) {
  SIMREEL_CHECK(!shape.levels.empty() && shape.levels.size() <= maxSolidLevels);
  SIMREEL_CHECK(shape.heights.size() == shape.levels.size() + 1);
  SIMREEL_CHECK(!shape.ceiling || (shape.levels.size() == 1 && shape.outside == 1));
}
Solid::~Solid() = default;
Solid::Solid(Solid&&) noexcept = default;
Solid& Solid::operator=(Solid&&) noexcept = default;

void Solid::make(const Field& field, const std::vector<float>& heights) {
  State& s = *state_;
  SIMREEL_CHECK(field.size == s.shape.size && heights.size() == s.shape.heights.size());
  s.field = field;
  if (heights != s.heights) {
    s.heights = heights;
    s.border = solidBorder(s.shape, heights, static_cast<unsigned>(s.cornerVertices));
    s.positions.write(static_cast<std::size_t>(s.cornerVertices) * 16,
                      std::as_bytes(std::span(s.border.positions)));
  }
  s.make();
}

bool Solid::grow() {
  State& s = *state_;
  if (!s.totals.wait()) return false;
  const shader::ContourDraw found = s.found();
  if (found.points <= s.pointRoom && found.indices <= s.indexRoom) return false;
  const std::int64_t maximum = gl::limits().storageBlockBytes;
  s.getRoom(grownRoom(found.points, s.pointRoom, (maximum / 16 - s.firstPoint()) / 4),
            grownRoom(found.indices, s.indexRoom, maximum / 4));
  s.make();
  return true;
}

Surface Solid::surface() const {
  const State& s = *state_;
  Surface surface;
  surface.positions = &s.positionView;
  surface.normals = &s.normalView;
  surface.vertexCount =
      static_cast<int>(s.firstPoint());  // The bounding box of these vertices contains all other vertices.
  surface.vertexCapacity = static_cast<int>(s.positions.bytes() / sizeof(glm::vec4));
  surface.indices = &s.indices;
  surface.indexCount = static_cast<int>(s.indexRoom);
  surface.arguments = &s.totals.draw();
  return surface;
}

const SolidShape& Solid::shape() const {
  return state_->shape;
}
const std::vector<float>& Solid::heights() const {
  return state_->heights;
}
const Field& Solid::field() const {
  return state_->field;
}
const gl::WordsArray& Solid::classes() const {
  return state_->classes;
}
int Solid::rowElements() const {
  return state_->rowElements;
}

const gl::Buffer& Solid::tallies() const {
  return state_->tallies.buffer();
}

}  // namespace simreel::sim
