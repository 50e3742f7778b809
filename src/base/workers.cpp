#include "base/workers.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/log.hpp"
#include "base/process.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <list>
#include <map>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <variant>
#include <vector>

namespace simreel {

namespace {

/// Time (ms) between checks for a signal. The checks are needed because a signal that arrives just before a
/// wait does not interrupt it.
constexpr int pollMilliseconds = 50;

enum class Word : std::uint32_t { ready, answer, mistake, failure };

/// Header of each message from a worker. Its layout is the same in both processes, because both run the
/// same program.
struct Head {
  Word word = Word::ready;
  std::uint32_t code = 0;  ///< exit code, for Word::mistake
  std::uint64_t item = 0, bytes = 0;
};

bool writeAll(int descriptor, const void* bytes, std::size_t count) {
  const char* at = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t put = ::write(descriptor, at, count);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return false;
    at += put;
    count -= static_cast<std::size_t>(put);
  }
  return true;
}

/// Sends a message. If the main program no longer reads, the process exits, because no work is left.
void send(int descriptor, Head head, std::string_view text) {
  head.bytes = text.size();
  if (!writeAll(descriptor, &head, sizeof head) || !writeAll(descriptor, text.data(), text.size()))
    ::_exit(1);
}

struct Worker {
  pid_t process = -1;
  std::size_t place = 0;
  int work = -1, answers = -1;
  std::string heard;  ///< received bytes of an incomplete message
  bool ready = false;
  bool warned = false;  ///< true if the worker has been told to end
  std::optional<std::size_t> item;
  Clock::time_point begin;  ///< time at which the current item began
  bool late = false;
  /// Reason why the worker ended: its own error message, or the timeout, signal or exit status that the
  /// main program observed.
  std::string failure;
  std::optional<ExitCode> mistake;
};

class Employer {
 public:
  explicit Employer(const WorkerPool& force)
      : force_(force), begun_(force.items, false), losses_(force.items, 0) {}
  ~Employer() {
    // After an exception no results are used, so all workers are killed.
    for (Worker& worker : workers_) {
      ::kill(-worker.process, SIGKILL);
      closeLines(worker);
      static_cast<void>(waitFor(worker));
    }
  }
  Employer(const Employer&) = delete;
  Employer& operator=(const Employer&) = delete;
  Employer(Employer&&) = delete;
  Employer& operator=(Employer&&) = delete;

  void run() {
    for (std::size_t i = 0; i < std::min(force_.workers, force_.items); ++i)
      if (!start()) break;
    while (!workers_.empty()) {
      if (force_.interrupted() != 0) stopAll();
      handOut();
      listen();
      endLate();
    }
    if (force_.interrupted() != 0) {
      while (!waiting_.empty())
        deliverNext();  // deliverNext() delivers the remaining results, although some items have none.
      return;
    }
    if (!everReady_ && firstMistake_) throw UserError(*firstMistake_, firstFailure_);
    if (!everReady_) fail(ExitCode::device, "the worker process {}", firstFailure_);
    for (std::size_t item = 0; item < begun_.size(); ++item)
      if (!begun_[item]) finish(item, Loss{"could not be started again: " + firstFailure_, false});
  }

 private:
  using End = std::variant<std::string, Loss>;

  /// Returns the smallest slot number that no running worker has.
  [[nodiscard]] std::size_t freePlace() const {
    std::size_t place = 0;
    while (std::any_of(workers_.begin(), workers_.end(),
                       [&](const Worker& worker) { return worker.place == place; }))
      ++place;
    return place;
  }

  bool start() {
    const std::size_t place = freePlace();
    int work[2] = {-1, -1}, answers[2] = {-1, -1};
    // The pipes close on exec, but a worker only forks and therefore inherits all of them. So it closes the
    // pipes of the other workers itself.
    const bool lines = ::pipe2(work, O_CLOEXEC) == 0 && ::pipe2(answers, O_CLOEXEC) == 0;
    std::fflush(nullptr);
    const pid_t process = lines ? forkProcess() : -1;
    if (process == 0) {
      for (const Worker& other : workers_) {
        ::close(other.work);
        ::close(other.answers);
      }
      ::close(work[1]);
      ::close(answers[0]);
      runWorker(work[0], answers[1], place);
    }
    const int error = errno;
    for (const int end : {work[0], answers[1]})
      if (end >= 0) ::close(end);
    if (process > 0) {
      Worker& worker = workers_.emplace_back();
      worker.process = process;
      worker.place = place;
      worker.work = work[1];
      worker.answers = answers[0];
      return true;
    }
    for (const int end : {work[1], answers[0]})
      if (end >= 0) ::close(end);
    if (workers_.empty() && !everReady_)
      fail(ExitCode::inputOutput, "cannot start a process to work in: {}", std::strerror(error));
    if (firstFailure_.empty()) firstFailure_ = std::strerror(error);
    warn("cannot start another process to work in: {}", std::strerror(error));
    return false;
  }

