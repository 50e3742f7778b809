#include "api/arrays.hpp"

#include "api/failure.hpp"
#include "api/scene_state.hpp"
#include "base/error.hpp"
#include "sim/core/carry_over.hpp"

#include <algorithm>
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
constexpr Meaning meanings[] = {
    {"positions", "m", 3}, {"velocities", "m/s", 3}, {"trends", "m/s", 3}, {"spins", "rad/s", 3}};

/// Returns the meaning of an array. Users' kernels choose the names of their arrays.
Meaning meaningOf(std::string_view array) {
  for (const Meaning& one : meanings)
    if (one.name == array) return one;
  return {array, "", elementWords};
}

NumberType typeOf(sim::StateMember::Number number) {
  switch (number) {
    case sim::StateMember::Number::float64:
      return NumberType::float64;
    case sim::StateMember::Number::int32:
      return NumberType::int32;
    case sim::StateMember::Number::uint32:
      return NumberType::uint32;
    case sim::StateMember::Number::float32:
      break;
  }
  return NumberType::float32;
}

const char* nameOf(NumberType type) {
  constexpr const char* names[] = {"float32", "float64", "int32", "uint32", "uint8"};
  return names[static_cast<std::size_t>(type)];
}

std::size_t bytesOf(sim::StateMember::Number number) {
  return number == sim::StateMember::Number::float64 ? 8 : wordBytes;
}

std::size_t product(const std::vector<std::size_t>& shape) {
  std::size_t count = 1;
  for (const std::size_t extent : shape) count *= extent;
  return count;
}

/// True if the elements are numbers, not structures.
bool isPlain(const sim::StateLayout& layout) {
  return layout.members.size() == 1 && layout.members.front().name.empty();
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
  world.visitCheckpointData(visitor, [&](const std::string& name) { visitor.begin(name); });
  return visitor;
}

/// Writes all bytes of an array, whose elements are consecutive, in the array's layout on the device.
void store(const sim::StateArray& array, gl::Buffer& buffer, const std::vector<std::byte>& bytes) {
  if (array.planes.count == 0) return buffer.write(0, bytes);
  const auto each = static_cast<std::size_t>(array.planes.elements);
  std::vector<std::byte> planeWords(each * static_cast<std::size_t>(array.planes.count) * wordBytes);
  for (std::size_t i = 0; i < planeWords.size() / wordBytes; ++i)
    std::memcpy(&planeWords[i * wordBytes], &bytes[(elementWords * (i % each) + i / each) * wordBytes],
                wordBytes);
  buffer.write(array.planes.part.offset, planeWords);
}

std::string indexText(std::size_t number, const std::vector<std::size_t>& shape) {
  std::string text;
  for (std::size_t i = shape.size(); i-- > 0; number /= shape[i])
    text = fmt::format("{}{}{}", number % shape[i], text.empty() ? "" : ", ", text);
  return text;
}

template <class T>
T valueAt(const std::byte* at) {
  T value{};
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// Returns a description of the first number of a member that is NaN or infinite and that has other bits in
/// `present`; empty if there is none.
std::string notFinite(const sim::StateMember& member, const std::byte* given, const std::byte* present) {
  using Number = sim::StateMember::Number;
  if (member.number != Number::float32 && member.number != Number::float64) return {};
  const std::size_t each = bytesOf(member.number);
  for (std::size_t i = 0; i < product(member.shape); ++i, given += each, present += each) {
    const double value = each == wordBytes ? valueAt<float>(given) : valueAt<double>(given);
    if (std::isfinite(value) || std::memcmp(given, present, each) == 0) continue;
    return fmt::format("{}] is {}; a state takes only finite numbers",
                       member.shape.empty() ? "" : ", " + indexText(i, member.shape),
                       std::isnan(value) ? "NaN" : "infinite");
  }
  return {};
}

/// Copies values into the bytes of an array, member by member, so that bytes between members stay.
/// `sourceStride`: bytes from one element's values to the next. Throws Error(usage) for values that are not
/// finite.
void fill(std::vector<std::byte>& bytes, const sim::StateLayout& layout, std::span<const std::byte> values,
          std::size_t sourceStride, const std::string& name) {
  for (std::size_t i = 0; i < product(layout.shape); ++i) {
    for (const sim::StateMember& member : layout.members) {
      const std::byte* const from = values.data() + i * sourceStride + member.offset;
      std::byte* const to = bytes.data() + layout.offset + i * layout.stride + member.offset;
      if (const std::string problem = notFinite(member, from, to); !problem.empty())
        api::fail(ErrorKind::usage, fmt::format("{}{}{}[{}{}", name, member.name.empty() ? "" : ".",
                                                member.name, indexText(i, layout.shape), problem));
      std::memcpy(to, from, product(member.shape) * bytesOf(member.number));
    }
  }
}

}  // namespace

