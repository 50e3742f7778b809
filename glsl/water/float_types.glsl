// Uniform data of floating bodies. Compiles as GLSL and as C++ (src/sim/water/float_plan.hpp). Positions are in metres
// from the grid's centre, with y above level 0.

struct STD140 FloatStep {
  float dt;             // Duration of a step in seconds
  float gravity;        // Gravity in m/s^2
  float density;        // Density of the water, kg/m^3
  float perCell;        // 1 / cell size, 1/m
  float columns;        // Half the number of columns; the next member is half the number of rows
  float rows;
  float halfX;          // Half the size of the grid along x and along z, m
  float halfZ;
  float depthUnit;      // Depth in metres of one unit of the integer sums
  float perDepthUnit;   // Units per volume: 1 / (depthUnit * cell area), 1/m^3
  float flowUnit;       // Discharge in m^2/s of one unit of the integer sums
  float perFlowUnit;    // Units per force: dt / (density * flowUnit * cell area), 1/N
  float stiff;          // Contact stiffness: acceleration per metre of penetration, 1/s^2
  float damp;           // Contact damping: acceleration per speed into the surface, 1/s
  float deepest;        // Penetration in metres beyond which the contact acceleration does not increase
  float thin;           // Depth below which water is thin, m, as in WaterStep
  float dry;            // Depth below which a cell is dry, m
  float maximum;           // Maximum horizontal speed, m/s
  int west;             // Boundary kind of each side
  int east;
  int north;
  int south;
  int count;            // Number of bodies
};

// Number of texels of a body's state. The texels are: (1) xyz centre of mass, w reference level (m); (2) rotation
// quaternion; (3) xyz velocity, w volume below the reference level (m^3); (4) angular momentum (kg m^2/s); (5) xy first
// two stages of the reference level (m), z mean water level over the body's points (m), w volume below the water level
// (m^3).
const int floatTexels = 5;

// Parameters of a body for one frame.
struct FloatParameters {
  vec4 mass;    // x mass (kg); y 1 / mass; z bounding radius for contact (m); w moment of inertia about y (kg m^2)
  vec4 turnA;   // xyz inverse inertia tensor xx, yy, zz (1/(kg m^2)); w index of its first point
  vec4 turnB;   // xyz inverse inertia tensor xy, xz, yz; w index past its last point
  vec4 grain;   // xyz size of the cuboids that the body's points represent (m); w volume of the body (m^3)
  // x linear drag (1/s); y quadratic drag (1/m); z additional factor for sideways motion (factor - 1); w mass per area
  // and water density (m)
  vec4 drag;
  // x half the width of the body's window (cells); y fraction by which a stage of the reference level follows per step;
  // z friction coefficient; w thrust (N)
  vec4 reach;
  vec4 tow;     // xy tow target (x, z) at the start of the frame; zw velocity of the target
  // xy tow direction (x, z); z steering moment divided by the mean squared distance of the body's volume from its y
  // axis (N/m); w air drag (1/s)
  vec4 head;
  vec4 pull;    // x stiffness of the tow line (1/s^2); y its damping (1/s); zw the same for the direction
  // x index of the body's first probe; y index past its last probe; z index of its first distance; w radius of a sphere
  // (m), or 0 for a lattice
  vec4 meet;
  // xyz position of the first lattice point relative to the centre of mass (m); w 1 / lattice spacing (1/m)
  vec4 field;
  vec4 nodes;   // xyz number of lattice points along each axis; w lattice spacing (m)
};
const int floatParameterTexels = 12;
const float floatOut = 0.02f;   // Fraction of the penetration depth that a step removes
// Fraction of the approach speed that a step removes; below 1 because a body may touch several others
const float floatEase = 0.8f;
const int floatLanes = 64;  // Number of invocations that process the points of a body
