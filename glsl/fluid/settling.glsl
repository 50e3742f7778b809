// Cells that project.comp has made while others still read what they were: u, v and pressure where the solver's corrections have
// been, temperature beside its sums. After grid.glsl.
layout(std430, binding = nextFlowBinding) restrict buffer SettlingBlock { float settling[]; };
layout(std430, binding = nextDyeBinding) restrict buffer HeatBlock { float settlingHeat[]; };
uniform int heatStart;  // in settlingHeat
// Elsewhere no projection changes it.
const bool settlesHeat = heats && obstacles;

void settleLater(int element, vec4 cell) {
  settling[element] = cell.x;
  settling[planeSize() + element] = cell.y;
  settling[2 * planeSize() + element] = cell.w;
  if (settlesHeat) settlingHeat[heatStart + element] = cell.z;
}
