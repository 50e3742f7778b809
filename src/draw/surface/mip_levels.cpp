#include "draw/surface/mip_levels.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace simreel::draw {

namespace {

/// Linear light of each sRGB byte (IEC 61966-2-1), rounded to 1/65535. Stored as a table, because the pow()
/// of libraries may round differently.
constexpr std::array<std::uint16_t, 256> linearTable = {
    0,     20,    40,    60,    80,    99,    119,   139,   159,   179,   199,   219,   241,   264,   288,
    313,   340,   367,   396,   427,   458,   491,   526,   562,   599,   637,   677,   718,   761,   805,
    851,   898,   947,   997,   1048,  1101,  1156,  1212,  1270,  1330,  1391,  1453,  1517,  1583,  1651,
    1720,  1790,  1863,  1937,  2013,  2090,  2170,  2250,  2333,  2418,  2504,  2592,  2681,  2773,  2866,
    2961,  3058,  3157,  3258,  3360,  3464,  3570,  3678,  3788,  3900,  4014,  4129,  4247,  4366,  4488,
    4611,  4736,  4864,  4993,  5124,  5257,  5392,  5530,  5669,  5810,  5953,  6099,  6246,  6395,  6547,
    6700,  6856,  7014,  7174,  7335,  7500,  7666,  7834,  8004,  8177,  8352,  8528,  8708,  8889,  9072,
    9258,  9445,  9635,  9828,  10022, 10219, 10417, 10619, 10822, 11028, 11235, 11446, 11658, 11873, 12090,
    12309, 12530, 12754, 12980, 13209, 13440, 13673, 13909, 14146, 14387, 14629, 14874, 15122, 15371, 15623,
    15878, 16135, 16394, 16656, 16920, 17187, 17456, 17727, 18001, 18277, 18556, 18837, 19121, 19407, 19696,
    19987, 20281, 20577, 20876, 21177, 21481, 21787, 22096, 22407, 22721, 23038, 23357, 23678, 24002, 24329,
    24658, 24990, 25325, 25662, 26001, 26344, 26688, 27036, 27386, 27739, 28094, 28452, 28813, 29176, 29542,
    29911, 30282, 30656, 31033, 31412, 31794, 32179, 32567, 32957, 33350, 33745, 34143, 34544, 34948, 35355,
    35764, 36176, 36591, 37008, 37429, 37852, 38278, 38706, 39138, 39572, 40009, 40449, 40891, 41337, 41785,
    42236, 42690, 43147, 43606, 44069, 44534, 45002, 45473, 45947, 46423, 46903, 47385, 47871, 48359, 48850,
    49344, 49841, 50341, 50844, 51349, 51858, 52369, 52884, 53401, 53921, 54445, 54971, 55500, 56032, 56567,
    57105, 57646, 58190, 58737, 59287, 59840, 60396, 60955, 61517, 62082, 62650, 63221, 63795, 64372, 64952,
    65535};

/// A texel in linear light with its weight. The weight is 255 times the alpha byte plus 1. Transparent
/// texels have almost no weight, but determine the colour of fully transparent areas.
struct Weighted {
  std::uint32_t r, g, b;  ///< linear light (units of 1/65535) multiplied by the weight
  std::uint32_t weight;   ///< weight of the texel in units of 1/256
};

constexpr std::uint32_t opaqueWeight = 256 * (255 * 255 + 1);

Weighted weightedOf(const std::uint8_t* texel) {
  const std::uint32_t weight = 255U * texel[3] + 1;
  return {linearTable[texel[0]] * weight, linearTable[texel[1]] * weight, linearTable[texel[2]] * weight,
          256 * weight};
}

/// Converts linear light to the nearest sRGB byte. If two bytes are equally near, returns the larger one.
class Encoder {
 public:
  Encoder() {
    for (std::size_t i = 0; i < 255; ++i) ends_[i] = 128U * (linearTable[i] + linearTable[i + 1]);
    ends_[255] = ~std::uint32_t{0};
    std::size_t byte = 0;
    for (std::uint32_t i = 0; i < starts_.size(); ++i) {
      while (ends_[byte] <= i << bucketBits) ++byte;
      starts_[i] = static_cast<std::uint8_t>(byte);
    }
  }
  /// Returns the byte for a light value in units of 1/(65535 * 256).
  [[nodiscard]] std::uint8_t byteOf(std::uint32_t light) const {
    // Each bucket contains at most one boundary between two bytes.
    const std::uint8_t byte = starts_[light >> bucketBits];
    return light < ends_[byte] ? byte : static_cast<std::uint8_t>(byte + 1);
  }
  void encode(const Weighted& from, std::uint8_t* texel) const {
    // Rounding may raise a weighted mean slightly above white, so the mean is limited.
    const auto light = [](std::uint32_t color, std::uint32_t weight) {
      return static_cast<std::uint32_t>(
          std::min<std::uint64_t>((std::uint64_t{color} << 16U) / weight, 65535U * 256U));
    };
    // Opaque texels, the most common case, have a separate path, in which the compiler replaces the
    // division by a constant with a multiplication.
    const auto encodeColor = [&](std::uint32_t weight) {
      texel[0] = byteOf(light(from.r, weight));
      texel[1] = byteOf(light(from.g, weight));
      texel[2] = byteOf(light(from.b, weight));
    };
    if (from.weight == opaqueWeight)
      encodeColor(opaqueWeight);
    else
      encodeColor(from.weight);
    texel[3] = static_cast<std::uint8_t>((from.weight - 256 + 255 * 128) / (255 * 256));
  }

