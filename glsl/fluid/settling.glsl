// Buffer for cells that project.comp has finished while other invocations still read the old values. u, v and pressure
// are in the memory of the solver's corrections, and the temperature is in the memory next to the solver's sums.
// Include after grid.glsl.
layout(std430, binding = nextFlowBinding) restrict buffer SettlingBlock { float settling[]; };
layout(std430, binding = nextDyeBinding) restrict buffer HeatBlock { float settlingHeat[]; };
uniform int heatStart;  // Offset in settlingHeat at which the temperatures start
// True if the projection changes temperatures: inside obstacles, and beyond open sides, where they are 0.
const bool hasOpenSide =
    leftKind == openSide || rightKind == openSide || topKind == openSide || bottomKind == openSide;
const bool settlesHeat = heats && (obstacles || hasOpenSide);

void settleLater(int element, vec4 cell) {
  settling[element] = cell.x;
  settling[planeSize() + element] = cell.y;
  settling[2 * planeSize() + element] = cell.w;
  if (settlesHeat) settlingHeat[heatStart + element] = cell.z;
}