  /// Runs in the worker process. Exits with _exit(), so that no destructor of a static object runs and no
  /// buffer inherited from the parent is written.
  [[noreturn]] void runWorker(int in, int out, std::size_t place) const {
    WorkerLine line(in, out, place);
    try {
      force_.work(line);
    } catch (const UserError& error) {
      send(out, {Word::mistake, static_cast<std::uint32_t>(error.code()), 0, 0}, error.what());
      ::_exit(1);
    } catch (const std::exception& error) {
      send(out, {Word::failure, 0, 0, 0}, error.what());
      ::_exit(1);
    } catch (...) {
      if (const int number = force_.interrupted(); number != 0) ::_exit(128 + number);
      send(out, {Word::failure, 0, 0, 0}, "unknown reason");
      ::_exit(1);
    }
    ::_exit(0);
  }

  void stopAll() {
    for (Worker& worker : workers_)
      if (!std::exchange(worker.warned, true)) {
        ::kill(worker.process, SIGTERM);
        closeWork(worker);
      }
  }

  static void closeWork(Worker& worker) {
    if (worker.work >= 0) ::close(std::exchange(worker.work, -1));
  }
  static void closeLines(Worker& worker) {
    closeWork(worker);
    if (worker.answers >= 0) ::close(std::exchange(worker.answers, -1));
  }

  [[nodiscard]] std::optional<std::size_t> nextItem() const {
    bool aloneWaits = std::any_of(workers_.begin(), workers_.end(), [&](const Worker& worker) {
      return worker.item && force_.alone(*worker.item);
    });
    for (std::size_t item = 0; item < begun_.size(); ++item) {
      if (begun_[item]) continue;
      if (!force_.alone(item)) return item;
      if (!aloneWaits) return item;
      aloneWaits = true;
    }
    return std::nullopt;
  }

  void handOut() {
    for (Worker& worker : workers_) {
      if (!worker.ready || worker.item || worker.work < 0) continue;
      const auto item = nextItem();
      const bool all = std::find(begun_.begin(), begun_.end(), false) == begun_.end();
      if (all) closeWork(worker);
      if (!item) continue;
      const Task task{*item, losses_[*item]};
      // If the worker is dead, the item stays unassigned. listen() detects the worker's end.
      if (!writeAll(worker.work, &task, sizeof task)) {
        closeWork(worker);
        continue;
      }
      begun_[*item] = true;
      worker.item = item;
      worker.begin = Clock::now();
    }
  }

  void listen() {
    std::vector<pollfd> lines;
    for (const Worker& worker : workers_) lines.push_back({worker.answers, POLLIN, 0});
    if (::poll(lines.data(), lines.size(), pollMilliseconds) <= 0) return;
    std::size_t at = 0;
    for (auto worker = workers_.begin(); at < lines.size(); ++at) {
      const auto here = worker++;
      if (lines[at].revents != 0 && !receive(*here)) buried(here);
    }
  }

  void endLate() {
    if (force_.itemTimeout <= 0) return;
    for (Worker& worker : workers_)
      if (worker.item && secondsSince(worker.begin) > force_.itemTimeout &&
          !std::exchange(worker.late, true))
        ::kill(-worker.process, SIGKILL);
  }

  /// Reads messages from a worker. Returns false at the end of the connection.
  bool receive(Worker& worker) {
    char block[1 << 16];
    const ssize_t got = ::read(worker.answers, block, sizeof block);
    if (got < 0) return errno == EINTR;
    worker.heard.append(block, static_cast<std::size_t>(got));
    while (worker.heard.size() >= sizeof(Head)) {
      Head head;
      std::memcpy(&head, worker.heard.data(), sizeof head);
      if (worker.heard.size() - sizeof head < head.bytes) break;
      std::string text = worker.heard.substr(sizeof head, head.bytes);
      worker.heard.erase(0, sizeof head + head.bytes);
      heard(worker, head, std::move(text));
    }
    return got > 0;
  }

