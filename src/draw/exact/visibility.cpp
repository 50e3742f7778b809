#include "draw/exact/visibility.hpp"

#include "base/error.hpp"
#include "draw/exact/bindings.hpp"
#include "gl/context.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <string>

namespace simreel::draw {

namespace {

constexpr int rowGroups = 32768;
constexpr int groupItems = 64;

std::size_t samplesOf(const std::string& label, glm::ivec2 size, int samples) {
  const std::size_t all = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                          static_cast<std::size_t>(samples);
  const std::size_t most = Visibility::maxSamples();
  if (all > most)
    fail(ExitCode::device,
         "{} of {}x{} pixels with {} samples: the exact rasterizer holds {} samples on this device "
         "(GL_MAX_TEXTURE_BUFFER_SIZE); lower \"size\" or \"samples\", or set \"rasterizer\" to \"driver\"",
         label, size.x, size.y, samples, most);
  return (all + 3) / 4 * 4;
}

}  // namespace

int smallTriangle() {
  return gl::softwareDriver() ? 64 : 16;
}

void dispatchRows(const gl::Program& program, int items) {
  constexpr int row = rowGroups * groupItems;
  program.dispatch(std::min(items, row), (items + row - 1) / row);
}

std::size_t Visibility::maxSamples() {
  return static_cast<std::size_t>(gl::limits().texelBufferTexels);
}

Visibility::Visibility(const std::string& label, glm::ivec2 size, int samples, bool ids)
    : size_(size),
      samples_(samples),
      withIds_(ids),
      near_("what is nearest on " + label, samplesOf(label, size, samples) * sizeof(GLuint)),
      nearView_(gl::Texture::view(label, GL_R32UI, near_, sizeof(GLuint))),
      nearFours_(gl::Texture::view(label, GL_RGBA32UI, near_, 4 * sizeof(GLuint))) {
  if (withIds_) {
    ids_ = gl::Buffer("what is visible on " + label, near_.bytes());
    idView_ = gl::Texture::view(label, GL_R32UI, ids_, sizeof(GLuint));
    idFours_ = gl::Texture::view(label, GL_RGBA32UI, ids_, 4 * sizeof(GLuint));
  }
  if (!gl::softwareDriver()) clear_ = gl::Program::compute("draw/exact/clear.comp");
}

void Visibility::clear() const {
  // Cards for computing take a millisecond for what a kernel does in a fiftieth of it; software drivers
  // copy.
  constexpr GLuint most = 0xffffffffU;
  if (clear_.name() == 0) {
    glClearNamedBufferData(near_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &most);
    if (withIds_) glClearNamedBufferData(ids_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &most);
    return;
  }
  near_.bindStorage(nearBinding);
  if (withIds_) ids_.bindStorage(idBinding);
  const int quads = static_cast<int>(near_.bytes() / 16);
  clear_.set("quads", quads);
  clear_.set("both", static_cast<int>(withIds_));
  dispatchRows(clear_, quads);
}

void Visibility::bind() const {
  near_.bindStorage(nearBinding);
  nearView_.bind(nearUnit);
  nearFours_.bind(nearFoursUnit);
  if (!withIds_) return;
  ids_.bindStorage(idBinding);
  idView_.bind(idUnit);
  idFours_.bind(idFoursUnit);
}

}  // namespace simreel::draw
