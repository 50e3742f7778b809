#include "sim/grid/tally.hpp"

#include "glsl/common/cpp.hpp"

#include <utility>

namespace simreel::shader::tally {
#include "glsl/grid/tally_types.glsl"
static_assert(tallyLanes == tallyJoined * tallyJoined);
}  // namespace simreel::shader::tally

namespace simreel::sim {

Tally::Tally(const std::string& name, const char* path, const gl::Defines& defines)
    : laneSums_(name + " lane sums", 2 * shader::tally::tallyLanes),
      joined_(name + " joined sums", 2 * shader::tally::tallyJoined),
      total_(name + " totals", 2),
      lanes_(gl::Program::compute(path, defines)),
      join_(gl::Program::compute("grid/tally_join.comp", defines)) {}

void Tally::take(const glm::vec4& sumFactor, const glm::vec4& mostFactor) {
  laneSums_.bindState(shader::tally::sumsOutBinding);
  gl::barrier();
  lanes_.dispatch(shader::tally::tallyLanes);
  join(laneSums_, joined_, shader::tally::tallyJoined, glm::vec4(1), glm::vec4(1));
  join(joined_, total_, 1, sumFactor, mostFactor);
  gl::barrier();
}

void Tally::join(const gl::Vec4Array& from, const gl::Vec4Array& to, int lanes, const glm::vec4& sumFactor,
                 const glm::vec4& mostFactor) const {
  from.bindInput(shader::tally::sumsInBinding);
  to.bindState(shader::tally::sumsOutBinding);
  join_.set("lanes", lanes);
  join_.set("sumFactor", sumFactor);
  join_.set("mostFactor", mostFactor);
  gl::barrier();
  join_.dispatch(lanes);
}

CountTable Tally::table(std::vector<const char*> columns) const {
  return {std::move(columns), &total_.buffer(), 1, 2, true};
}

}  // namespace simreel::sim
