#include "sim/kernels/memory.hpp"

#include "base/error.hpp"
#include "sim/kernels/formats.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

struct CanonicalKernel {
  static constexpr auto file = "kernels/run/canonical.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"start", int> start;
  gl::Uniform<"stride", int> stride;
  gl::Uniform<"threads", int> threads;
  gl::InOut<"words"> words;
  gl::In<"floats"> floats;
};

struct TexelCopy {
  static constexpr auto file = "kernels/run/texels.comp";
  struct Variant {
    gl::Code<"SAMPLER", "sampler2D"> sampler;
    gl::Code<"PLACE", "xy"> place;
    gl::Flag<"WHOLE"> whole;
  };
  gl::Uniform<"size", glm::ivec4> size;
  gl::Uniform<"threads", int> threads;
  gl::In<"source"> source;
  gl::Out<"texels"> texels;
};

namespace {

std::size_t padded(std::size_t bytes) {
  return (bytes + 15) / 16 * 16;
}

GLenum accessOf(const kernels::Texture& texture) {
  return texture.reads && texture.writes ? GL_READ_WRITE : texture.writes ? GL_WRITE_ONLY : GL_READ_ONLY;
}

/// Issues all memory barriers, so that later dispatches, copies and reads see all earlier writes.
void everythingVisible() {
  gl::AccessLog::barrier(GL_ALL_BARRIER_BITS);
}

void upload(const gl::Texture& texture, GLenum layout, GLenum type, const void* data) {
  if (texture.depth() > 0)
    glTextureSubImage3D(texture.name(), 0, 0, 0, 0, texture.width(), texture.height(), texture.depth(),
                        layout, type, data);
  else
    glTextureSubImage2D(texture.name(), 0, 0, 0, texture.width(), texture.height(), layout, type, data);
}

/// Returns one flag word for each word of an element: 1 if the word is a float. Returns an empty buffer if
/// the element has no floats or if kernels only read the buffer.
gl::Buffer floatsOf(const PlannedBuffer& planned) {
  std::vector<unsigned> words(planned.stride / 4);
  bool any = false;
  for (const KernelSlot& slot : planned.element)
    for (const std::size_t offset : slot.offsets)
      if (slot.number == KernelSlot::Number::real && offset / 4 < words.size()) {
        words[offset / 4] = 1;
        any = true;
      }
  return any && planned.written
             ? gl::Buffer::of("floats of " + planned.name, std::span<const unsigned>(words))
             : gl::Buffer();
}

bool wholeNumbers(const PlannedTexture& planned) {
  return planned.format.ends_with("i");
}
bool unsignedNumbers(const PlannedTexture& planned) {
  return planned.format.ends_with("ui");
}

}  // namespace

KernelStore::KernelStore(const std::string& name, const KernelPlan& plan, unsigned seed)
    : plan_(plan), canonical_(gl::kernelDefines(false)) {
  for (const PlannedBuffer& planned : plan.buffers()) {
    std::vector<std::byte> bytes = plan.firstBytes(planned, seed);
    bytes.resize(padded(bytes.size()));
    buffers_.push_back(
        gl::Buffer::of(fmt::format("{} {}", name, planned.name), std::span<const std::byte>(bytes)));
    floats_.push_back(floatsOf(planned));
  }
  for (const PlannedTexture& planned : plan.textures()) makeTexture(name, planned, seed);
}

KernelStore::~KernelStore() = default;

void KernelStore::makeTexture(const std::string& name, const PlannedTexture& planned, unsigned seed) {
  const std::string label = fmt::format("{} {}", name, planned.name);
  const GLenum format = texelFormat(planned.format);
  textures_.push_back(planned.type == "2D"
                          ? gl::Texture::image(label, format, planned.size.x, planned.size.y)
                          : gl::Texture::layered(label, format, planned.size.x, planned.size.y,
                                                 planned.size.z, planned.type != "3D"));
  textures_.back().unfiltered();
  const std::vector<double> first = plan_.firstTexels(planned, seed);
  std::vector<glm::uvec4> words(planned.count());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const auto number = static_cast<float>(first[i]);
    unsigned& word = words[i / 4][static_cast<int>(i % 4)];
    if (unsignedNumbers(planned))
      word = static_cast<unsigned>(std::clamp(first[i], 0.0, 4294967295.0));
    else if (wholeNumbers(planned))
      word = static_cast<unsigned>(static_cast<int>(std::clamp(first[i], -2147483648.0, 2147483647.0)));
    else
      std::memcpy(&word, &number, sizeof word);
  }
  words_.emplace_back(label + " texels", std::span<const glm::uvec4>(words));
  std::string sampler = planned.type == "2D"   ? "sampler2D"
                        : planned.type == "3D" ? "sampler3D"
                                               : "sampler2DArray";
  if (wholeNumbers(planned)) sampler = (unsignedNumbers(planned) ? "u" : "i") + sampler;
  copies_.emplace_back(gl::kernelDefines(false),
                       TexelCopy::Variant{.sampler = sampler,
                                          .place = std::string(planned.type == "2D" ? "xy" : "xyz"),
                                          .whole = wholeNumbers(planned)});
  putBack(words_.size() - 1);
}

