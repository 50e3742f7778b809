#ifndef FLUID_BINDINGS
#define FLUID_BINDINGS

const int flowBinding = 0;      // u, v, temperature, pressure
const int carriedBinding = 1;   // the flow carried along once
const int dyeBinding = 2;
const int nextFlowBinding = 3;
const int keptBinding = 8;      // kept.glsl
const int nextDyeBinding = 4;
const int weightsBinding = 5;
const int controlBinding = 6;   // solve_control.glsl
const int poolBinding = 0;      // of kernels that solve: sums, residuals, corrections on the way down
const int raisedBinding = 1;    // and corrections on the way up
const int poolOutBinding = 3;   // the same, to be written
const int raisedOutBinding = 4;
const int brushesBinding = 1;   // of uniform blocks
const int solidsBinding = 2;
const int levelBinding = 3;
const int stampsBinding = 1;    // images of brushes

#endif
