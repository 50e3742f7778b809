// Tests that rectangles are sorted into layers. Within a layer, any order must give the same picture.
#include "draw/overlay/box_kernel.hpp"

#include <algorithm>
#include <random>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

void fill(std::vector<glm::vec4>& picture, glm::ivec2 size, glm::ivec4 box, const glm::vec4& color) {
  for (int y = std::max(box.y, 0); y < std::min(box.w, size.y); ++y)
    for (int x = std::max(box.x, 0); x < std::min(box.z, size.x); ++x)
      picture[static_cast<std::size_t>(y * size.x + x)] = color;
}

}  // namespace

TEST_CASE("boxes: painting layer by layer, in any order within a layer, equals painting in order") {
  std::minstd_rand random(3);
  const glm::ivec2 size(61, 47);
  for (int round = 0; round < 40; ++round) {
    std::vector<glm::vec4> boxes;
    for (int i = 0; i < 30; ++i) {
      const auto at = [&](int to) {
        return static_cast<float>(static_cast<int>(random() % static_cast<unsigned>(to)) - 9);
      };
      const float x = at(size.x + 9), y = at(size.y + 9);
      boxes.emplace_back(x, y, x + at(40), y + at(30));  // Some of the random boxes are empty.
      boxes.emplace_back(static_cast<float>(random() % 3), 0, 0, 1);
    }
    std::vector<glm::vec4> wanted(static_cast<std::size_t>(size.x * size.y), glm::vec4(-1));
    auto found = wanted;
    for (std::size_t i = 0; i < boxes.size(); i += 2)
      fill(wanted, size, glm::ivec4(boxes[i]), boxes[i + 1]);
    const draw::BoxLayers layers = draw::boxLayers(boxes, size);
    std::size_t first = 0;
    for (const int end : layers.ends) {
      for (auto i = static_cast<std::size_t>(end);
           i-- > first;) {  // Fills the boxes of a layer in reverse order.
        const glm::ivec4 box(layers.boxes[2 * i]);
        CHECK(std::min({box.x, box.y, size.x - box.z, size.y - box.w}) >= 0);
        CHECK(std::max(box.z - box.x, box.w - box.y) <= 16);
        fill(found, size, box, layers.boxes[2 * i + 1]);
      }
      first = static_cast<std::size_t>(end);
    }
    CHECK(first * 2 == layers.boxes.size());
    CHECK(found == wanted);
  }
}
