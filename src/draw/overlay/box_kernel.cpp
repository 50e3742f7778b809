#include "draw/overlay/box_kernel.hpp"

#include "gl/element_array.hpp"

#include <algorithm>
#include <cstddef>

#include <glm/common.hpp>

namespace simreel::draw {

struct PaintBoxes {
  static constexpr auto file = "draw/overlay/boxes.comp";
  gl::In<"boxes"> boxes;
  gl::Out<"target"> target;
  gl::Uniform<"first", int> first;
  gl::Uniform<"count", int> count;
};

namespace {

constexpr int pieceSide = 16;  // max side of a piece in pixels

struct Box {
  glm::ivec4 at;  // edges in pixels: left, top, right, bottom
  glm::vec4 color;
  int layer = 0;
};

bool overlap(const glm::ivec4& a, const glm::ivec4& b) {
  return a.x < b.z && b.x < a.z && a.y < b.w && b.y < a.w;
}

std::vector<Box> layered(const std::vector<glm::vec4>& boxes, glm::ivec2 picture) {
  std::vector<Box> found;
  for (std::size_t i = 0; i + 1 < boxes.size(); i += 2) {
    Box box{glm::clamp(glm::ivec4(boxes[i]), glm::ivec4(0), glm::ivec4(picture, picture)), boxes[i + 1]};
    if (box.at.x >= box.at.z || box.at.y >= box.at.w) continue;
    // Puts the rectangle into a layer above all rectangles that it overlaps. If the overlapped rectangle
    // has the same colour, both may be in one layer.
    for (const Box& below : found)
      if (overlap(box.at, below.at))
        box.layer = std::max(box.layer, below.layer + (below.color == box.color ? 0 : 1));
    found.push_back(box);
  }
  return found;
}

}  // namespace

BoxLayers boxLayers(const std::vector<glm::vec4>& boxes, glm::ivec2 picture) {
  const std::vector<Box> all = layered(boxes, picture);
  int top = -1;
  for (const Box& box : all) top = std::max(top, box.layer);
  BoxLayers result;
  for (int layer = 0; layer <= top; ++layer) {
    for (const Box& box : all) {
      if (box.layer != layer) continue;
      for (int y = box.at.y; y < box.at.w; y += pieceSide)
        for (int x = box.at.x; x < box.at.z; x += pieceSide) {
          result.boxes.emplace_back(x, y, std::min(x + pieceSide, box.at.z),
                                    std::min(y + pieceSide, box.at.w));
          result.boxes.push_back(box.color);
        }
    }
    result.ends.push_back(static_cast<int>(result.boxes.size() / 2));
  }
  return result;
}

void BoxList::paint(const std::vector<glm::vec4>& boxes, const gl::Texture& target) {
  if (!kernel_) kernel_ = gl::Kernel<PaintBoxes>(gl::Defines());
  if (boxes != present_) {
    layers_ = boxLayers(boxes, {target.width(), target.height()});
    present_ = boxes;
    if (layers_.boxes.empty()) return;
    buffer_ = gl::Buffer::of<glm::vec4>("boxes", layers_.boxes);
    view_ = gl::Texture::view("boxes", GL_RGBA32F, buffer_);
  }
  if (layers_.boxes.empty()) return;
  int first = 0;
  for (const int end : layers_.ends) {
    const int count = end - first;
    kernel_.dispatch(count, {.boxes = view_, .target = target, .first = first, .count = count});
    first = end;
  }
}

void imageBarrier() {
  gl::barrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace simreel::draw
