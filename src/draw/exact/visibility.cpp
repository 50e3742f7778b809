#include "draw/exact/visibility.hpp"

#include "base/error.hpp"
#include "draw/exact/exact_view.hpp"
#include "gl/context.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace simreel::draw {

struct ClearSamples {
  static constexpr auto file = "draw/exact/clear.comp";
  gl::Out<"NearBlock"> nearest;
  gl::Out<"IdBlock"> ids;
  gl::Uniform<"quads", int> quads;
  gl::Uniform<"both", bool> both;
};

namespace {

constexpr int rowGroups = 32768;
constexpr int groupItems = 64;

std::size_t samplesOf(const std::string& label, glm::ivec2 size, int samples) {
  const std::size_t all = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                          static_cast<std::size_t>(samples);
  const std::size_t maximum = Visibility::maxSamples();
  if (all > maximum)
    fail(ExitCode::device,
         "{} of {}x{} pixels with {} samples each exceeds the exact rasterizer's limit of {} samples on "
         "this device "
         "(GL_MAX_TEXTURE_BUFFER_SIZE); lower \"size\" or \"samples\", or set \"rasterizer\" to \"driver\"",
         label, size.x, size.y, samples, maximum);
  return (all + 3) / 4 * 4;
}

}  // namespace

SampleLayout sampleLayout() {
  const bool atomics = gl::limits().atomics64;
  const char* asked = std::getenv("SIMREEL_SAMPLE_LAYOUT");
  if (asked == nullptr || *asked == 0) return atomics ? SampleLayout::wholes : SampleLayout::separate;
  const std::string name = asked;
  if (name == "apart") return SampleLayout::separate;
  if (name == "pairs") return SampleLayout::pairs;
  if (name != "wholes")
    fail(ExitCode::usage, "SIMREEL_SAMPLE_LAYOUT is \"apart\", \"pairs\" or \"wholes\", not \"{}\"", name);
  if (!atomics)
    fail(ExitCode::device,
         "SIMREEL_SAMPLE_LAYOUT=wholes: this device has no 64-bit atomics "
         "(GL_NV_shader_atomic_int64)");
  return SampleLayout::wholes;
}

int smallTriangle() {
  return gl::softwareDriver() ? 64 : 6;
}

int smallCopyTriangle() {
  return gl::softwareDriver() ? 64 : 16;
}

int mediumTriangle() {
  return gl::softwareDriver() ? 0 : 64;
}

int smallBall() {
  return gl::softwareDriver() ? 16 : 6;
}

int smallGlow() {
  return gl::softwareDriver() ? 12 : 5;
}

int mediumBall() {
  return gl::softwareDriver() ? 0 : 32;
}

int fansOfTriangles() {
  return gl::softwareDriver() ? 1 << 17 : 0;
}

ListVariant listVariant() {
  return {.ballot = gl::limits().ballot};
}

gl::Resource viewOf(const MapFace& face) {
  if (face.views == nullptr) return {};
  return {*face.views, face.view, sizeof(shader::ExactView)};
}

LaneVariant laneVariant() {
  return {.list = listVariant(), .branches = !gl::softwareDriver()};
}

glm::ivec2 inRows(int items) {
  constexpr int row = rowGroups * groupItems;
  return {std::min(items, row), (items + row - 1) / row};
}

std::size_t Visibility::maxSamples() {
  return static_cast<std::size_t>(gl::limits().texelBufferTexels);
}

Visibility::Visibility(const std::string& label, glm::ivec2 size, int samples, bool ids, bool parallel)
    : size_(size),
      samples_(samples),
      layout_(ids ? sampleLayout() : SampleLayout::separate),
      parallel_(parallel) {
  const bool together = layout_ != SampleLayout::separate;
  const std::size_t words = together ? 2 : 1;
  near_ =
      gl::Buffer("what is nearest on " + label, samplesOf(label, size, samples) * words * sizeof(GLuint));
  nearView_ = gl::Texture::view(label, together ? GL_RG32UI : GL_R32UI, near_, words * sizeof(GLuint));
  nearFours_ = gl::Texture::view(label, GL_RGBA32UI, near_, 4 * sizeof(GLuint));
  if (ids && !together) {
    ids_ = gl::Buffer("what is visible on " + label, near_.bytes());
    idView_ = gl::Texture::view(label, GL_R32UI, ids_, sizeof(GLuint));
    idFours_ = gl::Texture::view(label, GL_RGBA32UI, ids_, 4 * sizeof(GLuint));
  }
  if (!gl::softwareDriver()) clear_ = gl::Kernel<ClearSamples>(gl::Defines());
}

void Visibility::clear() const {
  // On some compute GPUs a kernel clears 50 times as fast as glClearNamedBufferData. On software drivers
  // the kernel is not used, because glClearNamedBufferData is a plain memory fill there.
  constexpr GLuint maximum = 0xffffffffU;
  if (!clear_) {
    glClearNamedBufferData(near_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &maximum);
    if (ids_.name() != 0)
      glClearNamedBufferData(ids_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &maximum);
    return;
  }
  const int quads = static_cast<int>(near_.bytes() / 16);
  const bool both = ids_.name() != 0;
  clear_.dispatch(inRows(quads),
                  {.nearest = near_, .ids = both ? ids_ : near_, .quads = quads, .both = both});
}

SampleTarget Visibility::target(const MapPart& part, const gl::Resource& view) const {
  return {.view = view,
          .before = read<gl::Access::together>(),
          .nearest = near_,
          .ids = ids_.name() != 0 ? ids_ : near_,
          .mapTexels = size_.x,
          .firstKey = part.firstKey,
          .keyStride = part.keyStride};
}

TargetVariant Visibility::variant(Target target, int pass) const {
  return {.samples = variant(),
          .wholes = layout_ == SampleLayout::wholes,
          .pass = pass,
          .sunMap = target == Target::sunMap,
          .lampMap = target == Target::lampMap};
}

std::size_t Visibility::count() const {
  return static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
         static_cast<std::size_t>(samples_);
}

std::vector<GLuint> Visibility::everyOther(std::size_t first) const {
  const auto words = near_.readAll<GLuint>();
  std::vector<GLuint> found(count());
  for (std::size_t i = 0; i < found.size(); ++i) found[i] = words[2 * i + first];
  return found;
}

std::vector<GLuint> Visibility::readKeys() const {
  if (layout_ != SampleLayout::separate) return everyOther(1);
  auto keys = near_.readAll<GLuint>();
  keys.resize(count());
  return keys;
}

std::vector<GLuint> Visibility::readNumbers() const {
  if (layout_ != SampleLayout::separate) return everyOther(0);
  auto numbers = ids_.readAll<GLuint>();
  numbers.resize(count());
  return numbers;
}

}  // namespace simreel::draw
