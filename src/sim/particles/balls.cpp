#include "sim/particles/balls.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <bit>
#include <cstdint>
#include <utility>

namespace simreel::sim {

struct BallKey {
  static constexpr auto file = "particles/contact/key.comp";
  gl::Block<"StepBlock", shader::ParticleStep> step;
  gl::InOut<"StatusBlock"> status;
  gl::In<"positions"> positions;
  gl::In<"starts"> starts;
  gl::In<"velocities"> velocities;
  gl::Out<"records"> records;
};

/// Variant of the kernels that do not handle solids.
struct BallVariant {
  gl::Flag<"ROLLS"> rolls;
};

struct BallGather {
  static constexpr auto file = "particles/contact/gather.comp";
  using Variant = BallVariant;
  gl::Block<"StepBlock", shader::ParticleStep> step;
  gl::Uniform<"stamp", int> stamp;
  gl::In<"positions"> positions;
  gl::In<"starts"> starts;
  gl::In<"velocities"> velocities;
  gl::In<"records"> records;
  gl::Out<"guesses"> guesses;
  gl::Out<"begins"> begins;
  gl::Out<"speeds"> speeds;
  gl::Out<"table"> table;
  gl::In<"spins"> spins = {};
  gl::Out<"nextSpins"> nextSpins = {};
};

struct BallNear {
  static constexpr auto file = "particles/contact/near.comp";
  gl::Block<"StepBlock", shader::ParticleStep> step;
  gl::Uniform<"stamp", int> stamp;
  gl::In<"guesses"> guesses;
  gl::In<"begins"> begins;
  gl::In<"table"> table;
  gl::Out<"places"> places;
  gl::Out<"lists"> lists;
};

struct BallChoose {
  static constexpr auto file = "particles/contact/choose.comp";
  gl::Block<"StepBlock", shader::ParticleStep> step;
  gl::In<"places"> places;
  gl::In<"begins"> begins;
  gl::In<"speeds"> speeds;
  gl::In<"lists"> lists;
  gl::Out<"choices"> choices;
};

struct BallStrike {
  static constexpr auto file = "particles/contact/strike.comp";
  using Variant = ParticleSolids;
  gl::Block<"StepBlock", shader::ParticleStep> step;
  TouchPart touch;
  gl::InOut<"StatusBlock"> status;
  gl::In<"places"> places;
  gl::In<"begins"> begins;
  gl::In<"guesses"> guesses;
  gl::In<"speeds"> speeds;
  gl::In<"choices"> choices;
  gl::Out<"nextPlaces"> next;
  gl::Out<"nextSpeeds"> nextSpeeds;
  gl::In<"spins"> spins = {};
  gl::Out<"nextSpins"> nextSpins = {};
};

struct BallSolve {
  static constexpr auto file = "particles/contact/solve.comp";
  using Variant = ParticleSolids;
  gl::Block<"StepBlock", shader::ParticleStep> step;
  TouchPart touch;
  gl::InOut<"StatusBlock"> status;
  gl::In<"places"> places;
  gl::In<"begins"> begins;
  gl::In<"guesses"> guesses;
  gl::In<"lists"> lists;
  gl::Out<"nextPlaces"> next;
  gl::Uniform<"perRoll", float> perRoll = {};
  gl::In<"rolls"> rolls = {};
  gl::Out<"nextRolls"> nextRolls = {};
};

struct BallLeave {
  static constexpr auto file = "particles/contact/leave.comp";
  using Variant = BallVariant;
  gl::Block<"StepBlock", shader::ParticleStep> step;
  gl::In<"places"> places;
  gl::In<"begins"> begins;
  gl::In<"guesses"> guesses;
  gl::In<"struck"> struck;
  gl::In<"speeds"> speeds;
  gl::In<"lists"> lists;
  gl::In<"records"> records;
  gl::Out<"positions"> positions;
  gl::Out<"velocities"> velocities;
  gl::In<"rolls"> rolls = {};
  gl::Out<"spins"> spins = {};
  gl::InOut<"turns"> turns = {};
};

namespace {

/// Returns `count` after a check that lists of `listed` words per particle fit the device.
int checked(const std::string& name, int count, int listed) {
  const std::int64_t each = std::int64_t{4} * listed;
  const std::int64_t maximum =
      std::min(gl::limits().storageBlockBytes, 16 * gl::limits().texelBufferTexels) / each;
  if (count > maximum)
    fail(ExitCode::device,
         "contact of particles \"{}\" takes at most {} of them on this device, not {} "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE is {}); use fewer",
         name, maximum, count, gl::limits().storageBlockBytes);
  return count;
}

}  // namespace

