#include "golden/baseline/origin.hpp"

namespace simreel::golden {

Asked asked(const Origin& there, const Origin& here) {
  if (there.exact || here.exact) return Asked::exact;
  const bool sameDrawing = there.drawing.empty() || here.drawing.empty() || there.drawing == here.drawing;
  if (there.numerics != here.numerics || !sameDrawing) return Asked::tolerance;
  const bool known = !there.processor.empty() && !there.driver.empty();
  return known && there.processor == here.processor && there.driver == here.driver ? Asked::equal
                                                                                   : Asked::near;
}

const char* askedName(Asked asked) {
  switch (asked) {
    case Asked::exact:
      return "exact";
    case Asked::equal:
      return "equal";
    case Asked::near:
      return "near";
    case Asked::tolerance:
      break;
  }
  return "tolerance";
}

}  // namespace simreel::golden