void KernelStore::putBack(std::size_t texture) {
  const PlannedTexture& planned = plan_.textures()[texture];
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, words_[texture].buffer().name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  if (wholeNumbers(planned))
    upload(textures_[texture], GL_RGBA_INTEGER, unsignedNumbers(planned) ? GL_UNSIGNED_INT : GL_INT,
           nullptr);
  else
    upload(textures_[texture], GL_RGBA, GL_FLOAT, nullptr);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

void KernelStore::putBackOne(std::size_t texture) {
  everythingVisible();
  putBack(texture);
}

void KernelStore::putBack() {
  everythingVisible();
  for (std::size_t i = 0; i < textures_.size(); ++i) putBack(i);
}

void KernelStore::bind(const kernels::Kernel& kernel) {
  for (const kernels::Buffer& buffer : kernel.buffers) {
    if (!buffer.shadowOf.empty()) continue;
    const int place = plan_.bufferNamed(buffer.name);
    if (!buffer.previousOf.empty()) keepPrevious(place, plan_.bufferNamed(buffer.previousOf));
    const PlannedBuffer& planned = plan_.buffers()[static_cast<std::size_t>(place)];
    gl::BufferPart{&this->buffer(place), 0, planned.bytes()}.bindStorage(
        static_cast<GLuint>(buffer.binding));
  }
  for (const kernels::Texture& texture : kernel.textures) {
    const gl::Texture& bound = textures_[static_cast<std::size_t>(plan_.textureNamed(texture.name))];
    const auto unit = static_cast<GLuint>(texture.binding);
    if (texture.format.empty() && !texture.writes)
      bound.bind(unit);
    else
      bound.bindImage(unit, accessOf(texture));
  }
}

namespace {

void copyAll(const gl::Buffer& from, const gl::Buffer& to) {
  glCopyNamedBufferSubData(from.name(), to.name(), 0, 0, static_cast<GLsizeiptr>(from.bytes()));
}

}  // namespace

KernelStore::Saved KernelStore::save() {
  settle();
  Saved saved;
  for (const gl::Buffer& buffer : buffers_)
    copyAll(buffer, saved.buffers.emplace_back("saved state", buffer.bytes()));
  for (const gl::WordsArray& words : words_)
    copyAll(words.buffer(), saved.words.emplace_back("saved texels", words.buffer().bytes()));
  return saved;
}

void KernelStore::restore(const Saved& saved) {
  everythingVisible();
  for (std::size_t i = 0; i < buffers_.size(); ++i) copyAll(saved.buffers[i], buffers_[i]);
  for (std::size_t i = 0; i < words_.size(); ++i) copyAll(saved.words[i], words_[i].buffer());
  putBack();
}

void KernelStore::keepPrevious(int copy, int original) {
  everythingVisible();
  glCopyNamedBufferSubData(buffer(original).name(), buffer(copy).name(), 0, 0,
                           static_cast<GLsizeiptr>(buffer(original).bytes()));
}

void KernelStore::swap(const std::string& a, const std::string& b) {
  if (const int one = plan_.bufferNamed(a); one >= 0) {
    std::swap(buffer(one), buffer(plan_.bufferNamed(b)));
    const int counter = plan_.bufferNamed(a + ".counter"), other = plan_.bufferNamed(b + ".counter");
    if (counter >= 0 && other >= 0) std::swap(buffer(counter), buffer(other));
    return;
  }
  const auto one = static_cast<std::size_t>(plan_.textureNamed(a)),
             other = static_cast<std::size_t>(plan_.textureNamed(b));
  std::swap(textures_[one], textures_[other]);
}

void KernelStore::clear(const std::string& name) {
  everythingVisible();
  const std::uint32_t zero = 0;
  if (const int place = plan_.bufferNamed(name); place >= 0) {
    glClearNamedBufferData(buffer(place).name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
    return;
  }
  const auto place = static_cast<std::size_t>(plan_.textureNamed(name));
  const bool whole = wholeNumbers(plan_.textures()[place]);
  const std::array<float, 4> none{};
  glClearTexImage(textures_[place].name(), 0, whole ? GL_RGBA_INTEGER : GL_RGBA, whole ? GL_INT : GL_FLOAT,
                  none.data());
}

void KernelStore::copyCounter(const PlannedEntry& entry) {
  everythingVisible();
  glCopyNamedBufferSubData(buffer(entry.count).name(), buffer(entry.into).name(), 0,
                           static_cast<GLintptr>(entry.offset), 4);
}

void KernelStore::settle() {
  everythingVisible();
  const std::uint32_t zero = 0;
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    const PlannedBuffer& planned = plan_.buffers()[i];
    if (planned.guards == 0) continue;
    const std::size_t begin = planned.header + planned.count() * planned.stride;
    glClearNamedBufferSubData(buffers_[i].name(), GL_R32UI, static_cast<GLintptr>(begin),
                              static_cast<GLsizeiptr>(planned.bytes() - begin), GL_RED_INTEGER,
                              GL_UNSIGNED_INT, &zero);
  }
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    const PlannedBuffer& planned = plan_.buffers()[i];
    if (floats_[i].bytes() == 0) continue;
    const auto words = static_cast<int>(planned.count() * planned.stride / 4);
    const int threads = std::min(words, maxThreads);
    canonical_.dispatch(threads, {.count = words,
                                  .start = static_cast<int>(planned.header / 4),
                                  .stride = static_cast<int>(planned.stride / 4),
                                  .threads = threads,
                                  .words = buffers_[i],
                                  .floats = floats_[i]});
  }
  for (std::size_t i = 0; i < textures_.size(); ++i) {
    const PlannedTexture& planned = plan_.textures()[i];
    const int threads = std::min(static_cast<int>(planned.count()), maxThreads);
    copies_[i].dispatch(threads, {.size = glm::ivec4(planned.size, 0),
                                  .threads = threads,
                                  .source = textures_[i],
                                  .texels = words_[i]});
  }
  everythingVisible();
}

}  // namespace simreel::sim
