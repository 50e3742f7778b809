#pragma once
#include "gl/buffer.hpp"

#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace simreel::sim {

/// Part of a buffer in structure-of-arrays layout: the first word of all elements, then the second word of
/// all elements, and so on. Neighbouring invocations then access consecutive words.
struct Planes {
  gl::BufferPart part{};
  int count = 0;      ///< Number of planes, at most four; the remaining words of an element read as 0.
  long elements = 0;  ///< Number of elements in each plane.
};

/// State array that is hashed, compared and read back. Its elements have four words, which are floats
/// unless `integers` is set. The contents are the same on every device, but the memory layout may differ.
struct StateArray {
  const char* name;
  const gl::Buffer* buffer;  ///< Elements stored consecutively, unless `planes` is used.
  bool integers = false;     ///< True if the words are bits or counts, which are not checked for NaN.
  Planes planes{};

  [[nodiscard]] long elements() const {
    return planes.count > 0 ? planes.elements : static_cast<long>(buffer->bytes() / 16);
  }
  /// Waits for the GPU and returns a copy with each element's words consecutive.
  template <class T>
  [[nodiscard]] std::vector<T> readAll() const {
    static_assert(std::is_trivially_copyable_v<T>);
    if (planes.count == 0) return buffer->readAll<T>();
    const auto each = static_cast<std::size_t>(planes.elements);
    std::vector<std::uint32_t> planeWords(each * static_cast<std::size_t>(planes.count)), words(4 * each);
    buffer->read(planes.part.offset, std::as_writable_bytes(std::span(planeWords)));
    for (std::size_t i = 0; i < planeWords.size(); ++i) words[4 * (i % each) + i / each] = planeWords[i];
    std::vector<T> items(4 * words.size() / sizeof(T));
    std::memcpy(items.data(), words.data(), items.size() * sizeof(T));
    return items;
  }
};

}  // namespace simreel::sim