namespace api {

std::vector<std::size_t> denseStrides(const std::vector<std::size_t>& shape, std::size_t numberBytes) {
  std::vector<std::size_t> strides(shape.size(), numberBytes);
  for (std::size_t i = shape.size(); i-- > 1;) strides[i - 1] = strides[i] * shape[i];
  return strides;
}

}  // namespace api

const Scene::State::Described& Scene::State::describedArray(std::string_view object,
                                                            std::string_view array) {
  for (const Described& one : arrays())
    if (one.info.object == object && one.info.name == array) return one;
  SIMREEL_CHECK(false);
}

/// Describes an array. `own`: the simulation's layout; null: elements of four words.
Scene::State::Described Scene::State::describe(std::size_t object, const sim::StateArray& array,
                                               const sim::StateLayout* own) const {
  Described made;
  made.info = {world->objectName(object), array.name, {}, {}, {}, false, {}, 0};
  if (own != nullptr) {
    made.layout = *own;
  } else {
    using Number = sim::StateMember::Number;
    const Meaning meaning = meaningOf(array.name);
    const auto elements = static_cast<std::size_t>(array.elements());
    made.info.unit = meaning.unit;
    made.layout.shape = {elements};
    made.layout.members = {
        {"", array.integers ? Number::uint32 : Number::float32, {meaning.components}, 0}};
    // A cloth of a grid is drawn as a grid of the same elements.
    const sim::Drawables drawables = world->drawables();
    for (const sim::Surface& surface : drawables.surfaces) {
      const auto columns = static_cast<std::size_t>(surface.grid.x),
                 rows = static_cast<std::size_t>(surface.grid.y);
      if (meaning.components == 3 && sim::objectName(surface) == made.info.object &&
          columns * rows == elements)
        made.layout.shape = {rows, columns};
    }
  }
  made.info.shape = made.layout.shape;
  if (isPlain(made.layout)) {
    const sim::StateMember& number = made.layout.members.front();
    made.info.type = typeOf(number.number);
    made.info.shape.insert(made.info.shape.end(), number.shape.begin(), number.shape.end());
    return made;
  }
  made.info.type = NumberType::uint8;
  made.info.elementBytes = made.layout.stride;
  for (const sim::StateMember& member : made.layout.members)
    made.info.members.push_back({member.name, typeOf(member.number), member.shape, member.offset});
  return made;
}

const std::vector<Scene::State::Described>& Scene::State::arrays() {
  if (!arrays_.empty()) return arrays_;
  complete();
  for (std::size_t i = 0; i < world->objectCount(); ++i) {
    const sim::Simulation& simulation = world->object(i);
    const ArrayVisitor visitor = visit(*world, world->objectName(i));
    std::vector<sim::StateLayout> layouts;
    if (const auto* laidOut = dynamic_cast<const sim::LaidOut*>(&simulation)) layouts = laidOut->layouts();
    const std::vector<sim::StateArray> state = simulation.state();
    for (std::size_t k = 0; k < state.size(); ++k) {
      arrays_.push_back(describe(i, state[k], layouts.empty() ? nullptr : &layouts.at(k)));
      arrays_.back().info.writable = visitor.of(state[k]) != nullptr;
    }
  }
  return arrays_;
}

