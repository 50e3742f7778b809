#pragma once
#include "gl/buffer.hpp"

#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace simreel::sim {

/// A part of a buffer that holds elements by their words: the first ones of all, then all second ones and
/// so on. As cards like it where neighbouring invocations look at one word of neighbouring elements.
struct Planes {
  gl::BufferPart part{};
  int count = 0;      ///< of them, at most four; further words of an element are 0
  long elements = 0;  ///< in each
};

/// State that is hashed, compared and can be read back: whole elements of four words, floats unless said.
/// The same on every device, though not where it lies.
struct StateArray {
  const char* name;
  const gl::Buffer* buffer;  ///< element by element, unless it is in planes
  bool integers = false;     ///< bits or counts: no word of them is a NaN
  Planes planes{};

  [[nodiscard]] long elements() const {
    return planes.count > 0 ? planes.elements : static_cast<long>(buffer->bytes() / 16);
  }
  /// Waits for the GPU and copies out, element by element.
  template <class T>
  [[nodiscard]] std::vector<T> readAll() const {
    static_assert(std::is_trivially_copyable_v<T>);
    if (planes.count == 0) return buffer->readAll<T>();
    const auto each = static_cast<std::size_t>(planes.elements);
    std::vector<std::uint32_t> apart(each * static_cast<std::size_t>(planes.count)), words(4 * each);
    buffer->read(planes.part.offset, std::as_writable_bytes(std::span(apart)));
    for (std::size_t i = 0; i < apart.size(); ++i) words[4 * (i % each) + i / each] = apart[i];
    std::vector<T> items(4 * words.size() / sizeof(T));
    std::memcpy(items.data(), words.data(), items.size() * sizeof(T));
    return items;
  }
};

}  // namespace simreel::sim
