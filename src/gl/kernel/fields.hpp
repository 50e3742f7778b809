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

/// Members of a kernel's interface (gl/kernel/kernel.hpp). Each carries its name in the shader in its type.
namespace simreel::gl {

/// A name as a template's argument.
template <std::size_t size>
struct Name {
  // NOLINTNEXTLINE(google-explicit-constructor): gl::Uniform<"size", ...>
  consteval Name(const char (&given)[size]) { std::copy_n(given, size, text); }
  consteval Name() = default;
  char text[size] = {};
};

/// A uniform's value that a dispatch is given, where the interface has it; or nothing.
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

/// A uniform outside blocks: "a", a member "a.b", an element "a[1]".
template <Name label, class T>
struct Uniform {
  using Field = void;
  using Value = std::conditional_t<std::same_as<T, bool>, int, T>;
  static constexpr const char* name = label.text;
  static constexpr GLenum type = uniformType<T>();
  Uniform() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a dispatch is given the value itself.
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

/// The elements of a uniform array, up to a hundred, or the first of them.
template <Name label, class T, std::size_t... indices>
struct UniformElements {
  using Field = void;
  std::tuple<Uniform<elementName<label, indices>(), T>...> elements;
  UniformElements() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a dispatch is given the values themselves.
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
template <Name label, class T, std::size_t most>
using Uniforms = typename UniformsOf<label, T, std::make_index_sequence<most>>::Type;

enum class Access { read, write, both, together };

/// A storage block (by its name or a member's), a uniform block, a sampler or an image; or an array that
/// glsl/common/memory.glsl or words.glsl declare, whatever it is on the current memory path.
template <Name label, Access wanted>
struct ResourceField : Resource {
  using Field = void;
  static constexpr const char* name = label.text;
  static constexpr Access access = wanted;
  static constexpr std::size_t blockBytes = 0;
  static constexpr bool ambient = false;
  using Resource::Resource;
  ResourceField() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): what a function returns
  ResourceField(const Resource& resource) : Resource(resource) {}
};
template <Name label>
using In = ResourceField<label, Access::read>;
template <Name label>
using Out = ResourceField<label, Access::write>;
template <Name label>
using InOut = ResourceField<label, Access::both>;

/// A resource that dispatches read and write together: by atomics whose results commute, or each at places
/// of its own. They do not wait for each other, only for others that read or write it.
template <Name label>
using Shared = ResourceField<label, Access::together>;

/// A block, sampler or image that may stay bound for many kernels at the number that GLSL gives it, such as
/// the values of a frame: a dispatch that is not given it finds what is bound. The code that binds it makes
/// the barriers around it.
template <Name label>
struct Ambient : In<label> {
  static constexpr bool ambient = true;
  using Base = In<label>;
  using Base::Base;
  Ambient() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): what a function returns
  Ambient(const Resource& resource) : In<label>(resource) {}
};

/// A uniform block, which has to be as large as the C++ struct of its contents.
template <Name label, class Contents>
struct Block : In<label> {
  static constexpr std::size_t blockBytes = sizeof(Contents);
  using Base = In<label>;
  using Base::Base;
  Block() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): what a function returns
  Block(const Resource& resource) : In<label>(resource) {}
};

/// Members of a Variant become #defines. `all` lists the defines of each value that tools compile, `key` is
/// another number for each value, less than `keys`.

/// Defined as 1, with extensions that the shader then requires, or not at all.
template <Name label, Name... extensions>
struct Flag {
  using Field = void;
  static constexpr const char* name = label.text;
  Flag() = default;
  Flag(bool now) : on(now) {}  // NOLINT(google-explicit-constructor): a variant is given the value itself.
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

/// An enum or int whose possible values are listed.
template <Name label, int... values>
struct Choice {
  using Field = void;
  static constexpr const char* name = label.text;
  Choice() = default;
  template <class T>
    requires(std::integral<T> || std::is_enum_v<T>)
  Choice(T now) : value(static_cast<int>(now)) {}  // NOLINT(google-explicit-constructor): as Flag
  void addTo(Defines& defines) const {
    if (((value != values) && ...))
      fail(ExitCode::device, "the kernels' define {} may not be {}", name, value);
    defines.emplace_back(name, std::to_string(value));
  }
  static std::vector<Defines> all() { return {{{name, std::to_string(values)}}...}; }
  static constexpr std::uint64_t keys = sizeof...(values) + 1;  ///< the last: of a value that is not listed
  [[nodiscard]] std::uint64_t key() const {
    std::uint64_t index = 0;
    static_cast<void>(((value == values || (++index, false)) || ...));
    return index;
  }
  int value = std::array{values...}[0];
};
/// Defined as 0 or 1.
template <Name label>
using Switch = Choice<label, 0, 1>;

/// A whole number of a range, of which tools compile both ends. Left out, it is not defined.
template <Name label, int least, int most>
struct Range {
  using Field = void;
  static constexpr const char* name = label.text;
  Range() = default;
  Range(int now) : value(now), defined(true) {}  // NOLINT(google-explicit-constructor): as Flag
  void addTo(Defines& defines) const {
    if (!defined) return;
    if (value < least || value > most)
      fail(ExitCode::device, "the kernels' define {} may not be {}", name, value);
    defines.emplace_back(name, std::to_string(value));
  }
  static std::vector<Defines> all() {
    return {{{name, std::to_string(least)}}, {{name, std::to_string(most)}}};
  }
  /// The first: not defined. The last: beyond the ends.
  static constexpr std::uint64_t keys = most - least + 3;
  [[nodiscard]] std::uint64_t key() const {
    if (!defined) return 0;
    return value < least || value > most ? keys - 1 : static_cast<std::uint64_t>(value - least) + 1;
  }
  int value = 0;
  bool defined = false;
};

/// Text of the program's making, such as a rule as a formula. Left empty, it is not defined; tools compile
/// `sample`.
template <Name label, Name sample>
struct Code {
  using Field = void;
  static constexpr const char* name = label.text;
  Code() = default;
  Code(std::string now) : text(std::move(now)) {}  // NOLINT(google-explicit-constructor): as Flag
  void addTo(Defines& defines) const {
    if (!text.empty()) defines.emplace_back(name, text);
  }
  static std::vector<Defines> all() { return {{{name, sample.text}}}; }
  std::string text;
};

}  // namespace simreel::gl
