// What bench_plain measures: a kernel beside a plain loop and a twin.
#pragma once
#include "sim/world/list.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace simreel::bench {

inline constexpr double frameSeconds = 1.0 / 60;

/// What an item takes at least, counted from the model's equations.
struct Least {
  double operations = 0;  ///< additions, multiplications, divisions, roots; 0: not counted
  double bytes = 0;       ///< of memory read and written
  double pass = 0;        ///< items between two times at which an item's memory is needed
};

/// Work in turns; `items` of a turn give rates.
struct Subject {
  const char* name;
  const char* unit;
  double items;
  std::function<void()> plain, twin, device;  ///< twin: may be missing
  Least least{};
  std::function<void()> after = {};  ///< prints more; may be missing
};

/// Runs the three in turns and prints a line.
void print(const Subject& subject);
/// What stands above those lines.
void printHeads();
/// Nothing but the kernel, for profilers.
void keepBusy(const Subject& subject, double seconds);

/// Cloth: a sheet of a fabric, cloth of a mesh, cloths that lie on one another.
[[nodiscard]] Subject fabricSheet();
[[nodiscard]] Subject meshCloth();
[[nodiscard]] Subject clothsInContact();

/// A tank of 512x512 cells with dye in three colours, temperature and an obstacle; a basin with islands.
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

/// Frame after frame of a simulation.
template <class Simulation>
std::function<void()> frames(const std::shared_ptr<Simulation>& simulation, auto... arguments) {
  return [simulation, frame = 0, ... arguments = arguments]() mutable {
    simulation->step(frame++ * frameSeconds, arguments...);
  };
}

}  // namespace simreel::bench
