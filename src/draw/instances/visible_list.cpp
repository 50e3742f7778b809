#include "draw/instances/visible_list.hpp"

#include "gl/element_array.hpp"

#include <algorithm>
#include <vector>

namespace simreel::draw {

namespace {

constexpr int levelLimit = 5;

}  // namespace

struct CullInstances {
  static constexpr auto file = "draw/instances/cull_instances.comp";
  struct Variant {
    gl::Flag<"FOR_LIGHT"> forLight;
    gl::Flag<"FOR_LAMPS"> forLamps;
    gl::Range<"LEVELS", 1, levelLimit> levels;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"light"> sunPlace = {};
  gl::Ambient<"LampBlock"> lampBlock = {};
  gl::Ambient<"lampMembers"> lamps = {};
  SightFields sight;
  gl::Out<"MaskBlock"> masks;
  gl::Uniform<"capacity", int> capacity;
  gl::Uniform<"words", int> words;
};

struct CountVisible {
  static constexpr auto file = "draw/instances/count_visible.comp";
  gl::In<"masks"> masks;
  gl::Out<"BeforeBlock"> before;
  gl::Out<"BlockBlock"> blockCount;
  gl::Uniform<"blocks", int> blocks;
};

struct TotalVisible {
  static constexpr auto file = "draw/instances/total_visible.comp";
  struct Variant {
    gl::Range<"LEVELS", 1, levelLimit> levels;
  };
  gl::In<"blockCount"> blockCount;
  gl::Out<"FirstBlock"> blockFirst;
  gl::Out<"ArgumentBlock"> arguments;
  gl::Uniform<"blocks", int> blocks;
  gl::Uniforms<"indices", glm::ivec2, levelLimit> indices;
  gl::Uniforms<"batch", int, levelLimit> batch;
};

struct ListVisible {
  static constexpr auto file = "draw/instances/list_visible.comp";
  gl::In<"masks"> masks;
  gl::In<"before"> before;
  gl::In<"blockFirst"> blockFirst;
  gl::Out<"ListBlock"> list;
  gl::Uniform<"allWords", int> allWords;
  gl::Uniform<"words", int> words;
};

namespace {

constexpr int slotsPerWord = 32;
constexpr int wordsPerBlock = 64;

}  // namespace

CullKernels::CullKernels(const gl::Defines& lampDefines)
    : cull(lampDefines), count(gl::Defines()), list(gl::Defines()) {}

VisibleList::Words::Words(const char* label, int count)
    : buffer(label, static_cast<std::size_t>(count) * 4),
      view(gl::Texture::view(label, GL_R32UI, buffer, 4)) {}

VisibleList::VisibleList(int capacity, int levels)
    : capacity_(capacity),
      levels_(levels),
      words_(std::max(1, (capacity + slotsPerWord * wordsPerBlock - 1) / (slotsPerWord * wordsPerBlock)) *
             wordsPerBlock),
      masks_("instances in sight", levels * words_),
      before_("instances before", levels * words_),
      blockCount_("instances of blocks", levels * words_ / wordsPerBlock),
      blockFirst_("instances before blocks", levels * words_ / wordsPerBlock),
      list_("visible instances", std::max(capacity, 1)),
      arguments_("instance arguments", levels * argumentBytes / 4) {}

void VisibleList::fill(CullKernels& kernels, Viewer viewer, const SightFields& sight,
                       const InstanceShape& shape) const {
  const int allWords = levels_ * words_;
  const int blocks = allWords / wordsPerBlock;
  kernels.cull
      .of({.forLight = viewer == Viewer::sun, .forLamps = viewer == Viewer::lamps, .levels = levels_})
      .dispatch(words_, {.sight = sight, .masks = masks_.buffer, .capacity = capacity_, .words = words_});
  kernels.count.dispatch(
      blocks,
      {.masks = masks_.view, .before = before_.buffer, .blockCount = blockCount_.buffer, .blocks = blocks});
  std::vector<glm::ivec2> indices;
  std::vector<int> batches;
  for (const InstanceShape::Level& level : shape.levels()) {
    indices.emplace_back(level.firstIndex, level.indexCount);
    batches.push_back(level.batch);
  }
  kernels.total.of({.levels = levels_})
      .dispatch(1, {.blockCount = blockCount_.view,
                    .blockFirst = blockFirst_.buffer,
                    .arguments = arguments_.buffer,
                    .blocks = blocks,
                    .indices = indices,
                    .batch = batches});
  kernels.list.dispatch(allWords, {.masks = masks_.view,
                                   .before = before_.view,
                                   .blockFirst = blockFirst_.view,
                                   .list = list_.buffer,
                                   .allWords = allWords,
                                   .words = words_});
  gl::barrier(GL_COMMAND_BARRIER_BIT);
}

ListFields VisibleList::fields(int level) const {
  return {.list = list_.view, .arguments = arguments_.view, .level = level};
}

void VisibleList::bind() const {
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, arguments_.buffer.name());
}

}  // namespace simreel::draw
