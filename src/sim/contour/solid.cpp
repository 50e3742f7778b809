#include "sim/contour/solid.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"
#include "sim/contour/solid_state.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace simreel::sim {

namespace {

constexpr std::int64_t maxVertices = 2'000'000'000;

gl::Defines definesOf(const SolidShape& shape) {
  gl::Defines defines = gl::kernelDefines(false);
  defines.emplace_back("LEVELS", std::to_string(shape.levels.size()));
  if (shape.ceiling) defines.emplace_back("CEILING", "1");
  return defines;
}

void setField(const gl::Program& program, const Field& field) {
  program.set("fieldSize", field.size);
  program.set("rowWords", field.rowWords);
  program.set("firstWord", field.firstWord);
  program.set("cellWords", field.cellWords);
}

void setEach(const gl::Program& program, const char* name, const std::vector<float>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    program.set(fmt::format("{}[{}]", name, i).c_str(), values[i]);
}

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
  const gl::Defines defines = definesOf(shape);
  tally = gl::Program::compute("contour/count.comp", defines);
  gl::Defines freshDefines = defines;
  freshDefines.emplace_back("FRESH", "1");
  freshSheet = gl::Program::compute("contour/sheet.comp", freshDefines);
  list = gl::Program::compute("contour/list.comp", defines);
  cornerVertices = shape.ceiling ? 2 * corners : corners;
  heights = shape.heights;
  border = solidBorder(shape, heights, static_cast<unsigned>(cornerVertices));
  // A cave has a point for every fourth cell at most; what needs more gets it.
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

/// Vertices of so many points, and so many indices, with what never changes in its place.
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
  gl::Defines defines = definesOf(shape);
  defines.emplace_back("CELLS", std::to_string(static_cast<int>(cells)));
  return kernels
      .emplace(cells, FieldKernels{gl::Program::compute("contour/classify.comp", defines),
                                   gl::Program::compute("contour/raise.comp", defines)})
      .first->second;
}

void Solid::State::setPlace(const gl::Program& program) const {
  program.set("samples", samples);
  program.set("rowElements", rowElements);
  program.set("outside", shape.outside);
  program.set("corner", solidCorner(shape));
  program.set("spacing", shape.spacing);
  program.set("fixedIndices", static_cast<unsigned>(border.indices.size()));
  program.set("sheetIndices", static_cast<unsigned>(sheetIndices()));
  program.set("pointRoom", static_cast<unsigned>(pointRoom));
  program.set("indexRoom", static_cast<unsigned>(indexRoom));
  program.set("firstPoint", static_cast<unsigned>(firstPoint()));
  setEach(program, "heights", heights);
}

/// Classes of the samples, tallies, and the sums of those before each.
void Solid::State::count(const FieldKernels& made) {
  const auto all = static_cast<int>(elements);
  setPlace(made.classify);
  setField(made.classify, field);
  setEach(made.classify, "levels", shape.levels);
  field.words->bind(shader::fieldUnit);
  classes.bindState(shader::classesBinding);
  gl::barrier();
  made.classify.dispatch(all);
  gl::barrier();
  classes.bindInput(shader::classesBinding);
  tallies.bindState(shader::talliesBinding);
  setPlace(tally);
  tally.dispatch(all);
  totals.run(tallies, {static_cast<std::int64_t>(border.indices.size()),
                       static_cast<unsigned>(sheetIndices()), 6, pointRoom, indexRoom});
}

const gl::Program& Solid::State::laterSheet() {
  if (!sheet) sheet = gl::Program::compute("contour/sheet.comp", definesOf(shape));
  return sheet;
}

void Solid::State::emit(const FieldKernels& made) {
  classes.bindInput(shader::classesBinding);
  tallies.bindInput(shader::talliesBinding);
  totals.draw().bindStorage(shader::drawBinding);
  positions.bindStorage(shader::positionsBinding);
  indices.bindStorage(shader::indicesBinding);
  normals.bindStorage(shader::normalsBinding);
  const gl::Program& kernel = fresh ? freshSheet : laterSheet();
  fresh = false;
  setPlace(kernel);
  kernel.dispatch(samples.x, samples.y);
  squares.bindState(shader::listedBinding);
  setPlace(list);
  list.dispatch(static_cast<int>(elements));
  gl::barrier();
  squares.bindInput(shader::squaresBinding);
  positions.bindStorage(shader::positionsBinding);
  field.words->bind(shader::fieldUnit);
  next.bindStorage(shader::nextPointsBinding);
  setPlace(made.raise);
  setField(made.raise, field);
  setEach(made.raise, "levels", shape.levels);
  made.raise.dispatch(static_cast<int>(pointRoom));
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
  const std::int64_t most = gl::limits().storageBlockBytes;
  s.getRoom(grownRoom(found.points, s.pointRoom, (most / 16 - s.firstPoint()) / 4),
            grownRoom(found.indices, s.indexRoom, most / 4));
  s.make();
  return true;
}

Surface Solid::surface() const {
  const State& s = *state_;
  Surface surface;
  surface.positions = &s.positionView;
  surface.normals = &s.normalView;
  surface.vertexCount = static_cast<int>(s.firstPoint());  // the border has the others within it
  surface.vertexRoom = static_cast<int>(s.positions.bytes() / sizeof(glm::vec4));
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
