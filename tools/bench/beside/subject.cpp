#include "beside/subject.hpp"

#include "base/clock.hpp"
#include "gl/context.hpp"
#include "plain/plain.hpp"

#include <algorithm>
#include <ctime>

#include <fmt/format.h>

namespace simreel::bench {

namespace {

struct Turn {
  double wall = 0, processor = 0;  ///< wall-clock and processor time in seconds
};

Turn timed(const std::function<void()>& work) {
  const auto begin = Clock::now();
  const std::clock_t used = std::clock();
  work();
  return {secondsSince(begin), static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC};
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Returns the maximum number of items per second that one processor can process if it does only the
/// minimum work. This is the lower of two measured rates: the rate of arithmetic operations, and the rate
/// of copying as many bytes as are in use between two uses of an item.
double limit(const MinimumWork& minimum) {
  const auto rate = [](auto work) {
    std::vector<double> rates;
    for (int i = 0; i < 5; ++i) {
      double amount = 0;
      const Turn turn = timed([&] { amount = work(); });
      rates.push_back(amount / turn.processor);
    }
    return median(rates);
  };
  const double arithmetic = rate([] { return plain::arithmetic(); }) / minimum.operations;
  const auto size = static_cast<std::size_t>(minimum.bytes * minimum.pass);
  return std::min(arithmetic, rate([&] { return plain::copying(size); }) / minimum.bytes);
}

}  // namespace

void keepBusy(const Subject& subject, double seconds) {
  for (const auto begin = Clock::now(); secondsSince(begin) < seconds; glFinish()) subject.device();
}

void printHeads() {
  fmt::print("{:<24} {:>10} {:>10} {:>10} {:>10} {:>10} {:>10} {:>8} {:>6}\n", "", "plain loop", "twin",
             "wall", "", "processor", "", "limit", "");
}

void print(const Subject& subject) {
  constexpr int fewest = 5;
  std::vector<double> plain, twin, wall, processor, wallRatio, processorRatio;
  const auto device = [&] {
    subject.device();
    glFinish();
  };
  device();
  const auto begin = Clock::now();
  for (int round = 0; round < fewest || secondsSince(begin) < 3; ++round) {
    const Turn a = timed(subject.plain);
    const Turn b = timed(device);
    if (subject.twin) twin.push_back(subject.items / timed(subject.twin).processor);
    plain.push_back(subject.items / a.processor);
    wall.push_back(subject.items / b.wall);
    processor.push_back(subject.items / b.processor);
    wallRatio.push_back(a.wall / b.wall);
    processorRatio.push_back(a.processor / b.processor);
  }
  const double maximum = subject.minimum.operations > 0 ? limit(subject.minimum) : 0;
  fmt::print("{:<24} {:>10.2f} {:>10} {:>10.2f} {:>8.2f} x {:>10.2f} {:>8.2f} x {:>8} {:>6}  {}\n",
             subject.name, median(plain) / 1e6,
             twin.empty() ? "" : fmt::format("{:.2f}", median(twin) / 1e6), median(wall) / 1e6,
             median(wallRatio), median(processor) / 1e6, median(processorRatio),
             maximum > 0 ? fmt::format("{:.1f}", maximum / 1e6) : "",
             maximum > 0 ? fmt::format("{:.1f}%", 100 * median(processor) / maximum) : "", subject.unit);
  if (subject.after) subject.after();
  std::fflush(stdout);
}

}  // namespace simreel::bench
