#ifndef FLUID_BINDINGS
#define FLUID_BINDINGS

const int flowBinding = 0;      // Flow: u, v, temperature, pressure
const int carriedBinding = 1;   // Flow after the first advection
const int dyeBinding = 2;
const int nextFlowBinding = 3;
const int keptBinding = 8;      // Buffer declared in kept.glsl
const int nextDyeBinding = 4;
const int weightsBinding = 5;
const int controlBinding = 6;   // Buffer declared in solve_control.glsl
const int poolBinding = 0;      // In solver kernels: sums, residuals, corrections on the way to coarser levels
const int raisedBinding = 1;    // In solver kernels: corrections on the way to finer levels
const int poolOutBinding = 3;   // The array of poolBinding as an output; raisedOutBinding is the array of raisedBinding
                                // as an output
const int raisedOutBinding = 4;
const int brushesBinding = 1;   // Binding points of uniform blocks: brushesBinding and the two constants after it
const int solidsBinding = 2;
const int levelBinding = 3;
const int stampsBinding = 1;    // Bit masks of brush images

#endif
