#include "golden/suite/check_values.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::golden;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float notNumber = std::numeric_limits<float>::quiet_NaN();

frame::Image picture(std::vector<std::uint8_t> grey) {
  frame::Image image{static_cast<int>(grey.size()), 1, {}};
  for (const std::uint8_t level : grey) image.bytes.insert(image.bytes.end(), {level, level, level, 255});
  return image;
}

}  // namespace

TEST_CASE("statistics of a component are right") {
  const std::vector<glm::vec4> items = {{3, 1, 0, 2}, {0, -5, 12, 4}, {3, 2.5F, 4, 9}};
  CHECK(statistic(Statistic::sum, Component::x, items) == 6);
  CHECK(statistic(Statistic::mean, Component::w, items) == 5);
  CHECK(statistic(Statistic::min, Component::y, items) == -5);
  CHECK(statistic(Statistic::max, Component::y, items) == 2.5);
  CHECK(statistic(Statistic::max, Component::z, items) == 12);
  CHECK(statistic(Statistic::max, Component::length, items) == 13);  // The component w is ignored.
  CHECK(statistic(Statistic::sum, Component::x, {}) == 0);
  CHECK(std::isnan(statistic(Statistic::max, Component::x, {})));
}

TEST_CASE("a NaN in the component of any element makes the statistic NaN") {
  for (const Statistic which : {Statistic::mean, Statistic::min, Statistic::max, Statistic::sum})
    for (std::size_t at = 0; at < 3; ++at) {
      std::vector<glm::vec4> items(3, glm::vec4(1));
      items[at].y = notNumber;
      CHECK(std::isnan(statistic(which, Component::y, items)));
      CHECK(statistic(which, Component::z, items) == (which == Statistic::sum ? 3 : 1));
    }
}

TEST_CASE("component names are parsed") {
  CHECK(componentOf("x") == Component::x);
  CHECK(componentOf("w") == Component::w);
  CHECK(componentOf("length") == Component::length);
  for (const char* word : {"", "xy", "q", "len", "X"}) CHECK(!componentOf(word));
}

TEST_CASE("NaN and infinity are detected by their bits") {
  std::vector<glm::vec4> items(4, glm::vec4(std::numeric_limits<float>::max()));
  items[0].x = std::numeric_limits<float>::denorm_min();
  CHECK(findNotFinite(items).count == 0);
  items[2].z = -infinity;
  items[3].w = notNumber;
  const NotFinite found = findNotFinite(items);
  CHECK(found.count == 2);
  CHECK(found.element == 2);
  CHECK(found.component == 2);
}

TEST_CASE("the contrast of pictures is the standard deviation of luma") {
  const Contrast flat = contrastOf(picture({90, 90, 90, 90}));
  CHECK(flat.oneColour);
  CHECK(flat.lumaDeviation == doctest::Approx(0).epsilon(1e-12));
  // The picture has two levels, each in half of the pixels, so the deviation is half their difference.
  const Contrast two = contrastOf(picture({100, 102, 100, 102}));
  CHECK(!two.oneColour);
  CHECK(two.lumaDeviation == doctest::Approx(1.0 / 255).epsilon(1e-9));
  CHECK(contrastOf(picture({0, 255})).lumaDeviation == doctest::Approx(0.5).epsilon(1e-9));
  frame::Image green = picture({0, 0});
  green.bytes[1] = 255;
  CHECK(contrastOf(green).lumaDeviation == doctest::Approx(0.3576).epsilon(1e-9));
  frame::Image alpha = picture({7, 7});
  alpha.bytes[3] = 0;  // Differences in alpha are ignored.
  CHECK(contrastOf(alpha).oneColour);
}
