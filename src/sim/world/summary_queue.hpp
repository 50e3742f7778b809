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

/// A state array of an object.
struct ArrayName {
  std::string object, array;
  long elements = 0;  ///< vec4 each
};

/// What an object counts.
struct CountNames {
  std::string object;
  std::vector<std::string> columns;
  int elements = 1;       ///< uvec4 a row
  bool measured = false;  ///< floats
};

/// Frame and hash (32 hexadecimal digits over every state array of every object).
struct Summary {
  int frame = 0;
  std::string stateHash;
  std::vector<std::string> arrays;  ///< hash of each state array, in the order of SummaryQueue::arrays()
  /// Counts of each step of the frame, row by row, for each entry of SummaryQueue::countNames(); where
  /// nothing has stepped yet, one row of the start.
  std::vector<std::vector<glm::uvec4>> counts = {};
};

/// Hashes, losses and counts of frames that are still under way on the GPU, in memory of their own: reading
/// a buffer of the device's would wait for all that was asked of it.
class SummaryQueue {
 public:
  using Objects = std::span<const std::unique_ptr<Simulation>>;
  static constexpr int capacity = 8;  ///< frames under way

  /// `objects` and `names`, one for each, live as long as this.
  SummaryQueue(Objects objects, std::span<const std::string> names);
  ~SummaryQueue();
  SummaryQueue(const SummaryQueue&) = delete;
  SummaryQueue& operator=(const SummaryQueue&) = delete;

  [[nodiscard]] const std::vector<ArrayName>& arrays() const { return arrays_; }
  [[nodiscard]] std::vector<CountNames> countNames() const;

  /// Starts hashing what the objects hold now, and copying what they count. At most `capacity` under way.
  void start(int frame);
  /// The oldest, once it is there; with `wait` waits for it. Throws UserError(device) when a simulation
  /// lost its state.
  [[nodiscard]] std::optional<Summary> take(bool wait);

 private:
  /// Hash sums and loss report of one frame: 16 bytes for each state array, and 16 bytes of status for each
  /// object.
  struct Pending {
    int frame;
    int slot;
    GLsync fence;
    std::vector<int> countRows;  ///< elements of each object that counts
  };
  /// An object that counts, and the first of its rows in a slot of countCopies_.
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
  std::vector<bool> remarked_;  ///< of each object, whether its remark was made
  std::vector<ArrayName> arrays_;
  std::vector<Counting> counting_;
  std::size_t countRowsOfSlot_ = 0;
  StateHash hash_;
  gl::Buffer sums_;         ///< uvec4 per array
  gl::Buffer sumCopies_;    ///< uvec4 per array per slot
  gl::Buffer statuses_;     ///< uvec4 per object per slot
  gl::Buffer countCopies_;  ///< uvec4 per step of a frame per slot
  std::deque<Pending> pending_;
  int nextSlot_ = 0;
};

}  // namespace simreel::sim