  void heard(Worker& worker, const Head& head, std::string&& text) {
    switch (head.word) {
      case Word::ready:
        worker.ready = true;
        if (!std::exchange(everReady_, true)) force_.ready(text);
        warnUnready();
        break;
      case Word::answer:
        if (!worker.item || *worker.item != head.item) break;
        worker.item.reset();
        finish(head.item, std::move(text));
        break;
      case Word::mistake:
        worker.mistake = static_cast<ExitCode>(head.code);
        worker.failure = std::move(text);
        break;
      case Word::failure:
        worker.failure = "failed: " + text;
        break;
    }
  }

  static int waitFor(const Worker& worker) {
    int status = 0;
    while (::waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
    }
    childEnded(worker.process);
    return status;
  }

  void buried(std::list<Worker>::iterator place) {
    Worker worker = std::move(*place);
    workers_.erase(place);
    closeLines(worker);
    const int status = waitFor(worker);
    if (force_.interrupted() != 0) return;
    if (worker.late)
      worker.failure = fmt::format("took longer than {:g} s, and was ended", force_.itemTimeout);
    else if (worker.failure.empty())
      worker.failure = WIFSIGNALED(status) ? fmt::format("was ended by signal {} ({})", WTERMSIG(status),
                                                         ::strsignal(WTERMSIG(status)))
                                           : fmt::format("ended with status {}", WEXITSTATUS(status));
    const bool wellDone = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !worker.item && worker.ready;
    if (!wellDone && firstFailure_.empty()) {
      firstFailure_ = worker.failure;
      firstMistake_ = worker.mistake;
    }
    if (!worker.ready) unready_.push_back(worker.failure);
    warnUnready();
    if (worker.item) lose(*worker.item, {worker.failure, worker.late});
    const bool more = std::find(begun_.begin(), begun_.end(), false) != begun_.end();
    if (worker.ready && !wellDone && more) static_cast<void>(start());
  }

  /// Warns about processes that ended before they were ready, but only after another process has become
  /// ready. If none becomes ready, the failure is the error of the whole call.
  void warnUnready() {
    if (!everReady_) return;
    for (const std::string& failure : unready_)
      warn("the work continues with one process less, because that process {}", failure);
    unready_.clear();
  }

  void lose(std::size_t item, Loss&& loss) {
    ++losses_[item];
    if (force_.again && force_.again(item, loss))
      begun_[item] = false;
    else
      finish(item, std::move(loss));
  }

  /// Records the result of an item. Delivers all results that are next in order.
  void finish(std::size_t item, End&& end) {
    begun_[item] = true;
    waiting_.emplace(item, std::move(end));
    while (!waiting_.empty() && waiting_.begin()->first == handedOn_) deliverNext();
  }

  void deliverNext() {
    const auto first = waiting_.extract(waiting_.begin());
    handedOn_ = first.key() + 1;
    if (const auto* loss = std::get_if<Loss>(&first.mapped()))
      force_.lost(first.key(), *loss);
    else
      force_.done(first.key(), std::get<std::string>(first.mapped()));
  }

  const WorkerPool& force_;
  std::list<Worker> workers_;
  std::vector<bool> begun_;
  std::vector<int> losses_;
  std::map<std::size_t, End> waiting_;
  std::size_t handedOn_ = 0;
  bool everReady_ = false;
  std::vector<std::string> unready_;  ///< failures that have not been reported yet
  std::string firstFailure_;
  std::optional<ExitCode> firstMistake_;
};

}  // namespace

void WorkerLine::ready(std::string_view text) {
  send(out_, {Word::ready, 0, 0, 0}, text);
}

std::optional<Task> WorkerLine::next() {
  Task task;
  std::size_t have = 0;
  while (have < sizeof task) {
    const ssize_t got = ::read(in_, reinterpret_cast<char*>(&task) + have, sizeof task - have);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return std::nullopt;
    have += static_cast<std::size_t>(got);
  }
  return task;
}

void WorkerLine::answer(std::size_t item, std::string_view text) {
  send(out_, {Word::answer, 0, item, 0}, text);
}

void runWorkers(const WorkerPool& force) {
  Employer(force).run();
}

}  // namespace simreel