BallContact::BallContact(const std::string& name, const ParticlePlan& plan, const ParticleSolids& solids,
                         bool fast)
    : substepSeconds_(static_cast<float>(plan.substepSeconds())),
      rolls_(plan.rolls()),
      count_(checked(name, plan.count(), plan.ballConstants().listed)),
      impacts_(plan.ballImpacts()),
      keyBits_((std::bit_width(static_cast<unsigned>(plan.ballConstants().tableMask)) + 3) / 4 * 4),
      sort_(name + " contact order", count_) {
  const shader::BallConstants& balls = plan.ballConstants();
  table_ = gl::WordsArray(name + " contact table", balls.tableMask + 1);
  lists_ = gl::WordsArray(name + " contact lists", balls.listed / 4 * count_);
  choices_ = gl::WordsArray(name + " contact choices", count_);
  for (gl::Vec4Array* array :
       {&guesses_, &begins_, &speeds_[0], &speeds_[1], &places_[0], &places_[1], &struck_})
    *array = gl::Vec4Array(name + " contact", count_);
  if (rolls_)
    for (gl::Vec4Array& array : turning_) array = gl::Vec4Array(name + " contact", count_);
  const gl::Defines defines = gl::kernelDefines(fast);
  key_ = gl::Kernel<BallKey>(defines);
  gather_ = gl::Kernel<BallGather>(defines, {rolls_});
  near_ = gl::Kernel<BallNear>(defines);
  choose_ = gl::Kernel<BallChoose>(defines);
  strike_ = gl::Kernel<BallStrike>(defines, solids);
  solve_ = gl::Kernel<BallSolve>(defines, solids);
  leave_ = gl::Kernel<BallLeave>(defines, {rolls_});
}

void BallContact::search(const ParticlePart& part, const gl::Vec4Array& starts,
                         const gl::Vec4Array& positions, const gl::Vec4Array& velocities) {
  ++stamp_;
  key_.dispatch(count_, {.step = part.step,
                         .status = part.status,
                         .positions = positions,
                         .starts = starts,
                         .velocities = velocities,
                         .records = sort_.records()});
  sort_.sort(count_, keyBits_, 0);
  gather_.dispatch(count_, {.step = part.step,
                            .stamp = stamp_,
                            .positions = positions,
                            .starts = starts,
                            .velocities = velocities,
                            .records = sort_.records(),
                            .guesses = guesses_,
                            .begins = begins_,
                            .speeds = speeds_[0],
                            .table = table_,
                            .spins = part.spins,
                            .nextSpins = turning_[0]});
  near_.dispatch(count_, {.step = part.step,
                          .stamp = stamp_,
                          .guesses = guesses_,
                          .begins = begins_,
                          .table = table_,
                          .places = struck_,
                          .lists = lists_});
}

void BallContact::strike(const ParticlePart& part) {
  for (int i = 0; i < impacts_; ++i) {
    choose_.dispatch(count_, {.step = part.step,
                              .places = struck_,
                              .begins = begins_,
                              .speeds = speeds_[0],
                              .lists = lists_,
                              .choices = choices_});
    strike_.dispatch(count_, {.step = part.step,
                              .touch = part.touch,
                              .status = part.status,
                              .places = struck_,
                              .begins = begins_,
                              .guesses = guesses_,
                              .speeds = speeds_[0],
                              .choices = choices_,
                              .next = places_[0],
                              .nextSpeeds = speeds_[1],
                              .spins = turning_[0],
                              .nextSpins = turning_[1]});
    std::swap(turning_[0], turning_[1]);
    std::swap(struck_, places_[0]);
    std::swap(speeds_[0], speeds_[1]);
  }
}

void BallContact::solve(const ParticlePart& part, const gl::Vec4Array& starts,
                        const gl::Vec4Array& positions, const gl::Vec4Array& velocities,
                        const gl::Vec4Array& turns) {
  search(part, starts, positions, velocities);
  strike(part);
  for (int i = 0; i < shader::ballIterations; ++i) {
    solve_.dispatch(count_, {.step = part.step,
                             .touch = part.touch,
                             .status = part.status,
                             .places = i == 0 ? struck_ : places_[0],
                             .begins = begins_,
                             .guesses = guesses_,
                             .lists = lists_,
                             .next = places_[1],
                             .perRoll = i == 0 ? substepSeconds_ : 1.0F,
                             .rolls = turning_[0],
                             .nextRolls = turning_[1]});
    std::swap(turning_[0], turning_[1]);
    std::swap(places_[0], places_[1]);
  }
  leave_.dispatch(count_, {.step = part.step,
                           .places = places_[0],
                           .begins = begins_,
                           .guesses = guesses_,
                           .struck = struck_,
                           .speeds = speeds_[0],
                           .lists = lists_,
                           .records = sort_.records(),
                           .positions = positions,
                           .velocities = velocities,
                           .rolls = turning_[0],
                           .spins = part.spins,
                           .turns = turns});
}

}  // namespace simreel::sim
