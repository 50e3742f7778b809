#include "sim/world/summary_queue.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "gl/element_array.hpp"
#include "gl/errors.hpp"

#include <algorithm>
#include <utility>

namespace simreel::sim {

namespace {

gl::Buffer copies(const char* label, std::size_t rows) {
  return gl::Buffer::mapped(label, rows * SummaryQueue::capacity * 16, false);
}

/// Copies data out of a mapped buffer. The fence of that data must already be signalled.
void copyOut(const gl::Buffer& from, std::size_t offset, std::span<std::byte> to) {
  SIMREEL_CHECK(offset + to.size() <= from.bytes());
  const std::byte* first = static_cast<const std::byte*>(from.memory()) + offset;
  std::copy(first, first + to.size(), to.begin());
}

}  // namespace

SummaryQueue::SummaryQueue(Objects objects, std::span<const std::string> names)
    : objects_(objects), names_(names), remarked_(objects.size()) {
  for (std::size_t i = 0; i < objects_.size(); ++i)
    for (const StateArray& array : objects_[i]->state())
      arrays_.push_back({names_[i], array.name, array.elements()});
  for (std::size_t i = 0; i < objects_.size(); ++i)
    if (objects_[i]->counts().steps != nullptr) {
      counting_.push_back({i, countRowsOfSlot_});
      countRowsOfSlot_ += objects_[i]->counts().steps->bytes() / 16;
    }
  countCopies_ = copies("copies of counts", countRowsOfSlot_);
  sums_ = gl::Buffer("state hash sums", std::max<std::size_t>(1, arrays_.size()) * 16);
  sumCopies_ = copies("copies of state hash sums", arrays_.size());
  statuses_ = copies("status copies", objects_.size());
}

SummaryQueue::~SummaryQueue() {
  for (const Pending& p : pending_) glDeleteSync(p.fence);
}

std::vector<CountNames> SummaryQueue::countNames() const {
  std::vector<CountNames> names;
  for (const Counting& c : counting_) {
    CountNames& entry = names.emplace_back();
    entry.object = names_[c.object];
    const CountTable table = objects_[c.object]->counts();
    entry.elements = table.elements;
    entry.measured = table.measured;
    for (const char* column : table.columns) entry.columns.emplace_back(column);
  }
  return names;
}

void SummaryQueue::start(int frame) {
  SIMREEL_CHECK(pending_.size() < capacity);
  const int slot = nextSlot_;
  nextSlot_ = (nextSlot_ + 1) % capacity;
  const std::vector<unsigned> zero(4 * arrays_.size());
  sums_.write(0, std::as_bytes(std::span(zero)));
  gl::barrier();
  std::size_t array = 0;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    for (const StateArray& state : objects_[i]->state()) {
      hash_.add(state, array, sums_, array);
      ++array;
    }
    if (const gl::Buffer* status = objects_[i]->status()) {
      glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
      glCopyNamedBufferSubData(status->name(), statuses_.name(), 0, statusOffset(slot, i), 16);
    }
  }
  const std::vector<int> countsPerObject = copyCounts(slot);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  if (!arrays_.empty())
    glCopyNamedBufferSubData(sums_.name(), sumCopies_.name(), 0, static_cast<GLintptr>(sumOffset(slot)),
                             static_cast<GLsizeiptr>(arrays_.size()) * 16);
  pending_.push_back({frame, slot, glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0), countsPerObject});
  glFlush();
}

std::optional<Summary> SummaryQueue::next(bool wait) {
  if (pending_.empty()) return std::nullopt;
  const Pending oldest = pending_.front();
  const GLuint64 patience = wait ? GLuint64{60'000'000'000} : 0;
  GLenum result = glClientWaitSync(oldest.fence, GL_SYNC_FLUSH_COMMANDS_BIT, patience);
  while (wait && result == GL_TIMEOUT_EXPIRED) result = glClientWaitSync(oldest.fence, 0, patience);
  if (result == GL_TIMEOUT_EXPIRED) return std::nullopt;
  glDeleteSync(oldest.fence);
  pending_.pop_front();
  if (result == GL_WAIT_FAILED)
    fail(ExitCode::device, "the device stopped responding at frame {}", oldest.frame);
  checkStatus(oldest.frame, oldest.slot);
  Summary taken = summary(oldest);
  gl::checkCalls();
  return taken;
}

/// Copies the counts into a slot; returns the number of uvec4 counts (rows times elements) per counting
/// object.
std::vector<int> SummaryQueue::copyCounts(int slot) const {
  std::vector<int> rows;
  if (!counting_.empty()) glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  for (const Counting& c : counting_) {
    const CountTable table = objects_[c.object]->counts();
    glCopyNamedBufferSubData(table.steps->name(), countCopies_.name(), 0,
                             static_cast<GLintptr>(countOffset(slot, c)),
                             static_cast<GLsizeiptr>(table.rows) * table.elements * 16);
    rows.push_back(table.rows * table.elements);
  }
  return rows;
}

std::size_t SummaryQueue::countOffset(int slot, const Counting& counts) const {
  return (static_cast<std::size_t>(slot) * countRowsOfSlot_ + counts.firstRow) * 16;
}

std::size_t SummaryQueue::sumOffset(int slot) const {
  return static_cast<std::size_t>(slot) * arrays_.size() * 16;
}

GLintptr SummaryQueue::statusOffset(int slot, std::size_t object) const {
  return static_cast<GLintptr>((static_cast<std::size_t>(slot) * objects_.size() + object) * 16);
}

void SummaryQueue::checkStatus(int frame, int slot) {
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (objects_[i]->status() == nullptr) continue;
    unsigned words[4] = {};
    copyOut(statuses_, static_cast<std::size_t>(statusOffset(slot, i)),
            std::as_writable_bytes(std::span(words)));
    if (words[0] != 0xffffffffU)
      throw UserError(ExitCode::device, objects_[i]->explainLoss(words[0], words[1]));
    if (words[2] == 0 || remarked_[i]) continue;
    remarked_[i] = true;
    warn("{}", objects_[i]->remark(frame));
  }
}

/// Computes a summary from the copied results. The hash of the whole state is the sum of its arrays'
/// hashes, word by word.
Summary SummaryQueue::summary(const Pending& from) const {
  std::vector<glm::uvec4> words(arrays_.size());
  copyOut(sumCopies_, sumOffset(from.slot), std::as_writable_bytes(std::span(words)));
  Summary result{from.frame, {}, {}, {}};
  glm::uvec4 total(0);
  for (const glm::uvec4& w : words) {
    total += w;
    result.arrays.push_back(StateHash::text(w));
  }
  result.stateHash = StateHash::text(total);
  for (std::size_t i = 0; i < counting_.size(); ++i) {
    auto& rows = result.counts.emplace_back(static_cast<std::size_t>(from.countsPerObject[i]));
    if (!rows.empty())
      copyOut(countCopies_, countOffset(from.slot, counting_[i]), std::as_writable_bytes(std::span(rows)));
  }
  return result;
}

}  // namespace simreel::sim
