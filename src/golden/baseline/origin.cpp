#include "golden/baseline/origin.hpp"

namespace simreel::golden {

Asked asked(const Origin& there, const Origin& here) {
  const bool sameDrawing = there.drawing.empty() || here.drawing.empty() || there.drawing == here.drawing;
  if (there.numerics != here.numerics || !sameDrawing) return Asked::tolerance;
  const bool known = !there.processor.empty() && !there.driver.empty();
  return known && there.processor == here.processor && there.driver == here.driver ? Asked::equal
                                                                                   : Asked::near;
}

const char* askedName(Asked asked) {
  return asked == Asked::equal ? "equal" : asked == Asked::near ? "near" : "tolerance";
}

}  // namespace simreel::golden
