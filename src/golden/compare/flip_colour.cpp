#include "golden/compare/flip_colour.hpp"

#include "base/srgb.hpp"
#include "golden/compare/four.hpp"

#include <algorithm>
#include <array>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace simreel::golden {

namespace {

/// Returns the matrix from linear RGB to XYZ relative to white. Its rows are those of the sRGB matrix
/// (exact fractions from the primaries' chromaticities), each divided by its sum. The matrix is transposed
/// for GLM, which is column-major.
glm::dmat3 relativeXyz() {
  const glm::dvec3 x(10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794);
  const glm::dvec3 y(2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897);
  const glm::dvec3 z(1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382);
  const auto relative = [](const glm::dvec3& row) { return row / (row.x + row.y + row.z); };
  return glm::transpose(glm::dmat3(relative(x), relative(y), relative(z)));
}

/// A row-major 3x3 matrix, applied to four pixels at a time.
struct Matrix {
  explicit Matrix(const glm::dmat3& m) {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        of[std::size_t(row) * 3 + std::size_t(column)] = static_cast<float>(m[column][row]);
  }
  [[nodiscard]] std::array<Four, 3> operator()(Four x, Four y, Four z) const {
    return {of[0] * x + of[1] * y + of[2] * z, of[3] * x + of[4] * y + of[5] * z,
            of[6] * x + of[7] * y + of[8] * z};
  }

  std::array<float, 9> of{};
};
const Matrix xyzOfRgb{relativeXyz()}, rgbOfXyz{glm::inverse(relativeXyz())};

std::array<float, 256> linearTable() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<float>(linearOfSrgb(static_cast<double>(i) / 255));
  return table;
}
const std::array<float, 256> linearOf = linearTable();

Four unit(Four value) {
  return smaller(larger(value, Four{}), Four{} + 1);
}

/// Returns the CIELAB function f(t), which is a cube root, and linear near 0.
Four labRoot(Four t) {
  constexpr float delta = 6.0f / 29, knee = delta * delta * delta;
  const Four line = t * (1 / (3 * delta * delta)) + 4.0f / 29, root = cubeRoot(larger(t, Four{} + knee));
  return t > knee ? root : line;
}

/// Returns the HyAB distance |dL| + sqrt(da^2 + db^2) to the power of qc = 0.7.
Four poweredHyab(Four dl, Four da, Four db) {
  return powerOf(magnitude(dl) + squareRoot(da * da + db * db), Four{} + 0.7f);
}

/// Returns the largest possible error, which is between green and blue.
float largestError() {
  std::array<float, 4> red{}, green{1}, blue{0, 1}, y{}, cx{}, cz{}, l{}, a{}, b{};
  toYcxcz({red.data(), green.data(), blue.data()}, 2, {y.data(), cx.data(), cz.data()});
  toHuntLab({y.data(), cx.data(), cz.data()}, 2, {l.data(), a.data(), b.data()});
  return poweredHyab(Four{} + (l[0] - l[1]), Four{} + (a[0] - a[1]), Four{} + (b[0] - b[1]))[0];
}

}  // namespace

void toLinear(const std::uint8_t* rgba, const std::ptrdiff_t* offsets, int count, const ThreeRows& rgb) {
  for (int i = 0; i < count; ++i) {
    const std::uint8_t* pixel = rgba + offsets[i];
    rgb.first[i] = linearOf[pixel[0]];
    rgb.second[i] = linearOf[pixel[1]];
    rgb.third[i] = linearOf[pixel[2]];
  }
}

void toYcxcz(const ThreeConstRows& rgb, int count, const ThreeRows& ycxcz) {
  const Matrix toXyz = xyzOfRgb;
  for (int i = 0; i < count; i += 4) {
    const auto [x, y, z] = toXyz(load(rgb.first + i), load(rgb.second + i), load(rgb.third + i));
    store(ycxcz.first + i, 116 * y);
    store(ycxcz.second + i, 500 * (x - y));
    store(ycxcz.third + i, 200 * (y - z));
  }
}

void toHuntLab(const ThreeConstRows& ycxcz, int count, const ThreeRows& lab) {
  const Matrix toXyz = xyzOfRgb, toRgb = rgbOfXyz;
  for (int i = 0; i < count; i += 4) {
    const Four y = load(ycxcz.first + i) * (1 / 116.0f);
    const auto [red, green, blue] =
        toRgb(y + load(ycxcz.second + i) * (1 / 500.0f), y, y - load(ycxcz.third + i) * (1 / 200.0f));
    const auto xyz = toXyz(unit(red), unit(green), unit(blue));
    const Four rootX = labRoot(xyz[0]), rootY = labRoot(xyz[1]), rootZ = labRoot(xyz[2]);
    const Four lightness = 116 * rootY - 16, hunt = 0.01f * lightness;
    store(lab.first + i, lightness);
    store(lab.second + i, hunt * 500 * (rootX - rootY));
    store(lab.third + i, hunt * 200 * (rootY - rootZ));
  }
}

void colourErrors(const ThreeConstRows& a, const ThreeConstRows& b, int count, float* errors) {
  // Errors up to the fraction pc of the largest error are mapped to 0 to pt, larger errors to pt to 1.
  constexpr float pc = 0.4f, pt = 0.95f;
  static const float largest = largestError();
  const float knee = pc * largest, below = pt / knee, above = (1 - pt) / (largest - knee);
  for (int i = 0; i < count; i += 4) {
    const Four error =
        poweredHyab(load(a.first + i) - load(b.first + i), load(a.second + i) - load(b.second + i),
                    load(a.third + i) - load(b.third + i));
    const Four low = below * error, high = pt + (error - knee) * above;
    store(errors + i, error < knee ? low : high);
  }
}

}  // namespace simreel::golden
