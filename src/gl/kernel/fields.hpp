#pragma once
#include "base/error.hpp"
#include "gl/kernel/resource.hpp"
#include "gl/shader_source.hpp"
#include "gl/uniform.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// Field types for the members of a kernel interface (gl/kernel/kernel.hpp). The type of a field contains
/// the field's name in the shader.
namespace simreel::gl {

/// A string as a template argument.
template <std::size_t size>
struct Name {
  // NOLINTNEXTLINE(google-explicit-constructor): gl::Uniform<"size", ...>
  consteval Name(const char (&given)[size]) { std::copy_n(given, size, text); }
  consteval Name() = default;
  char text[size] = {};
};

/// A uniform value passed to a dispatch; `given` is false if the caller did not set it.
struct GivenNumber {
  const void* value;
  bool given;
};

template <class T>
consteval GLenum uniformType() {
  if (std::same_as<T, bool>) return GL_BOOL;
  if (std::same_as<T, int>) return GL_INT;
  if (std::same_as<T, unsigned>) return GL_UNSIGNED_INT;
  if (std::same_as<T, float>) return GL_FLOAT;
  if (std::same_as<T, glm::ivec2>) return GL_INT_VEC2;
  if (std::same_as<T, glm::ivec4>) return GL_INT_VEC4;
  if (std::same_as<T, glm::vec2>) return GL_FLOAT_VEC2;
  if (std::same_as<T, glm::vec3>) return GL_FLOAT_VEC3;
  if (std::same_as<T, glm::vec4>) return GL_FLOAT_VEC4;
  return GL_FLOAT_MAT4;
}

/// A uniform outside blocks. It may be a variable "a", a member "a.b" or an element "a[1]".
template <Name label, class T>
struct Uniform {
  using Field = void;
  using Value = std::conditional_t<std::same_as<T, bool>, int, T>;
  static constexpr const char* name = label.text;
  static constexpr GLenum type = uniformType<T>();
  Uniform() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a dispatch takes the plain value.
  Uniform(const T& now) : value(now), given(true) {}
  Value value{};
  bool given = false;
};

template <Name label, std::size_t index>
consteval auto elementName() {
  static_assert(index < 100);
  constexpr std::size_t length = sizeof(label.text) - 1, digits = index < 10 ? 1 : 2;
  Name<length + digits + 3> name;
  std::copy_n(label.text, length, name.text);
  name.text[length] = '[';
  if (digits == 2) name.text[length + 1] = static_cast<char>('0' + index / 10);
  name.text[length + digits] = static_cast<char>('0' + index % 10);
  name.text[length + digits + 1] = ']';
  return name;
}

/// A uniform array of up to a hundred elements. A dispatch may set only the first ones.
template <Name label, class T, std::size_t... indices>
struct UniformElements {
  using Field = void;
  std::tuple<Uniform<elementName<label, indices>(), T>...> elements;
  UniformElements() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a dispatch takes the plain values.
  UniformElements(std::span<const T> now) {
    SIMREEL_CHECK(now.size() <= sizeof...(indices));
    ((indices < now.size() ? void(std::get<indices>(elements) = now[indices]) : void()), ...);
  }
  // NOLINTNEXTLINE(google-explicit-constructor)
  UniformElements(const std::vector<T>& now) : UniformElements(std::span<const T>(now)) {}
};
template <Name label, class T, class Indices>
struct UniformsOf;
template <Name label, class T, std::size_t... indices>
struct UniformsOf<label, T, std::index_sequence<indices...>> {
  using Type = UniformElements<label, T, indices...>;
};
template <Name label, class T, std::size_t maximum>
using Uniforms = typename UniformsOf<label, T, std::make_index_sequence<maximum>>::Type;

enum class Access { read, write, both, together };

/// A resource of a shader. It is a storage block (`label` is the name of the block or of one of its
/// members), a uniform block, a sampler, an image, or an array declared with the macros of
/// glsl/common/memory.glsl or words.glsl. Such arrays are storage blocks or texel views, depending on
/// gl::memoryPath().
template <Name label, Access wanted>
struct ResourceField : Resource {
  using Field = void;
  static constexpr const char* name = label.text;
  static constexpr Access access = wanted;
  static constexpr std::size_t blockBytes = 0;
  static constexpr bool ambient = false;
  using Resource::Resource;
  ResourceField() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): converts a function's Resource result
  ResourceField(const Resource& resource) : Resource(resource) {}
};
template <Name label>
using In = ResourceField<label, Access::read>;
template <Name label>
using Out = ResourceField<label, Access::write>;
template <Name label>
using InOut = ResourceField<label, Access::both>;

/// A resource that several dispatches read and write in any order relative to each other. They use atomics
/// whose results do not depend on the order, or access separate addresses. These dispatches wait only for
/// other types of access.
template <Name label>
using Shared = ResourceField<label, Access::together>;

