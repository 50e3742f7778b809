#include "sim/automata/rule/notation_reader.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int maxPlacesRange = 500, maxTriangleRange = 250, maxGaussianRange = 50;  // The limits are those
                                                                                    // of Golly.

/// Maximum number of listed cells that the kernel can process in one dispatch (glsl/automata/places.comp).
constexpr std::size_t maxPlaces = 60000;

/// Reads the neighbourhood after the final N of a rule with the given number of states.
class NeighbourhoodReader {
 public:
  NeighbourhoodReader(NotationReader& reader, WideRule& rule, int states)
      : reader_(reader), rule_(rule), states_(states) {}

  void read() {
    const char letter = reader_.here();
    const std::size_t at = reader_.at();
    reader_.moveTo(at + 1);
    switch (letter) {
      case 'M':
        return;
      case 'N':
        rule_.shape = NeighbourShape::vonNeumann;
        return;
      case 'C':
        rule_.shape = NeighbourShape::circular;
        return;
      case '2':
        rule_.shape = NeighbourShape::euclidean;
        return;
      case '+':
        rule_.shape = NeighbourShape::cross;
        return;
      case 'H':
        rule_.shape = NeighbourShape::hexagonal;
        return;
      case '@':
        custom(at);
        break;
      case 'W':
        weighted(at);
        break;
      case 'X':
      case '*':
      case '#':
      case 'B':
      case 'D':
      case 'A':
      case '3':
      case 'G':
      case 'L':
        named(letter, at);
        break;
      default:
        reader_.wrong(
            at,
            "the neighbourhood is M (Moore), N (von Neumann), C (circular), 2 (Euclidean), + (cross), X "
            "(saltire), * (star), # (hash), B or D (checkerboards), H (hexagonal), A (asterisk), 3 "
            "(tripod), "
            "L (triangular), G (Gaussian), @ (custom) or W (weighted)");
        return;
    }
    rule_.shape = NeighbourShape::places;
    if (rule_.places.size() > maxPlaces)
      reader_.wrong(at, fmt::format("of this range this neighbourhood has {} cells; there may be {}",
                                    rule_.places.size(), maxPlaces));
  }

 private:
  void named(char letter, std::size_t at) {
    const int maximum = letter == 'L'   ? maxTriangleRange
                        : letter == 'G' ? maxGaussianRange
                                        : maxPlacesRange;
    if (rule_.range > maximum) {
      reader_.wrong(at, fmt::format("the range of this neighbourhood is {} at most", maximum));
      return;
    }
    rule_.places = placesOfShape(letter, rule_.range);
    rule_.flips = letter == 'L';
    if (letter == 'L') rule_.range *= 2;
  }

  /// Reads one bit per cell, row by row without the centre.
  void custom(std::size_t at) {
    const std::vector<int> digits = reader_.hexDigits();
    const int side = 2 * rule_.range + 1, cells = side * side;
    if (digits.size() * 4 != static_cast<std::size_t>(cells) - 1) {
      reader_.wrong(at + 1, fmt::format("found {} hexadecimal digits, but {} are needed to say which of "
                                        "the {} cells of range {} count",
                                        digits.size(), (cells - 1) / 4, cells - 1, rule_.range));
      return;
    }
    for (int i = 0; i < cells; ++i) {
      const int bit = i < cells / 2 ? i : i - 1;
      if (i == cells / 2 || (digits[static_cast<std::size_t>(bit / 4)] >> (3 - bit % 4) & 1) != 0)
        rule_.places.push_back({i % side - rule_.range, i / side - rule_.range, 1});
    }
    suffix();
  }

  /// Reads one or two digits per cell, row by row. The highest bit is the sign.
  void weighted(std::size_t at) {
    const std::vector<int> digits = reader_.hexDigits();
    const int side = 2 * rule_.range + 1, cells = side * side;
    const bool two = digits.size() == 2 * static_cast<std::size_t>(cells);
    if (!two && digits.size() != static_cast<std::size_t>(cells)) {
      reader_.wrong(at + 1, fmt::format("found {} hexadecimal digits, but {} or {} are needed for the "
                                        "weights of the cells of range {}",
                                        digits.size(), cells, 2 * cells, rule_.range));
      return;
    }
    for (int i = 0; i < cells; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const int value = two ? digits[2 * k] * 16 + digits[2 * k + 1] : digits[k], sign = two ? 128 : 8;
      const int weight = value >= sign ? sign - value : value;
      if (weight != 0) rule_.places.push_back({i % side - rule_.range, i / side - rule_.range, weight});
    }
    rule_.middle = true;
    if (reader_.here() == ',') {
      const std::size_t first = reader_.at() + 1;
      reader_.moveTo(first);
      rule_.stateWeights = reader_.hexDigits();
      if (rule_.stateWeights.size() != static_cast<std::size_t>(states_))
        reader_.wrong(first, fmt::format("found {} weights of states, but the rule has {} states",
                                         rule_.stateWeights.size(), states_));
    }
    suffix();
  }

  /// Reads the suffix H (hexagonal display) or L (triangular grid).
  void suffix() {
    if (reader_.here() != 'H' && reader_.here() != 'L') return;
    rule_.flips = reader_.here() == 'L';
    reader_.moveTo(reader_.at() + 1);
  }

  NotationReader& reader_;
  WideRule& rule_;
  int states_;
};

}  // namespace

void readNeighbourhood(NotationReader& reader, WideRule& rule, int states) {
  NeighbourhoodReader(reader, rule, states).read();
}

}  // namespace simreel::sim
