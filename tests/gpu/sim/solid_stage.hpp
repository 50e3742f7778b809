#pragma once
#include "gl/element_array.hpp"
#include "gpu/context.hpp"
#include "reference/solid_twin.hpp"
#include "sim/contour/solid.hpp"

#include <bit>
#include <functional>
#include <string>
#include <vector>

/// A field of floats or bits in the memory layout of simulations.
struct FieldInMemory {
  FieldInMemory(glm::ivec2 size, const std::function<float(int, int)>& value, bool bits = false) {
    field.name = &name;
    field.size = size;
    field.cells = bits ? simreel::sim::Field::Cells::bits : simreel::sim::Field::Cells::floats;
    field.rowWords = bits ? (size.x + 127) / 128 * 4 : size.x;
    std::vector<std::uint32_t> values(
        (static_cast<std::size_t>(field.rowWords) * static_cast<std::size_t>(size.y) + 3) / 4 * 4, 0);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(field.rowWords);
        if (!bits)
          values[row + static_cast<std::size_t>(x)] = std::bit_cast<std::uint32_t>(value(x, y));
        else if (value(x, y) != 0)
          values[row + static_cast<std::size_t>(x / 32)] |= 1U << static_cast<unsigned>(x % 32);
      }
    buffer = simreel::gl::Buffer::of<std::uint32_t>("field", values);
    words = simreel::gl::Texture::view("field", GL_RGBA32UI, buffer);
    field.words = &words;
  }
  FieldInMemory(const FieldInMemory&) = delete;
  FieldInMemory& operator=(const FieldInMemory&) = delete;
  FieldInMemory(FieldInMemory&&) = delete;
  FieldInMemory& operator=(FieldInMemory&&) = delete;
  ~FieldInMemory() = default;

  std::string name = "field";
  simreel::gl::Buffer buffer;
  simreel::gl::Texture words;
  simreel::sim::Field field;
};

/// The solid of a field. Its buffers have grown until everything fits.
struct SolidOnDevice {
  SolidOnDevice(const simreel::sim::SolidShape& shape, const FieldInMemory& from) : solid("solid", shape) {
    solid.make(from.field, shape.heights);
    while (solid.grow()) ++growths;
    testContext().check();
  }
  simreel::sim::Solid solid;
  int growths = 0;
};

/// Returns true with the given probability, from a hash of the coordinates.
inline bool chance(unsigned x, unsigned y, unsigned seed, double probability) {
  unsigned h = x * 73856093U ^ y * 19349663U ^ seed * 83492791U;
  h = (h ^ h >> 15U) * 0x2c1b3c6dU;
  h = (h ^ h >> 12U) * 0x297a2d39U;
  h ^= h >> 15U;
  return h / 4294967296.0 < probability;
}
