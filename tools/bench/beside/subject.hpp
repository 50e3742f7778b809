// Declares the measurements of bench_plain, which compare a kernel with a plain loop and a CPU twin.
#pragma once
#include "sim/world/list.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace simreel::bench {

inline constexpr double frameSeconds = 1.0 / 60;

/// Minimum work per item that the model's equations require.
struct MinimumWork {
  double operations = 0;  ///< number of additions, multiplications, divisions and square roots; 0 if they
                          ///< have not been counted
  double bytes = 0;       ///< bytes of memory that are read and written
  double pass = 0;        ///< number of items that are processed before the memory of the first item is
                          ///< used again
};

/// A comparison of up to three implementations, which run alternately. `items` is the number of items that
/// each processes per turn.
struct Subject {
  const char* name;
  const char* unit;
  double items;
  std::function<void()> plain, twin, device;  ///< functions that each run one turn of an implementation;
                                              ///< `twin` may be empty
  MinimumWork minimum{};
  std::function<void()> after = {};  ///< function that prints further results after the subject's line; may
                                     ///< be empty
};

/// Runs the implementations of a subject alternately and prints one line with their rates.
void print(const Subject& subject);
/// Prints the column headings.
void printHeads();
/// Runs only the kernel for the given number of seconds, for use with profilers.
void keepBusy(const Subject& subject, double seconds);

/// Cloth cases: a sheet of fabric, a cloth mesh, and cloths stacked on one another.
[[nodiscard]] Subject fabricSheet();
[[nodiscard]] Subject meshCloth();
[[nodiscard]] Subject clothsInContact();

/// Fluid cases: a tank of 512x512 cells with dye in three colours, temperature and an obstacle; and a basin
/// of water with islands.
[[nodiscard]] Subject fluidTank();
[[nodiscard]] Subject waterBasin();

template <class Parameters>
std::shared_ptr<sim::Simulation> onDevice(const char* kind, const Parameters& parameters,
                                          int contactSubsteps = 0) {
  scene::Object object;
  object.name = kind;
  object.parameters = std::make_unique<Parameters>(parameters);
  static const std::vector<sim::ColliderShape> none;
  sim::Setting setting{false, 1, frameSeconds, &none};
  setting.contactSubsteps = contactSubsteps;
  return sim::simulationNamed(kind).make(object, setting);
}

/// Returns a function that advances a simulation by one frame per call.
template <class Simulation>
std::function<void()> frames(const std::shared_ptr<Simulation>& simulation, auto... arguments) {
  return [simulation, frame = 0, ... arguments = arguments]() mutable {
    simulation->step(frame++ * frameSeconds, arguments...);
  };
}

}  // namespace simreel::bench