/// A block, sampler or image, such as the values of a frame, that may stay bound for many kernels at the
/// binding declared in GLSL. A dispatch that passes no value for it uses the current binding. The code that
/// binds it must issue the barriers.
template <Name label>
struct Ambient : In<label> {
  static constexpr bool ambient = true;
  using Base = In<label>;
  using Base::Base;
  Ambient() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): converts a function's Resource result
  Ambient(const Resource& resource) : In<label>(resource) {}
};

/// A uniform block whose size must equal the size of the C++ struct `Contents`.
template <Name label, class Contents>
struct Block : In<label> {
  static constexpr std::size_t blockBytes = sizeof(Contents);
  using Base = In<label>;
  using Base::Base;
  Block() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): converts a function's Resource result
  Block(const Resource& resource) : In<label>(resource) {}
};

/// Field types for a Variant. Each field becomes a #define. `all` returns the defines of each value that
/// tools compile. `key` returns a different number for each value; the number is less than `keys`.

/// A define that is 1 or absent. If it is 1, the shader also requires the given GLSL extensions.
template <Name label, Name... extensions>
struct Flag {
  using Field = void;
  static constexpr const char* name = label.text;
  Flag() = default;
  Flag(bool now) : on(now) {}  // NOLINT(google-explicit-constructor): a variant takes the plain value
  void addTo(Defines& defines) const {
    if (!on) return;
    defines.emplace_back(name, "1");
    (defines.emplace_back(extensionDefine, extensions.text), ...);
  }
  static std::vector<Defines> all() { return {{}, {{name, "1"}, {extensionDefine, extensions.text}...}}; }
  static constexpr std::uint64_t keys = 2;
  [[nodiscard]] std::uint64_t key() const { return on ? 1 : 0; }
  bool on = false;
};

/// An enum or int with a fixed list of possible values.
template <Name label, int... values>
struct Choice {
  using Field = void;
  static constexpr const char* name = label.text;
  Choice() = default;
  template <class T>
    requires(std::integral<T> || std::is_enum_v<T>)
  Choice(T now) : value(static_cast<int>(now)) {}  // NOLINT(google-explicit-constructor): as in Flag
  void addTo(Defines& defines) const {
    if (((value != values) && ...))
      fail(ExitCode::device, "the kernels' define {} may not be {}", name, value);
    defines.emplace_back(name, std::to_string(value));
  }
  static std::vector<Defines> all() { return {{{name, std::to_string(values)}}...}; }
  static constexpr std::uint64_t keys =
      sizeof...(values) + 1;  ///< the last key represents all values that are not listed
  [[nodiscard]] std::uint64_t key() const {
    std::uint64_t index = 0;
    static_cast<void>(((value == values || (++index, false)) || ...));
    return index;
  }
  int value = std::array{values...}[0];
};
/// A define that is 0 or 1.
template <Name label>
using Switch = Choice<label, 0, 1>;

/// An integer within a range. Tools compile both ends of the range. If it has no value, the name is not
/// defined.
template <Name label, int minimum, int maximum>
struct Range {
  using Field = void;
  static constexpr const char* name = label.text;
  Range() = default;
  Range(int now) : value(now), defined(true) {}  // NOLINT(google-explicit-constructor): as in Flag
  void addTo(Defines& defines) const {
    if (!defined) return;
    if (value < minimum || value > maximum)
      fail(ExitCode::device, "the kernels' define {} may not be {}", name, value);
    defines.emplace_back(name, std::to_string(value));
  }
  static std::vector<Defines> all() {
    return {{{name, std::to_string(minimum)}}, {{name, std::to_string(maximum)}}};
  }
  /// Number of keys. The first key means "not defined", and the last key means "out of range".
  static constexpr std::uint64_t keys = maximum - minimum + 3;
  [[nodiscard]] std::uint64_t key() const {
    if (!defined) return 0;
    return value < minimum || value > maximum ? keys - 1 : static_cast<std::uint64_t>(value - minimum) + 1;
  }
  int value = 0;
  bool defined = false;
};

/// Generated GLSL code as a define, for example the rule of a cell as a formula. If the code is empty, the
/// name is not defined. Tools compile the code `sample`.
template <Name label, Name sample>
struct Code {
  using Field = void;
  static constexpr const char* name = label.text;
  Code() = default;
  Code(std::string now) : text(std::move(now)) {}  // NOLINT(google-explicit-constructor): as in Flag
  void addTo(Defines& defines) const {
    if (!text.empty()) defines.emplace_back(name, text);
  }
  static std::vector<Defines> all() { return {{{name, sample.text}}}; }
  std::string text;
};

}  // namespace simreel::gl
