#pragma once
#include "gl/buffer.hpp"
#include "sim/core/simulation.hpp"
#include "sim/core/state_hash.hpp"

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Name of an object's state array.
struct ArrayName {
  std::string object, array;
  long elements = 0;  ///< number of vec4 elements
};

/// Names of the counts of an object.
struct CountNames {
  std::string object;
  std::vector<std::string> columns;
  int elements = 1;       ///< number of uvec4 elements per row
  bool measured = false;  ///< true if the values are floats
};

/// Results of one frame: the hash (32 hexadecimal digits) over every state array of every object, and the
/// counts.
struct Summary {
  int frame = 0;
  std::string stateHash;
  std::vector<std::string> arrays;  ///< hash of each state array, in the order of SummaryQueue::arrays()
  /// Counts of each step of the frame, row by row, for each entry of SummaryQueue::countNames(); before the
  /// first step, one row with the initial counts.
  std::vector<std::vector<glm::uvec4>> counts = {};
};

/// Queue of hashes, loss reports and counts of frames that the GPU is still computing. Results are copied
/// to mapped buffers, because reading another buffer would wait for all submitted commands.
class SummaryQueue {
 public:
  using Objects = std::span<const std::unique_ptr<Simulation>>;
  static constexpr int capacity = 8;  ///< maximum number of pending frames

  /// `objects` and `names` (one name per object) must outlive this object.
  SummaryQueue(Objects objects, std::span<const std::string> names);
  ~SummaryQueue();
  SummaryQueue(const SummaryQueue&) = delete;
  SummaryQueue& operator=(const SummaryQueue&) = delete;

  [[nodiscard]] const std::vector<ArrayName>& arrays() const { return arrays_; }
  [[nodiscard]] std::vector<CountNames> countNames() const;

  /// Starts hashing the current state of the objects and copying their counts. At most `capacity` summaries
  /// may be pending.
  void start(int frame);
  /// Returns the oldest summary if it is ready. If `wait` is true, waits for it. Throws UserError(device)
  /// if a simulation lost its state.
  [[nodiscard]] std::optional<Summary> next(bool wait);

 private:
  /// Frame whose results the GPU is still computing, and the slot that the results are copied to.
  struct Pending {
    int frame;
    int slot;
    GLsync fence;
    std::vector<int> countsPerObject;  ///< number of uvec4 counts (rows times elements) per counting object
  };
  /// Object that counts, and the index of the first of its rows in a slot of countCopies_.
  struct Counting {
    std::size_t object;
    std::size_t firstRow;
  };

  [[nodiscard]] std::vector<int> copyCounts(int slot) const;
  [[nodiscard]] std::size_t countOffset(int slot, const Counting& counts) const;
  [[nodiscard]] std::size_t sumOffset(int slot) const;
  [[nodiscard]] GLintptr statusOffset(int slot, std::size_t object) const;
  void checkStatus(int frame, int slot);
  [[nodiscard]] Summary summary(const Pending& from) const;

  Objects objects_;
  std::span<const std::string> names_;
  std::vector<bool> remarked_;  ///< for each object: true once its remark was printed
  std::vector<ArrayName> arrays_;
  std::vector<Counting> counting_;
  std::size_t countRowsOfSlot_ = 0;
  StateHash hash_;
  gl::Buffer sums_;         ///< hash sums: one uvec4 per array
  gl::Buffer sumCopies_;    ///< copies of hash sums: one uvec4 per array and slot
  gl::Buffer statuses_;     ///< copies of status buffers: one uvec4 per object and slot
  gl::Buffer countCopies_;  ///< copies of counts: one uvec4 per element of each row and slot
  std::deque<Pending> pending_;
  int nextSlot_ = 0;
};

}  // namespace simreel::sim
