#pragma once
#include <algorithm>

#include <tbb/parallel_for.h>

namespace simreel::golden {

/// Calls work(first, last) for bands of 32 rows (the last may have fewer), in any order and in parallel.
/// What a band computes must not depend on the others, so results do not depend on the thread count.
template <class Work>
void forEachBand(int height, const Work& work) {
  constexpr int rows = 32;
  tbb::parallel_for(0, (height + rows - 1) / rows,
                    [&](int band) { work(band * rows, std::min(height, (band + 1) * rows)); });
}

}  // namespace simreel::golden
