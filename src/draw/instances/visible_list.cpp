#include "draw/instances/visible_list.hpp"

#include "draw/draw_state.hpp"

#include <algorithm>
#include <string>

namespace simreel::draw {

namespace {

constexpr int slotsPerWord = 32;
constexpr int wordsPerBlock = 64;

void barrier() {
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

}  // namespace

CullPrograms::CullPrograms(const gl::Defines& sight, int levels) {
  gl::Defines defines = {{"LEVELS", std::to_string(levels)}};
  total = gl::Program::compute("draw/instances/total_visible.comp", defines);
  defines.insert(defines.end(), sight.begin(), sight.end());
  cull = gl::Program::compute("draw/instances/cull_instances.comp", defines);
  count = gl::Program::compute("draw/instances/count_visible.comp");
  list = gl::Program::compute("draw/instances/list_visible.comp");
}

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

void VisibleList::fill(const CullPrograms& programs, const InstanceShape& shape) const {
  const int allWords = levels_ * words_;
  const int blocks = allWords / wordsPerBlock;
  programs.cull.set("capacity", capacity_);
  programs.cull.set("words", words_);
  masks_.buffer.bindStorage(maskBinding);
  programs.cull.dispatch(words_);
  barrier();
  programs.count.set("blocks", blocks);
  masks_.view.bind(maskUnit);
  before_.buffer.bindStorage(beforeBinding);
  blockCount_.buffer.bindStorage(blockCountBinding);
  programs.count.dispatch(blocks);
  barrier();
  programs.total.set("blocks", blocks);
  for (int level = 0; level < levels_; ++level) {
    const auto& part = shape.levels()[static_cast<std::size_t>(level)];
    const std::string at = "[" + std::to_string(level) + "]";
    programs.total.set(("indices" + at).c_str(), glm::ivec2(part.firstIndex, part.indexCount));
    programs.total.set(("batch" + at).c_str(), part.batch);
  }
  blockCount_.view.bind(blockCountUnit);
  blockFirst_.buffer.bindStorage(blockFirstBinding);
  arguments_.buffer.bindStorage(argumentBinding);
  programs.total.dispatch(1);
  barrier();
  programs.list.set("allWords", allWords);
  programs.list.set("words", words_);
  masks_.view.bind(maskUnit);
  before_.view.bind(beforeUnit);
  blockFirst_.view.bind(blockFirstUnit);
  list_.buffer.bindStorage(listBinding);
  programs.list.dispatch(allWords);
  barrier();
}

void VisibleList::bind() const {
  list_.view.bind(listUnit);
  arguments_.view.bind(argumentUnit);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, arguments_.buffer.name());
}

}  // namespace simreel::draw
