#pragma once
#include "gpu/draw/draw_stage.hpp"
#include "sim/grid/field_display.hpp"

#include <bit>
#include <cstdint>
#include <functional>
#include <string>

/// A field in a buffer with padded rows, gaps between cells and an offset of the first word.
struct FieldStage {
  using Cells = simreel::sim::Field::Cells;
  struct Memory {
    int rowPadding = 3;
    int firstWord = 5;
    int cellWords = 2;
  };

  FieldStage(Cells cells, glm::ivec2 size, const std::function<double(int, int)>& value,
             Memory memory = {3, 5, 2}, std::vector<glm::vec3> stops = {glm::vec3(0), glm::vec3(1)})
      : colors(std::move(stops)) {
    const int perWord = cells == Cells::bits ? 32 : cells == Cells::bytes ? 4 : 1;
    const int cellStride = cells == Cells::floats   ? memory.cellWords
                           : cells == Cells::colors ? memory.cellWords + 3
                                                    : 1;
    field.cells = cells;
    field.size = size;
    field.rowWords = (size.x * cellStride + perWord - 1) / perWord + memory.rowPadding;
    field.firstWord = memory.firstWord;
    field.cellWords = cellStride;
    // Fills padding and gaps with words whose bits are all set (NaN as a float), so that reads of them are
    // detected.
    std::vector<std::uint32_t> words(
        static_cast<std::size_t>(memory.firstWord + field.rowWords * size.y + 3) / 4 * 4, 0xffffffffU);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        auto& word = words[static_cast<std::size_t>(memory.firstWord + y * field.rowWords +
                                                    x * cellStride / perWord)];
        const double v = value(x, y);
        if (cells == Cells::bits && v == 0) word &= ~(1U << (x % 32));
        if (cells == Cells::bytes)
          word = (word & ~(255U << (8 * (x % 4)))) | (static_cast<std::uint32_t>(v) << (8 * (x % 4)));
        if (cells == Cells::floats) word = std::bit_cast<std::uint32_t>(static_cast<float>(v));
        if (cells == Cells::colors)
          for (int c = 0; c < 4; ++c) (&word)[c] = std::bit_cast<std::uint32_t>(colorPart(v, c));
      }
    buffer = simreel::gl::Buffer::of<std::uint32_t>("field words", words);
    view = simreel::gl::Texture::view("field words", GL_RGBA32UI, buffer);
    display.smooth = false;
    field.name = &name;
    field.words = &view;
    field.colors = &colors;
    field.display = &display;
  }
  FieldStage(const FieldStage&) = delete;
  FieldStage& operator=(const FieldStage&) = delete;
  FieldStage(FieldStage&&) = delete;
  FieldStage& operator=(FieldStage&&) = delete;
  ~FieldStage() = default;

  /// Returns component `part` of a cell of type `colors`: three colour channels, then the value.
  static float colorPart(double value, int part) {
    const auto v = static_cast<float>(value);
    return part == 0 ? v * v : part == 1 ? 0.25F * v : part == 2 ? 1 - v : v;
  }

  std::string name = "grid";
  simreel::gl::Buffer buffer;
  simreel::gl::Texture view;
  std::vector<glm::vec3> colors;
  simreel::sim::FieldDisplay display;
  simreel::sim::Field field;
};

/// Returns the unrounded sRGB byte (IEC 61966-2-1) of linear light.
inline double srgbByte(double x) {
  x = std::fmin(std::fmax(x, 0), 1);
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}
