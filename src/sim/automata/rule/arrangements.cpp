#include "sim/automata/rule/arrangements.hpp"

#include <array>
#include <bit>
#include <vector>

namespace simreel::sim {

namespace {

// One neighbourhood for each letter, as rows from the upper left, for 1 to 4 neighbours. For 8 - n
// neighbours, a letter denotes the complement of its arrangement for n. The letters were defined by A.
// Hensel, see Golly's help and the LifeWiki.
struct Sample {
  char letter;
  const char* cells;
};
constexpr Sample samples[] = {
    {'c', "o........"}, {'e', ".o......."},  // arrangements of 1 neighbour
    {'c', "o.o......"}, {'e', ".o.o....."}, {'k', "o....o..."}, {'a', "oo......."},
    {'i', ".o.....o."}, {'n', "o.......o"},  // arrangements of 2 neighbours
    {'c', "o.o...o.."}, {'e', ".o.o.o..."}, {'k', "o....o.o."}, {'a', "oo.o....."},
    {'i', "ooo......"}, {'n', "o.o..o..."}, {'y', "o.o....o."}, {'q', "oo......o"},
    {'j', "oo...o..."}, {'r', "oo.....o."},  // arrangements of 3 neighbours
    {'c', "o.o...o.o"}, {'e', ".o.o.o.o."}, {'k', "o.oo...o."}, {'a', "ooo..o..."},
    {'i', "o.oo.o..."}, {'n', "ooo...o.."}, {'y', "o.o..oo.."}, {'q', "oo.o....o"},
    {'j', "oo...o.o."}, {'r', "oo.o.o..."}, {'t', "ooo....o."}, {'w', "oo...o..o"},
    {'z', "oo.....oo"},  // arrangements of 4 neighbours
};
constexpr unsigned middleBit = 1U << 4, allBits = 0x1EFU;

unsigned turnedCells(unsigned cells) {
  unsigned result = 0;
  for (unsigned y = 0; y < 3; ++y)
    for (unsigned x = 0; x < 3; ++x)
      if ((cells >> (y * 3 + x) & 1U) != 0) result |= 1U << (x * 3 + 2 - y);
  return result;
}

unsigned mirroredCells(unsigned cells) {
  unsigned result = 0;
  for (unsigned y = 0; y < 3; ++y)
    for (unsigned x = 0; x < 3; ++x)
      if ((cells >> (y * 3 + x) & 1U) != 0) result |= 1U << (y * 3 + 2 - x);
  return result;
}

struct ArrangementTable {
  std::array<std::int8_t, 512> letter{};
  std::array<int, 9> letters{};

  ArrangementTable() {
    letter.fill(0);
    letters[0] = letters[8] = 1;
    for (const Sample& sample : samples) {
      unsigned cells = 0;
      for (unsigned i = 0; i < 9; ++i)
        if (sample.cells[i] == 'o') cells |= 1U << i;
      const auto which = static_cast<std::int8_t>(arrangementLetters.find(sample.letter));
      const int count = std::popcount(cells);
      letters[static_cast<std::size_t>(count)] |= 1 << which;
      letters[static_cast<std::size_t>(8 - count)] |= 1 << which;
      for (int turn = 0; turn < 8; ++turn) {
        letter[cells] = which;
        if (count < 4) letter[allBits & ~cells] = which;
        cells = turn == 3 ? mirroredCells(cells) : turnedCells(cells);
      }
    }
  }
};

const ArrangementTable& arrangementTable() {
  static const ArrangementTable all;
  return all;
}

std::string lettersText(int letters) {
  std::string result;
  for (char c = 'a'; c <= 'z'; ++c)
    if (const auto i = arrangementLetters.find(c); i != std::string_view::npos && (letters >> i & 1) != 0)
      result += c;
  return result;
}

}  // namespace

int lettersOf(int count) {
  return arrangementTable().letters[static_cast<std::size_t>(count)];
}

Arrangement arrangementOf(unsigned neighbourhood) {
  const unsigned around = neighbourhood & ~middleBit & 0x1FFU;
  return {std::popcount(around), arrangementTable().letter[around]};
}

std::string arrangementText(int count, int letters) {
  if (letters == 0) return {};
  const int all = lettersOf(count);
  std::string result(1, static_cast<char>('0' + count));
  if (letters == all) return result;
  const std::string with = lettersText(letters), without = lettersText(all & ~letters);
  return with.size() <= without.size() + 1 ? result + with : result + "-" + without;
}

}  // namespace simreel::sim
