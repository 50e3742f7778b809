#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace simreel {

/// Item of work that is assigned to a worker.
struct Task {
  std::size_t item = 0;
  int losses = 0;  ///< number of workers that have already ended while they worked on this item
};

/// Description of how a worker ended while it worked on an item.
struct Loss {
  std::string how;    ///< reason in words, such as "was ended by signal 9 (Killed)"
  bool late = false;  ///< true if the item took longer than WorkerPool::patience
};

/// The worker's end of the connection to the program that started it.
class WorkerLine {
 public:
  WorkerLine(int in, int out, std::size_t place) : in_(in), out_(out), place_(place) {}
  /// Returns the zero-based slot of this worker. A worker that replaces another one takes over its slot.
  [[nodiscard]] std::size_t place() const { return place_; }
  /// Reports that the worker can start, with a text for the main program (WorkerPool::ready). Must be
  /// called once, before the first item.
  void ready(std::string_view text);
  /// Returns the next item, or nullopt if no work is left.
  [[nodiscard]] std::optional<Task> next();
  void answer(std::size_t item, std::string_view text);

 private:
  int in_, out_;
  std::size_t place_;
};

/// Items of work, numbered from 0, for several parallel processes. Only `work` runs in these processes; the
/// other functions run in the main program.
struct WorkerPool {
  std::size_t workers = 1;
  std::size_t items = 0;
  /// Main function of a worker. If no worker ever becomes ready, employ() rethrows the first worker's
  /// UserError.
  std::function<void(WorkerLine&)> work;
  /// Called once, with the text from the first worker that becomes ready.
  std::function<void(const std::string&)> ready;
  /// Called with each answer, in the order of the items.
  std::function<void(std::size_t item, const std::string& answer)> done;
  /// Called in the order of the items for each item whose worker ended before it answered.
  std::function<void(std::size_t item, const Loss&)> lost;
  /// Called as soon as a worker ends while it works on an item. Must return true to give the item to
  /// another worker. If it returns false or is empty, the item is lost.
  std::function<bool(std::size_t item, const Loss&)> again;
  /// Max time (s) for an item; 0 means unlimited. After that time, the item's worker is killed with all
  /// processes that it has started.
  double itemTimeout = 0;
  /// Returns true for items that must run in order and not in parallel with each other.
  std::function<bool(std::size_t item)> alone;
  /// Returns the number of a received signal, or 0. After a signal, no new work starts, workers get
  /// SIGTERM, and their finished answers are still delivered.
  std::function<int()> interrupted;
};

/// Does all the work. A worker that ends while it works on an item affects only this item, because another
/// worker takes its slot. Throws UserError if no worker can be started or no worker becomes ready.
void runWorkers(const WorkerPool& force);

}  // namespace simreel
