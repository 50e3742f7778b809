#include "sim/grid/tally.hpp"

#include "glsl/common/cpp.hpp"

#include <utility>

namespace simreel::shader::tally {
#include "glsl/grid/tally_types.glsl"
static_assert(tallyLanes == tallyJoined * tallyJoined);
}  // namespace simreel::shader::tally

namespace simreel::sim {

struct TallyJoin {
  static constexpr auto file = "grid/tally_join.comp";
  gl::Uniform<"lanes", int> lanes;
  gl::Uniform<"sumFactor", glm::vec4> sumFactor;
  gl::Uniform<"maxFactor", glm::vec4> maxFactor;
  gl::In<"lanesBefore"> before;
  gl::Out<"joined"> joined;
};

const int Tally::lanes = shader::tally::tallyLanes;

Tally::Tally(const std::string& name, const gl::Defines& defines)
    : laneSums_(name + " lane sums", 2 * shader::tally::tallyLanes),
      joined_(name + " joined sums", 2 * shader::tally::tallyJoined),
      total_(name + " totals", 2),
      join_(defines) {}

void Tally::join(const glm::vec4& sumFactor, const glm::vec4& maxFactor) const {
  const glm::vec4 one(1);
  const int some = shader::tally::tallyJoined;
  join_.dispatch(some, {some, one, one, laneSums_, joined_});
  join_.dispatch(1, {1, sumFactor, maxFactor, joined_, total_});
  gl::barrier();
}

CountTable Tally::table(std::vector<const char*> columns) const {
  return {std::move(columns), &total_.buffer(), 1, 2, true};
}

}  // namespace simreel::sim