 private:
  static constexpr unsigned bucketBits = 12;
  std::array<std::uint32_t, 256> ends_{};
  std::array<std::uint8_t, (65535U * 256U >> bucketBits) + 1> starts_{};
};

/// Texels of the level above that one texel covers along one axis, with their weights.
struct Cover {
  int first;
  std::array<std::uint32_t, 3> weights;
};

/// If the level above has 2n texels, each of the n texels covers two of them. If the level above has 2n + 1
/// texels, each texel covers (2n + 1) / n of them. Texel i then covers three texels: (n - i) / n of the
/// first, all of the second, and (i + 1) / n of the third. Weights are in units of 1/n.
Cover coverOf(int i, int above) {
  if (above == 1) return {0, {1, 0, 0}};
  if (above % 2 == 0) return {2 * i, {1, 1, 0}};
  const int n = above / 2;
  return {2 * i,
          {static_cast<std::uint32_t>(n - i), static_cast<std::uint32_t>(n),
           static_cast<std::uint32_t>(i + 1)}};
}
int coveredTexels(int above) {
  return above == 1 ? 1 : above % 2 == 0 ? 2 : 3;
}
/// Returns the sum of the weights of a Cover.
std::uint64_t coverSum(int above) {
  return above % 2 == 0 ? 2U : static_cast<std::uint64_t>(above);
}

struct Sum {
  std::uint64_t r = 0, g = 0, b = 0, weight = 0;
};

/// Computes one row of a level. The row covers `Down` rows of the level above. Each texel covers `Across`
/// texels in each of these rows.
template <int Across, int Down>
void averageRow(const std::array<const Weighted*, 3>& rows, const Cover& down, int above, int width,
                std::uint64_t fractions, Weighted* made) {
  // Most pictures have even sides. In this case the divisor is the constant 4, and the compiler uses a
  // shift.
  const std::uint64_t total = Across == 2 && Down == 2 ? 4 : fractions;
  for (int x = 0; x < width; ++x) {
    const Cover across = coverOf(x, above);
    Sum sum;
    for (std::size_t j = 0; j < Down; ++j)
      for (std::size_t i = 0; i < Across; ++i) {
        const Weighted& texel = rows[j][static_cast<std::size_t>(across.first) + i];
        const std::uint64_t fraction = std::uint64_t{across.weights[i]} * down.weights[j];
        sum.r += fraction * texel.r;
        sum.g += fraction * texel.g;
        sum.b += fraction * texel.b;
        sum.weight += fraction * texel.weight;
      }
    const auto mean = [&](std::uint64_t of) {
      return static_cast<std::uint32_t>((of + total / 2) / total);
    };
    made[x] = {mean(sum.r), mean(sum.g), mean(sum.b), mean(sum.weight)};
  }
}

using AverageRow = void (*)(const std::array<const Weighted*, 3>&, const Cover&, int, int, std::uint64_t,
                            Weighted*);
constexpr AverageRow averages[3][3] = {{averageRow<1, 1>, averageRow<2, 1>, averageRow<3, 1>},
                                       {averageRow<1, 2>, averageRow<2, 2>, averageRow<3, 2>},
                                       {averageRow<1, 3>, averageRow<2, 3>, averageRow<3, 3>}};

/// The level above the computed level. It is either the original picture, which is decoded row by row, or
/// averaged texels.
struct Above {
  glm::ivec2 size;
  std::span<const std::uint8_t> picture;  ///< bytes of the picture; if empty, `texels` is used instead
  std::vector<Weighted> texels;

