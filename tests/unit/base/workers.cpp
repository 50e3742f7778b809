#include "base/workers.hpp"

#include "base/error.hpp"
#include "base/process.hpp"

#include <algorithm>
#include <csignal>
#include <string>
#include <unistd.h>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

struct Received {
  std::vector<std::string> said;  ///< answers in the order of delivery
  int ready = 0;
};

/// Returns a work force whose workers answer "item 3" and so on. Early items take longer. `end`: may end a
/// worker's process before it answers.
WorkerPool force(
    std::size_t workers, std::size_t items, Received& received,
    const std::function<void(const Task&)>& end = [](const Task&) {}) {
  std::signal(SIGPIPE, SIG_IGN);
  WorkerPool made;
  made.workers = workers;
  made.items = items;
  made.work = [items, end](WorkerLine& line) {
    std::signal(SIGTERM, SIG_DFL);
    line.ready("hello");
    while (const auto task = line.next()) {
      const std::size_t item = task->item;
      ::usleep(static_cast<useconds_t>(2000 * (items - item)));
      end(*task);
      line.answer(item, "item " + std::to_string(item) + std::string(200'000, '.'));
    }
  };
  made.ready = [&received](const std::string& text) {
    CHECK(text == "hello");
    ++received.ready;
  };
  made.done = [&received](std::size_t item, const std::string& text) {
    CHECK(text.size() == 200'000 + 5 + std::to_string(item).size());
    received.said.push_back(text.substr(0, text.find('.')));
  };
  made.lost = [&received](std::size_t item, const Loss& loss) {
    received.said.push_back((loss.late ? "late " : "lost ") + std::to_string(item) + ": " + loss.how);
  };
  made.again = [](std::size_t, const Loss&) { return false; };
  made.alone = [](std::size_t) { return false; };
  made.interrupted = [] { return 0; };
  return made;
}

}  // namespace

TEST_CASE("workers: results are returned in order, independent of how long each takes") {
  for (const std::size_t workers : {1U, 3U, 20U}) {
    Received received;
    runWorkers(force(workers, 7, received));
    CHECK(received.said ==
          std::vector<std::string>{"item 0", "item 1", "item 2", "item 3", "item 4", "item 5", "item 6"});
    CHECK(received.ready == 1);
  }
  Received none;
  runWorkers(force(2, 1, none));
  CHECK(none.said == std::vector<std::string>{"item 0"});
}

TEST_CASE("workers: a worker that dies loses only its current item and reports how it died") {
  Received received;
  runWorkers(force(2, 6, received, [](const Task& task) {
    if (task.item == 1) ::raise(SIGKILL);
    if (task.item == 3) ::_exit(7);
    if (task.item == 4) throw std::runtime_error("no more paper");
  }));
  CHECK(received.said == std::vector<std::string>{"item 0", "lost 1: was ended by signal 9 (Killed)",
                                                  "item 2", "lost 3: ended with status 7",
                                                  "lost 4: failed: no more paper", "item 5"});
}

TEST_CASE("workers: each worker has a slot, and a replacement takes the dead worker's slot") {
  Received received;
  WorkerPool placed = force(2, 6, received);
  placed.work = [](WorkerLine& line) {
    line.ready("hello");
    while (const auto task = line.next()) {
      if (task->item == 2) ::_exit(3);
      ::usleep(20'000);
      line.answer(task->item, std::to_string(line.place()));
    }
  };
  std::string places;
  placed.done = [&](std::size_t, const std::string& place) { places += place; };
  runWorkers(placed);
  CHECK(places.size() == 5);
  CHECK(std::count(places.begin(), places.end(), '0') + std::count(places.begin(), places.end(), '1') == 5);
  CHECK(places.find('1') != std::string::npos);
  CHECK(places.find('0') != std::string::npos);
}

TEST_CASE("workers: a job in which every worker dies at every item ends") {
  Received received;
  runWorkers(force(2, 5, received, [](const Task&) { ::_exit(9); }));
  CHECK(received.said.size() == 5);
  for (const std::string& said : received.said) CHECK(said.ends_with(": ended with status 9"));
}

TEST_CASE("workers: a lost item is retried by another worker, which knows the number of tries") {
  Received received;
  std::vector<std::string> losses;
  WorkerPool patient = force(2, 4, received, [](const Task& task) {
    if (task.item == 0 || (task.item == 2 && task.losses < 2)) ::_exit(3 + task.losses);
  });
  patient.again = [&losses](std::size_t item, const Loss& loss) {
    losses.push_back(std::to_string(item) + " " + loss.how);
    return std::count_if(losses.begin(), losses.end(), [&](const std::string& known) {
             return known.starts_with(std::to_string(item));
           }) < 3;
  };
  runWorkers(patient);
  CHECK(received.said ==
        std::vector<std::string>{"lost 0: ended with status 5", "item 1", "item 2", "item 3"});
  std::sort(losses.begin(), losses.end());
  CHECK(losses == std::vector<std::string>{"0 ended with status 3", "0 ended with status 4",
                                           "0 ended with status 5", "2 ended with status 3",
                                           "2 ended with status 4"});
}

TEST_CASE("workers: a worker that exceeds its time is killed with its children; other workers continue") {
  Received received;
  int pipe[2] = {-1, -1};
  REQUIRE(::pipe(pipe) == 0);
  WorkerPool hurried = force(2, 4, received, [&](const Task& task) {
    if (task.item != 1) return;
    if (::fork() == 0) ::pause();  // This child process keeps the pipe open while it lives.
    ::pause();
  });
  hurried.itemTimeout = 1.5;
  runWorkers(hurried);
  CHECK(received.said == std::vector<std::string>{"item 0", "late 1: took longer than 1.5 s, and was ended",
                                                  "item 2", "item 3"});
  ::close(pipe[1]);
  char none = 0;
  CHECK(::read(pipe[0], &none, 1) == 0);  // End of file means that no writer is left.
  ::close(pipe[0]);
}

TEST_CASE("workers: an error that stops all workers is thrown") {
  Received received;
  WorkerPool refused = force(2, 3, received);
  refused.work = [](WorkerLine&) { fail(ExitCode::device, "no paint"); };
  CHECK_THROWS_WITH_AS(runWorkers(refused), "no paint", UserError);
  refused.work = [](WorkerLine&) { ::raise(SIGKILL); };
  CHECK_THROWS_WITH_AS(runWorkers(refused), "the worker process was ended by signal 9 (Killed)", UserError);
  CHECK(received.said.empty());
}

TEST_CASE("workers: a worker that cannot start is reported, whether or not other workers started") {
  for (const unsigned later : {0U, 1U}) {
    Received received;
    WorkerPool some = force(2, 3, received);
    const auto work = some.work;
    some.work = [&](WorkerLine& line) {
      ::usleep(line.place() == later ? 60'000 : 0);
      if (line.place() == 1) fail(ExitCode::device, "no brush");
      work(line);
    };
    const int screen = ::dup(2), said = makeMemoryFile("said");
    ::dup2(said, 2);
    runWorkers(some);
    ::dup2(screen, 2);
    ::close(screen);
    CHECK(endOfMemoryFile(said) ==
          "simreel: warning: the work continues with one process less, because that process no brush\n");
    ::close(said);
    CHECK(received.said.size() == 3);
  }
}

TEST_CASE("workers: exclusive items run alone and in order") {
  Received received;
  int pipe[2] = {-1, -1};
  REQUIRE(::pipe(pipe) == 0);
  WorkerPool careful = force(4, 6, received);
  careful.alone = [](std::size_t item) { return item % 2 == 1; };
  careful.work = [&](WorkerLine& line) {
    line.ready("hello");
    while (const auto task = line.next()) {
      const std::size_t item = task->item;
      const auto mark = [&](char c) { CHECK(::write(pipe[1], &c, 1) == 1); };
      if (item % 2 == 1) mark(static_cast<char>('0' + item));
      ::usleep(5000);
      if (item % 2 == 1) mark('.');
      line.answer(item, "item " + std::to_string(item) + std::string(200'000, '.'));
    }
  };
  runWorkers(careful);
  char marks[7] = {};
  CHECK(::read(pipe[0], marks, 6) == 6);
  CHECK(std::string(marks) == "1.3.5.");
  CHECK(received.said.size() == 6);
  ::close(pipe[0]);
  ::close(pipe[1]);
}

TEST_CASE("workers: finished results are kept after an interrupt") {
  Received received;
  int signal = 0;
  WorkerPool stopped = force(1, 5, received);
  stopped.interrupted = [&] { return signal; };
  const auto done = stopped.done;
  stopped.done = [&](std::size_t item, const std::string& text) {
    done(item, text);
    if (item == 1) signal = SIGINT;
  };
  runWorkers(stopped);
  CHECK(received.said == std::vector<std::string>{"item 0", "item 1"});
}
