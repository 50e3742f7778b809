#include "api/arrays.hpp"

#include "api/failure.hpp"
#include "api/scene_state.hpp"
#include "base/error.hpp"
#include "sim/core/carry_over.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace simreel {

namespace {

constexpr std::size_t wordBytes = 4, elementWords = 4;

/// Number of words per element that belong to an array, and the unit of these words.
struct Meaning {
  std::string_view name, unit;
  std::size_t components;
};
constexpr Meaning meanings[] = {{"positions", "m", 3}, {"velocities", "m/s", 3}, {"trends", "m/s", 3}};

/// Returns the meaning of an array. Arrays of users' kernels have no known meaning, because users choose
/// their names.
Meaning meaningOf(std::string_view kind, std::string_view array) {
  if (kind != "kernels")
    for (const Meaning& one : meanings)
      if (one.name == array) return one;
  return {array, "", elementWords};
}

NumberType typeOf(const sim::StateArray& array) {
  return array.integers ? NumberType::uint32 : NumberType::float32;
}

/// Finds the buffers that a simulation keeps from frame to frame, and can write into one of them.
class ArrayVisitor final : public sim::CarryOver {
 public:
  explicit ArrayVisitor(std::string_view object) : object_(object) {}
  void begin(const std::string& object) { present_ = object; }
  void array(const char* /*name*/, gl::Buffer& buffer) override {
    if (present_ == object_) buffers_.push_back(&buffer);
  }
  /// Returns the buffer of a state array, or null if the simulation computes the array from other arrays.
  [[nodiscard]] gl::Buffer* of(const sim::StateArray& array) const {
    const gl::Buffer* buffer = array.planes.count > 0 ? array.planes.part.buffer : array.buffer;
    const auto found = std::find(buffers_.begin(), buffers_.end(), buffer);
    return found == buffers_.end() ? nullptr : *found;
  }

 private:
  void word(const char* /*name*/, std::int64_t& /*bits*/) override {}
  std::string object_, present_;
  std::vector<gl::Buffer*> buffers_;
};

ArrayVisitor visit(sim::World& world, std::string_view object) {
  ArrayVisitor visitor(object);
  world.carryOver(visitor, [&](const std::string& name) { visitor.begin(name); });
  return visitor;
}

/// Writes elements of four words, in the layout of the array.
void store(const sim::StateArray& array, gl::Buffer& buffer, const std::vector<std::uint32_t>& words) {
  if (array.planes.count == 0) return buffer.write(0, std::as_bytes(std::span(words)));
  const auto each = static_cast<std::size_t>(array.planes.elements);
  std::vector<std::uint32_t> apart(each * static_cast<std::size_t>(array.planes.count));
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = words[elementWords * (i % each) + i / each];
  buffer.write(array.planes.part.offset, std::as_bytes(std::span(apart)));
}

std::string indexText(std::size_t number, const std::vector<std::size_t>& shape) {
  std::string text;
  for (std::size_t i = shape.size(); i-- > 0; number /= shape[i])
    text = fmt::format("{}{}{}", number % shape[i], text.empty() ? "" : ", ", text);
  return text;
}

/// Throws Error(usage) for the first value that is NaN or infinite. A value is allowed if `present`
/// (elements of four words) has the same bits at the same index.
void requireFinite(const std::string& name, const std::vector<std::size_t>& shape,
                   std::span<const std::byte> values, const std::vector<std::uint32_t>& present) {
  for (std::size_t i = 0; i < values.size() / wordBytes; ++i) {
    float value = 0;
    std::memcpy(&value, values.data() + i * wordBytes, wordBytes);
    if (std::isfinite(value) || std::bit_cast<std::uint32_t>(value) ==
                                    present[elementWords * (i / shape.back()) + i % shape.back()])
      continue;
    api::fail(ErrorKind::usage, fmt::format("{}[{}] is {}; a state takes only finite numbers", name,
                                            indexText(i, shape), std::isnan(value) ? "NaN" : "infinite"));
  }
}

}  // namespace