  /// Returns `count` rows, starting at row `first`. Decoded rows are stored in `room`.
  [[nodiscard]] std::array<const Weighted*, 3> rows(int first, int count,
                                                    std::vector<Weighted>& room) const {
    const auto width = static_cast<std::size_t>(size.x);
    const std::size_t begin = static_cast<std::size_t>(first) * width;
    std::array<const Weighted*, 3> found{};
    if (!picture.empty()) {
      room.resize(width * static_cast<std::size_t>(count));
      for (std::size_t i = 0; i < room.size(); ++i) room[i] = weightedOf(&picture[4 * (begin + i)]);
    }
    const Weighted* all = picture.empty() ? texels.data() + begin : room.data();
    for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j) found[j] = all + j * width;
    return found;
  }
};

/// Returns the next smaller level, and replaces `above` by its texels.
MipLevel levelBelow(Above& above, const Encoder& encoder) {
  MipLevel level{{std::max(above.size.x / 2, 1), std::max(above.size.y / 2, 1)}, {}};
  const auto width = static_cast<std::size_t>(level.size.x);
  std::vector<Weighted> made(width * static_cast<std::size_t>(level.size.y));
  level.rgba.resize(4 * made.size());
  const int across = coveredTexels(above.size.x);
  const int down = coveredTexels(above.size.y);
  const AverageRow average = averages[down - 1][across - 1];
  const std::uint64_t total = coverSum(above.size.x) * coverSum(above.size.y);
  tbb::parallel_for(tbb::blocked_range<int>(0, level.size.y, 16), [&](const tbb::blocked_range<int>& part) {
    std::vector<Weighted> room;
    for (int y = part.begin(); y < part.end(); ++y) {
      const Cover cover = coverOf(y, above.size.y);
      const std::size_t at = static_cast<std::size_t>(y) * width;
      average(above.rows(cover.first, down, room), cover, above.size.x, level.size.x, total, &made[at]);
      for (std::size_t x = 0; x < width; ++x) encoder.encode(made[at + x], &level.rgba[4 * (at + x)]);
    }
  });
  above = {level.size, {}, std::move(made)};
  return level;
}

}  // namespace

std::uint16_t linearOfSrgb(std::uint8_t byte) {
  return linearTable[byte];
}

std::vector<MipLevel> mipLevels(glm::ivec2 size, std::span<const std::uint8_t> rgba) {
  SIMREEL_CHECK_EQ(rgba.size(), 4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  SIMREEL_CHECK(std::max(size.x, size.y) <= 32768);
  const Encoder encoder;
  std::vector<MipLevel> levels;
  Above above{size, rgba, {}};
  while (above.size != glm::ivec2(1, 1)) levels.push_back(levelBelow(above, encoder));
  return levels;
}

}  // namespace simreel::draw
