#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace simreel {

/// A piece of work in a worker's hand.
struct Task {
  std::size_t item = 0;
  int losses = 0;  ///< workers that ended with it in hand before
};

/// How a worker ended that had a piece of work in hand.
struct Loss {
  std::string how;    ///< "was ended by signal 9 (Killed)"
  bool late = false;  ///< it took longer than WorkForce::patience
};

/// A worker's end of its line to the program that started it.
class WorkerLine {
 public:
  WorkerLine(int in, int out, std::size_t place) : in_(in), out_(out), place_(place) {}
  /// Of the workers that there may be at once the how manieth this is, from 0; who takes the place of one
  /// that ended has its number.
  [[nodiscard]] std::size_t place() const { return place_; }
  /// Once, before the first item: that it can work, and what the others have to know of it.
  void ready(std::string_view text);
  /// The next piece of work; nothing at the end of all.
  [[nodiscard]] std::optional<Task> next();
  void answer(std::size_t item, std::string_view text);

 private:
  int in_, out_;
  std::size_t place_;
};

/// Pieces of work, numbered from 0, that processes do beside each other. Only `work` runs in them.
struct WorkForce {
  std::size_t workers = 1;
  std::size_t items = 0;
  /// A worker's whole life. A UserError before it is ready is thrown by employ() if no worker ever was.
  std::function<void(WorkerLine&)> work;
  /// Called once, with what the first worker that is ready says.
  std::function<void(const std::string&)> ready;
  /// Called in the order of the items.
  std::function<void(std::size_t item, const std::string& answer)> done;
  /// The same for an item whose worker ended before it answered.
  std::function<void(std::size_t item, const Loss&)> lost;
  /// Asked at once where a worker ends: whether another one shall do that item. If not, or where nobody is
  /// asked, it is lost.
  std::function<bool(std::size_t item, const Loss&)> again;
  /// Seconds that a worker may take for an item; it is killed then, with all that it has started. 0: any.
  double patience = 0;
  /// Items that may not be done beside each other, nor out of order.
  std::function<bool(std::size_t item)> alone;
  /// Not 0: no more work is begun, workers get SIGTERM, and what they have finished is taken.
  std::function<int()> interrupted;
};

/// Does all the work. A worker that ends in the middle of an item costs that item alone: another one takes
/// its place. Throws UserError where no worker can be started or gets ready.
void employ(const WorkForce& force);

}  // namespace simreel
