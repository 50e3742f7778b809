#pragma once
#include "gl/buffer.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>
#include <glm/vec4.hpp>

/// Returns the number of words whose bits differ between a state and its twin.
inline std::size_t wordsUnlike(const std::vector<std::uint32_t>& got,
                               const std::vector<glm::vec4>& expected) {
  REQUIRE(got.size() == expected.size() * 4);
  std::size_t different = 0;
  for (std::size_t i = 0; i < got.size(); ++i)
    different += got[i] == std::bit_cast<std::uint32_t>(expected[i / 4][static_cast<int>(i % 4)]) ? 0 : 1;
  return different;
}

inline std::size_t wordsUnlike(const simreel::gl::Buffer& buffer, const std::vector<glm::vec4>& expected) {
  return wordsUnlike(buffer.readAll<std::uint32_t>(), expected);
}
