// What kernels are told of bodies that float. Compiles as GLSL and as C++ (src/sim/water/float_plan.hpp). Places are in
// metres from the grid's middle, y over level 0.

struct STD140 FloatStep {
  float dt;             // s
  float gravity;        // m/s^2
  float density;        // of the water (kg/m^3)
  float perCell;        // 1 / side of a cell (1/m)
  float columns;        // half the grid (cells)
  float rows;
  float halfX;          // m
  float halfZ;
  float depthUnit;      // m: sums of depth are whole multiples of it
  float perDepthUnit;   // of a volume: 1 / (unit area of a cell) (1/m^3)
  float flowUnit;       // m^2/s: and sums of discharge of this
  float perFlowUnit;    // of a force: dt / (density unit area of a cell) (1/N)
  float stiff;          // acceleration of what touches for each m that it is too deep (1/s^2)
  float damp;           // and for its speed into what it touches (1/s)
  float deepest;        // m: what is deeper is pushed out no faster
  float thin;           // m, as WaterStep has it
  float dry;            // m
  float most;           // m/s: greatest speed along the grid
  int west;             // sides
  int east;
  int north;
  int south;
  int count;            // of bodies
};

// State of a body, in texels: place of the middle of mass, w the reference level (m); quaternion; velocity, w the volume under
// the reference level (m^3); angular momentum (kg m^2/s); both stages before the reference level (m), mean level of the water
// over its points (m), volume under the water (m^3).
const int floatTexels = 5;

// What a frame is told of each body.
struct FloatTold {
  vec4 mass;    // kg, 1 / mass, radius around all that others touch (m), moment of inertia about y (kg m^2)
  vec4 turnA;   // inverse moments of inertia xx, yy, zz (1/(kg m^2)), number of its first point
  vec4 turnB;   // xy, xz, yz, number behind its last point
  vec4 grain;   // sides of the cuboids that its points stand for (m), its volume (m^3)
  vec4 drag;    // linear (1/s), quadratic (1/m), more of it sideways (factor - 1), mass by area and density (m)
  vec4 reach;   // half of its window (cells), share by which a stage of its reference level follows in a step, friction, push (N)
  vec4 tow;     // target at the frame's beginning (x, z), its speed
  vec4 head;    // direction there (x, z), turning moment over the mean square way of its volume off its y (N/m), drag of the air (1/s)
  vec4 pull;    // stiffness and damping of the tow (1/s^2, 1/s) and of the direction
  vec4 meet;    // numbers of its first probe, behind its last one, of its first distance; radius (m) of what is a sphere, else 0
  vec4 field;   // where the distances begin (m from the middle of mass), 1 / their spacing (1/m)
  vec4 nodes;   // how many there are along x, y, z, their spacing (m)
};
const int floatToldTexels = 12;
const float floatOut = 0.02f;   // part of their depth by which floats that touch go apart in a step
const float floatEase = 0.8f;   // part of the speed into each other that a step takes, for a float may touch several
const int floatLanes = 64;  // that share a body's points
