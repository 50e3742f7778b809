#include "golden/baseline/origin.hpp"

namespace simreel::golden {

RequiredMatch requiredMatch(const Origin& there, const Origin& here) {
  if (there.exact || here.exact) return RequiredMatch::exact;
  const bool sameDrawing = there.drawing.empty() || here.drawing.empty() || there.drawing == here.drawing;
  if (there.numerics != here.numerics || !sameDrawing) return RequiredMatch::tolerance;
  const bool known = !there.processor.empty() && !there.driver.empty();
  return known && there.processor == here.processor && there.driver == here.driver ? RequiredMatch::equal
                                                                                   : RequiredMatch::near;
}

const char* requiredMatchName(RequiredMatch requiredMatch) {
  switch (requiredMatch) {
    case RequiredMatch::exact:
      return "exact";
    case RequiredMatch::equal:
      return "equal";
    case RequiredMatch::near:
      return "near";
    case RequiredMatch::tolerance:
      break;
  }
  return "tolerance";
}

}  // namespace simreel::golden