namespace api {

std::vector<std::size_t> denseStrides(const std::vector<std::size_t>& shape, std::size_t numberBytes) {
  std::vector<std::size_t> strides(shape.size(), numberBytes);
  for (std::size_t i = shape.size(); i-- > 1;) strides[i - 1] = strides[i] * shape[i];
  return strides;
}

Array toArray(const sim::StateArray& state, const ArrayInfo& info) {
  Array array{info.name, info.unit, info.type, info.shape, {}, {}};
  array.strides = denseStrides(array.shape, wordBytes);
  // Each element has four words. The last axis covers only the words that the array's name describes.
  std::size_t stride = elementWords * wordBytes;
  for (std::size_t i = array.shape.size() - 1; i-- > 0;) {
    array.strides[i] = stride;
    stride *= array.shape[i];
  }
  array.bytes = state.readAll<std::byte>();
  return array;
}

}  // namespace api

const ArrayInfo& Scene::State::infoOf(std::string_view object, std::string_view array) {
  for (const ArrayInfo& one : arrays())
    if (one.object == object && one.name == array) return one;
  SIMREEL_CHECK(false);
}

ArrayInfo Scene::State::describe(std::size_t object, const sim::StateArray& array) const {
  const Meaning meaning = meaningOf(scene->objects[object].kind, array.name);
  const auto elements = static_cast<std::size_t>(array.elements());
  ArrayInfo info{
      world->objectName(object), array.name, std::string(meaning.unit), typeOf(array), {elements}, false};
  // If a cloth is a grid, it is drawn as a grid with the same elements, so the grid gives the array's
  // shape.
  const sim::Drawables drawables = world->drawables();
  for (const sim::Surface& surface : drawables.surfaces) {
    const auto columns = static_cast<std::size_t>(surface.grid.x),
               rows = static_cast<std::size_t>(surface.grid.y);
    if (meaning.components == 3 && sim::objectName(surface) == info.object && columns * rows == elements)
      info.shape = {rows, columns};
  }
  info.shape.push_back(meaning.components);
  return info;
}

const std::vector<ArrayInfo>& Scene::State::arrays() {
  if (!infos_.empty()) return infos_;
  complete();
  for (std::size_t i = 0; i < world->objectCount(); ++i) {
    const ArrayVisitor visitor = visit(*world, world->objectName(i));
    for (const sim::StateArray& array : world->object(i).state()) {
      infos_.push_back(describe(i, array));
      infos_.back().writable = visitor.of(array) != nullptr;
    }
  }
  return infos_;
}

void Scene::State::write(std::string_view object, std::string_view array, std::span<const std::byte> values,
                         bool integers) {
  complete();
  const sim::StateArray state = arrayOf(object, array);
  const std::vector<std::size_t> shape = infoOf(object, array).shape;
  std::size_t count = 1;
  for (const std::size_t extent : shape) count *= extent;
  if (integers != state.integers)
    api::fail(ErrorKind::usage,
              fmt::format("{}.{} holds {} numbers", object, array, state.integers ? "uint32" : "float32"));
  if (values.size() != count * wordBytes)
    api::fail(ErrorKind::usage, fmt::format("{}.{} takes {} numbers, not {}", object, array, count,
                                            values.size() / wordBytes));
  gl::Buffer* buffer = visit(*world, object).of(state);
  if (buffer == nullptr)
    api::fail(ErrorKind::usage,
              fmt::format("{}.{} is computed in each frame from other arrays, so it cannot be written",
                          object, array));
  const std::size_t components = shape.back();
  std::vector<std::uint32_t> words = state.readAll<std::uint32_t>();
  if (!integers) requireFinite(fmt::format("{}.{}", object, array), shape, values, words);
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(&words[elementWords * (i / components) + i % components], values.data() + i * wordBytes,
                wordBytes);
  gl::beforeWrites();  // Kernels that read the current state may still be running.
  store(state, *buffer, words);
  world->resumeAt(world->frame());
  changed = true;
  movedTo_.reset();
  summaries->start();
}

}  // namespace simreel
