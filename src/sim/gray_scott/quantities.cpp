#include "sim/gray_scott/quantities.hpp"

#include "sim/gray_scott/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace simreel::sim {

namespace {

using Complex = std::complex<double>;

constexpr int maxSide = 384;

/// Minimum peak of v that counts as a pattern. Smaller peaks are remains of the seeds.
constexpr float minPattern = 0.05F;

/// Returns e^(-2 pi i k / count) for k = 0 to count - 1.
std::vector<Complex> roots(int count) {
  std::vector<Complex> r;
  r.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) r.push_back(std::polar(1.0, -2 * std::numbers::pi * k / count));
  return r;
}

/// Returns the means of blocks of factor x factor cells, minus the overall mean. Incomplete blocks at the
/// far edges are dropped.
std::vector<double> averaged(std::span<const float> values, glm::ivec2 size, int factor) {
  const int width = size.x / factor;
  const int height = size.y / factor;
  const auto smallIndex = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  std::vector<double> small(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height * factor; ++y)
    for (int x = 0; x < width * factor; ++x)
      small[smallIndex(x / factor, y / factor)] +=
          values[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                 static_cast<std::size_t>(x)];
  const double mean = std::accumulate(small.begin(), small.end(), 0.0) / static_cast<double>(small.size());
  for (double& s : small) s = (s - mean) / (factor * factor);
  return small;
}

struct Ring {
  double power = 0;
  double moment = 0;  ///< Product of power and spatial frequency (cycles per cell).
};

/// Returns the power spectrum summed over rings of wave numbers, computed by a discrete Fourier transform
/// along rows, then along columns. Ring i is at i / side cycles per (averaged) cell, where side is the
/// longer side.
std::vector<Ring> ringPower(const std::vector<double>& field, glm::ivec2 size) {
  const std::vector<Complex> rootX = roots(size.x);
  const std::vector<Complex> rootY = roots(size.y);
  const int side = std::max(size.x, size.y);
  std::vector<Ring> rings(static_cast<std::size_t>(side));
  std::vector<Complex> column(static_cast<std::size_t>(size.y));
  for (int kx = 0; kx <= size.x / 2; ++kx) {
    for (int y = 0; y < size.y; ++y) {
      Complex sum = 0;
      for (int x = 0, turn = 0; x < size.x; ++x, turn = (turn + kx) % size.x)
        sum += field[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                     static_cast<std::size_t>(x)] *
               rootX[static_cast<std::size_t>(turn)];
      column[static_cast<std::size_t>(y)] = sum;
    }
    for (int ky = 0; ky < size.y; ++ky) {
      Complex sum = 0;
      for (int y = 0, turn = 0; y < size.y; ++y, turn = (turn + ky) % size.y)
        sum += column[static_cast<std::size_t>(y)] * rootY[static_cast<std::size_t>(turn)];
      const double fx = static_cast<double>(kx) / size.x;
      const double fy = static_cast<double>(std::min(ky, size.y - ky)) / size.y;
      const double frequency = std::sqrt(fx * fx + fy * fy);
      const auto ring = static_cast<std::size_t>(std::lround(frequency * side));
      if (ring >= rings.size()) continue;
      rings[ring].power += std::norm(sum);
      rings[ring].moment += std::norm(sum) * frequency;
    }
  }
  return rings;
}

}  // namespace

double dominantWavelength(std::span<const float> values, glm::ivec2 size) {
  const int factor = (std::max(size.x, size.y) + maxSide - 1) / maxSide;
  const glm::ivec2 small = size / factor;
  if (std::min(small.x, small.y) < 2) return 0;
  const std::vector<Ring> rings = ringPower(averaged(values, size, factor), small);
  std::size_t best = 1;
  for (std::size_t i = 1; i < rings.size(); ++i)
    if (rings[i].power > rings[best].power) best = i;
  double power = 0;
  double moment = 0;
  for (std::size_t i = best > 2 ? best - 2 : 1; i <= std::min(best + 2, rings.size() - 1); ++i) {
    power += rings[i].power;
    moment += rings[i].moment;
  }
  if (power < 1e-12) return 0;
  return factor * power / moment;
}

Patches patchesOf(const std::vector<char>& inside, glm::ivec2 size) {
  std::vector<char> open = inside;
  std::vector<int> queue;
  Patches patches;
  for (std::size_t start = 0; start < open.size(); ++start) {
    if (open[start] == 0) continue;
    ++patches.count;
    queue.assign(1, static_cast<int>(start));
    open[start] = 0;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const int x = queue[next] % size.x;
      const int y = queue[next] / size.x;
      const int around[] = {y * size.x + (x + 1) % size.x, y * size.x + (x + size.x - 1) % size.x,
                            (y + 1) % size.y * size.x + x, (y + size.y - 1) % size.y * size.x + x};
      for (const int i : around)
        if (open[static_cast<std::size_t>(i)] != 0) {
          open[static_cast<std::size_t>(i)] = 0;
          queue.push_back(i);
        }
    }
    patches.largest = std::max(patches.largest, static_cast<int>(queue.size()));
  }
  return patches;
}

std::span<const scene::Quantity> GrayScottParameters::quantities() const {
  static const scene::Quantity table[] = {
      {"meanU", "", "Mean of u."},
      {"meanV", "", "Mean of v."},
      {"mostV", "", "Greatest v."},
      {"coverage", "", "Fraction of cells with v above half the greatest."},
      {"spots", "", "Patches of such cells, joined over edges."},
      {"largestSpot", "", "Fraction of cells in the largest patch."},
      {"holes", "", "Patches of the other cells."},
      {"wavelength", "cells", "Wavelength that holds most of the variance of v."}};
  return table;
}

std::vector<double> measureGrayScott(std::span<const glm::vec4> cells, glm::ivec2 size) {
  const int columns = (size.x + 1) / 2;
  double sumU = 0;
  double sumV = 0;
  std::vector<float> v;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::vec4& pair = cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                                    static_cast<std::size_t>(x / 2)];
      sumU += x % 2 == 0 ? pair.x : pair.z;
      v.push_back(x % 2 == 0 ? pair.y : pair.w);
      sumV += v.back();
    }
  const float max = *std::max_element(v.begin(), v.end());
  std::vector<char> inside(v.size());
  std::vector<char> outside(v.size());
  double covered = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    inside[i] = static_cast<char>(max >= minPattern && v[i] > max / 2);
    outside[i] = static_cast<char>(inside[i] == 0);
    covered += inside[i];
  }
  const Patches spots = patchesOf(inside, size);
  const auto cellCount = static_cast<double>(v.size());
  return {sumU / cellCount,
          sumV / cellCount,
          max,
          covered / cellCount,
          static_cast<double>(spots.count),
          spots.largest / cellCount,
          static_cast<double>(patchesOf(outside, size).count),
          max < minPattern ? 0 : dominantWavelength(v, size)};
}

}  // namespace simreel::sim