Array Scene::State::read(std::string_view object, std::string_view array) {
  complete();
  const sim::StateArray state = arrayOf(object, array);
  const Described& described = describedArray(object, array);
  const sim::StateLayout& layout = described.layout;
  Array made{described.info.name,   described.info.unit, described.info.type, described.info.shape, {}, {},
             described.info.members};
  made.strides = api::denseStrides(layout.shape, layout.stride);
  if (isPlain(layout)) {
    const sim::StateMember& number = layout.members.front();
    const auto inner = api::denseStrides(number.shape, bytesOf(number.number));
    made.strides.insert(made.strides.end(), inner.begin(), inner.end());
  }
  made.bytes = state.readAll<std::byte>();
  const auto begin = made.bytes.begin() + static_cast<std::ptrdiff_t>(layout.offset);
  made.bytes.erase(made.bytes.begin(), begin);
  made.bytes.resize(product(layout.shape) * layout.stride);
  return made;
}

std::optional<DeviceArray> Scene::State::readOnDevice(std::string_view object, std::string_view array,
                                                      std::string_view member) {
  complete();
  const sim::StateArray state = arrayOf(object, array);
  const sim::StateLayout& layout = describedArray(object, array).layout;
  const auto found = std::find_if(layout.members.begin(), layout.members.end(),
                                  [&](const sim::StateMember& one) { return one.name == member; });
  if (found == layout.members.end()) {
    std::string known;
    for (const sim::StateMember& one : layout.members) known += (known.empty() ? "" : ", ") + one.name;
    api::fail(ErrorKind::usage, fmt::format("{}.{} has no member \"{}\"; it has {}", object, array, member,
                                            isPlain(layout) ? "none" : known));
  }
  api::Cuda& cuda = device->openCuda();
  if (!cuda.problem().empty() || product(layout.shape) == 0) return std::nullopt;
  DeviceArray made;
  made.type = typeOf(found->number);
  made.device = cuda.device();
  made.shape = layout.shape;
  made.shape.insert(made.shape.end(), found->shape.begin(), found->shape.end());
  const sim::Planes& planes = state.planes;
  if (planes.count > 0) {
    if (product(found->shape) > static_cast<std::size_t>(planes.count)) return std::nullopt;
    const auto elements = static_cast<std::size_t>(planes.elements);
    std::vector<api::DeviceRows> blocks;
    for (std::size_t i = 0; i < product(found->shape); ++i)
      blocks.push_back(
          {planes.part.offset + i * elements * wordBytes, wordBytes, wordBytes, product(layout.shape)});
    made.memory = cuda.copyOf(*planes.part.buffer, blocks);
    return made;
  }
  const std::size_t width = product(found->shape) * bytesOf(found->number);
  made.memory = cuda.copyOf(*state.buffer,
                            {{layout.offset + found->offset, layout.stride, width, product(layout.shape)}});
  return made;
}

void Scene::State::write(std::string_view object, std::string_view array, std::span<const std::byte> values,
                         std::optional<NumberType> type) {
  complete();
  const sim::StateArray state = arrayOf(object, array);
  const Described& described = describedArray(object, array);
  const sim::StateLayout& layout = described.layout;
  const std::string name = fmt::format("{}.{}", object, array);
  const bool plain = isPlain(layout);
  if (plain != type.has_value() || (plain && *type != described.info.type))
    api::fail(ErrorKind::usage,
              fmt::format("{} holds {}", name,
                          plain ? nameOf(described.info.type) + std::string(" numbers") : "structures"));
  const std::size_t each =
      plain ? product(layout.members.front().shape) * bytesOf(layout.members.front().number)
            : layout.stride;
  const std::size_t count = product(layout.shape),
                    unit = plain ? each / product(layout.members.front().shape) : 1;
  if (values.size() != count * each)
    api::fail(ErrorKind::usage, fmt::format("{} takes {} {}, not {}", name, count * each / unit,
                                            plain ? "numbers" : "bytes", values.size() / unit));
  gl::Buffer* buffer = visit(*world, object).of(state);
  if (buffer == nullptr)
    api::fail(ErrorKind::usage,
              fmt::format("{} is computed in each frame from other arrays, so it cannot be written", name));
  std::vector<std::byte> bytes = state.readAll<std::byte>();
  fill(bytes, layout, values, each, name);
  gl::beforeWrites();  // kernels that read the present state may still be running
  store(state, *buffer, bytes);
  world->resumeAt(world->frame());
  changed = true;
  movedTo_.reset();
  summaries->start();
}

}  // namespace simreel
