#include "kernels/exact/calls.hpp"

#include <GLSL.std.450.h>
#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

/// Returns the library function for an operation that drivers compute equally, except that some do not
/// flush subnormal results to zero; nullptr for other operations.
const char* flushingFunctionFor(SpvOp op) {
  switch (op) {
    case SpvOpFMul:
    case SpvOpVectorTimesScalar:
      return "xMul";
    case SpvOpFAdd:
      return "xAdd";
    case SpvOpFSub:
      return "xSub";
    default:
      return nullptr;
  }
}

/// Returns the library function for a floating-point operation, or for an integer operation with undefined
/// cases; nullptr for other operations.
const char* functionFor(SpvOp op) {
  switch (op) {
    case SpvOpFDiv:
      return "xDiv";
    case SpvOpFMod:
      return "xMod";
    case SpvOpFRem:
      return "xRem";
    case SpvOpDot:
      return "xDot";
    case SpvOpMatrixTimesVector:
    case SpvOpVectorTimesMatrix:
    case SpvOpMatrixTimesMatrix:
    case SpvOpMatrixTimesScalar:
      return "xTimes";
    case SpvOpOuterProduct:
      return "xOuter";
    case SpvOpConvertFToS:
      return "xToInt";
    case SpvOpConvertFToU:
      return "xToUint";
    case SpvOpIsNan:
      return "xIsNan";
    case SpvOpIsInf:
      return "xIsInf";
    case SpvOpUDiv:
      return "xUdiv";
    case SpvOpUMod:
      return "xUmod";
    case SpvOpSDiv:
      return "xSdiv";
    case SpvOpSRem:
    case SpvOpSMod:  // glslang emits SMod for %, but all drivers give the result the sign of the first
                     // operand.
      return "xSrem";
    default:
      return nullptr;
  }
}

/// Returns the library function for a GLSL.std.450 instruction. Returns nullptr if the instruction is exact
/// on all drivers.
const char* functionFor(std::uint32_t extended) {
  static constexpr std::pair<std::uint32_t, const char*> functions[] = {
      {GLSLstd450Round, "xRound"},
      {GLSLstd450FSign, "xSign"},
      {GLSLstd450Fract, "xFract"},
      {GLSLstd450Radians, "xRadians"},
      {GLSLstd450Degrees, "xDegrees"},
      {GLSLstd450Sin, "xSin"},
      {GLSLstd450Cos, "xCos"},
      {GLSLstd450Tan, "xTan"},
      {GLSLstd450Asin, "xAsin"},
      {GLSLstd450Acos, "xAcos"},
      {GLSLstd450Atan, "xAtan"},
      {GLSLstd450Sinh, "xSinh"},
      {GLSLstd450Cosh, "xCosh"},
      {GLSLstd450Tanh, "xTanh"},
      {GLSLstd450Asinh, "xAsinh"},
      {GLSLstd450Acosh, "xAcosh"},
      {GLSLstd450Atanh, "xAtanh"},
      {GLSLstd450Atan2, "xAtan2"},
      {GLSLstd450Pow, "xPow"},
      {GLSLstd450Exp, "xExp"},
      {GLSLstd450Log, "xLog"},
      {GLSLstd450Exp2, "xExp2"},
      {GLSLstd450Log2, "xLog2"},
      {GLSLstd450Sqrt, "xSqrt"},
      {GLSLstd450InverseSqrt, "xInverseSqrt"},
      {GLSLstd450Determinant, "xDeterminant"},
      {GLSLstd450MatrixInverse, "xInverse"},
      {GLSLstd450FMin, "xMin"},
      {GLSLstd450FMax, "xMax"},
      {GLSLstd450FClamp, "xClamp"},
      {GLSLstd450NMin, "xMin"},
      {GLSLstd450NMax, "xMax"},
      {GLSLstd450NClamp, "xClamp"},
      {GLSLstd450FMix, "xMix"},
      {GLSLstd450Step, "xStep"},
      {GLSLstd450SmoothStep, "xSmoothstep"},
      {GLSLstd450Fma, "xFma"},
      {GLSLstd450Ldexp, "xLdexp"},
      {GLSLstd450PackSnorm4x8, "xPackSnorm4x8"},
      {GLSLstd450PackUnorm4x8, "xPackUnorm4x8"},
      {GLSLstd450PackSnorm2x16, "xPackSnorm2x16"},
      {GLSLstd450PackUnorm2x16, "xPackUnorm2x16"},
      {GLSLstd450PackHalf2x16, "xPackHalf2x16"},
      {GLSLstd450UnpackSnorm2x16, "xUnpackSnorm2x16"},
      {GLSLstd450UnpackUnorm2x16, "xUnpackUnorm2x16"},
      {GLSLstd450UnpackHalf2x16, "xUnpackHalf2x16"},
      {GLSLstd450UnpackSnorm4x8, "xUnpackSnorm4x8"},
      {GLSLstd450UnpackUnorm4x8, "xUnpackUnorm4x8"},
      {GLSLstd450Length, "xLength"},
      {GLSLstd450Distance, "xDistance"},
      {GLSLstd450Cross, "xCross"},
      {GLSLstd450Normalize, "xNormalize"},
      {GLSLstd450FaceForward, "xFaceForward"},
      {GLSLstd450Reflect, "xReflect"},
      {GLSLstd450Refract, "xRefract"},
  };
  for (const auto& [number, function] : functions)
    if (number == extended) return function;
  return nullptr;
}

bool isArithmetic(SpvOp op) {
  switch (op) {
    case SpvOpFAdd:
    case SpvOpFSub:
    case SpvOpFMul:
    case SpvOpFDiv:
    case SpvOpFNegate:
    case SpvOpVectorTimesScalar:
    case SpvOpMatrixTimesScalar:
    case SpvOpMatrixTimesVector:
    case SpvOpVectorTimesMatrix:
    case SpvOpMatrixTimesMatrix:
    case SpvOpDot:
      return true;
    default:
      return false;
  }
}

class Placing {
 public:
  Placing(Module& module, Language language, bool careful)
      : module_(module),
        set_(module.extendedSet(false)),
        hlsl_(language == Language::hlsl),
        careful_(careful) {}

  std::vector<PlacedCall> run() {
    std::vector<Instruction> body = std::move(module_.body);
    module_.body.clear();
    module_.body.reserve(body.size() * 5 / 4);
    for (Instruction& one : body) place(one);
    return std::move(calls_);
  }

 private:
  void place(Instruction& one) {
    if (one.op == SpvOpExtInst && one.operands[0] == set_ && splitColumns(one)) return;
    if (one.op == SpvOpShiftLeftLogical || one.op == SpvOpShiftRightLogical ||
        one.op == SpvOpShiftRightArithmetic)
      maskShift(one);
    const char* function = nullptr;
    Words arguments = one.operands;
    if (one.op == SpvOpExtInst && one.operands[0] == set_) {
      function = functionFor(one.operands[1]);
      arguments.erase(arguments.begin(), arguments.begin() + 2);
    } else if (!dividesByConstant(one)) {
      // glslang emits FMod for fmod and %. In HLSL the result has the sign of the first operand.
      function = one.op == SpvOpFMod && hlsl_ ? "xRem" : functionFor(one.op);
      if (careful_ || hasTinyFactor(one))
        if (const char* flushing = flushingFunctionFor(one.op); flushing != nullptr) function = flushing;
      if ((one.op == SpvOpSRem || one.op == SpvOpSMod) && isPositiveConstant(one.operands[1]))
        function = "xSremBy";
    }
    if (function != nullptr && one.op == SpvOpVectorTimesScalar)
      arguments[1] = spread(one.type, arguments[1]);
    if (function == nullptr || !call(one, function, arguments)) module_.body.push_back(std::move(one));
  }

  /// Splits a function of matrices, such as min, into one instruction per column, because SPIR-V has such
  /// functions for vectors only. Returns false for other instructions.
  bool splitColumns(const Instruction& one) {
    const Instruction* known = module_.global(one.type);
    const bool whole = one.operands[1] == GLSLstd450MatrixInverse;
    if (whole || known == nullptr || known->op != SpvOpTypeMatrix) return false;
    const Id column = known->operands[0];
    const std::uint32_t count = known->operands[1];
    Words columns;
    for (std::uint32_t i = 0; i < count; ++i) {
      Instruction part{SpvOpExtInst, column, module_.fresh(), {one.operands[0], one.operands[1]}};
      for (std::size_t k = 2; k < one.operands.size(); ++k) {
        const Id taken = module_.fresh();
        module_.noteType(taken, column);
        module_.body.push_back({SpvOpCompositeExtract, column, taken, {one.operands[k], i}});
        part.operands.push_back(taken);
      }
      columns.push_back(part.result);
      module_.noteType(part.result, column);
      place(part);
    }
    module_.body.push_back({SpvOpCompositeConstruct, one.type, one.result, columns});
    return true;
  }

  /// Replaces an instruction by a library call. Returns false for types that the library does not support.
  bool call(const Instruction& one, const char* function, const Words& arguments) {
    std::string key = std::string(function) + "(";
    for (const Id argument : arguments) {
      const std::string signature = module_.signature(module_.typeOf(argument));
      if (signature == "?") return false;
      key += signature + ";";
    }
    // The parameters of library functions are either signed or unsigned, but SPIR-V instructions accept
    // both.
    Words given = arguments;
    retype(function, given, key);
    Id result = one.result, type = one.type;
    const Id made = resultType(function, type);
    if (made != type) result = module_.fresh();
    Instruction placed{SpvOpFunctionCall, made, result, {0}};
    placed.operands.insert(placed.operands.end(), given.begin(), given.end());
    calls_.push_back({module_.body.size(), key});
    module_.noteType(result, made);
    module_.body.push_back(std::move(placed));
    if (made != type) module_.body.push_back({SpvOpBitcast, type, one.result, {result}});
    return true;
  }

  /// Bitcasts integer arguments to the signedness of the function's parameters.
  void retype(std::string_view function, Words& arguments, std::string& key) {
    const bool isUnsigned = function == "xUdiv" || function == "xUmod" || function.starts_with("xUnpack");
    const bool isSigned = function == "xSdiv" || function.starts_with("xSrem");
    const bool isLdexp = function == "xLdexp";
    if (!isUnsigned && !isSigned && !isLdexp) return;
    key = std::string(function) + "(";
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const Id type = module_.typeOf(arguments[i]);
      const Id wanted = isLdexp && i == 0 ? type : ofSign(type, !isUnsigned);
      if (wanted != type) {
        const Id cast = module_.fresh();
        module_.noteType(cast, wanted);
        module_.body.push_back({SpvOpBitcast, wanted, cast, {arguments[i]}});
        arguments[i] = cast;
      }
      key += module_.signature(wanted) + ";";
    }
  }

  /// Returns the result type of the function. Its signedness may differ from the signedness of the
  /// instruction's result.
  Id resultType(std::string_view function, Id type) {
    if (function == "xUdiv" || function == "xUmod" || function == "xToUint" ||
        function.starts_with("xPack"))
      return ofSign(type, false);
    if (function == "xSdiv" || function.starts_with("xSrem") || function == "xToInt")
      return ofSign(type, true);
    return type;
  }

  Id ofSign(Id type, bool isSigned) {
    const Instruction made = *module_.global(type);
    const Id whole = module_.globalOf(SpvOpTypeInt, 0, {32, isSigned ? 1U : 0U});
    return made.op == SpvOpTypeVector ? module_.vectorType(whole, made.operands[1]) : whole;
  }

  Id spread(Id vector, Id scalar) {
    const Instruction type = *module_.global(vector);
    const Id made = module_.fresh();
    module_.noteType(made, vector);
    module_.body.push_back({SpvOpCompositeConstruct, vector, made, Words(type.operands[1], scalar)});
    return made;
  }

  /// Returns true for an integer division by a positive constant; all drivers give the same result for it.
  bool dividesByConstant(const Instruction& one) const {
    return (one.op == SpvOpUDiv || one.op == SpvOpUMod || one.op == SpvOpSDiv) &&
           isPositiveConstant(one.operands[1]);
  }

  /// True for a constant integer or vector whose components are all positive as signed numbers.
  bool isPositiveConstant(Id id) const {
    const auto positive = [&](Id component) {
      const auto value = module_.constant(component);
      return value && *value != 0 && *value < 0x80000000U;
    };
    const Instruction* made = module_.global(id);
    if (made == nullptr) return false;
    return made->op == SpvOpConstantComposite
               ? std::all_of(made->operands.begin(), made->operands.end(), positive)
               : positive(id);
  }

  /// True for a product with a constant below 2^-62 in magnitude. A compiler may compute such a product
  /// without flushing it.
  bool hasTinyFactor(const Instruction& one) const {
    if (one.op != SpvOpFMul && one.op != SpvOpVectorTimesScalar) return false;
    const auto tiny = [&](Id id) {
      const std::uint32_t bits = module_.constant(id).value_or(0) & 0x7fffffffU;
      return bits > 0 && bits < 0x20800000U;
    };
    return std::any_of(one.operands.begin(), one.operands.end(), [&](Id id) {
      const Instruction* made = module_.global(id);
      if (made == nullptr) return false;
      return made->op == SpvOpConstantComposite
                 ? std::any_of(made->operands.begin(), made->operands.end(), tiny)
                 : tiny(id);
    });
  }

  /// Masks shift counts modulo 32, as in Direct3D.
  void maskShift(Instruction& one) {
    const auto small = [&](Id id) {
      const auto value = module_.constant(id);
      return value && *value < 32;
    };
    const Instruction* made = module_.global(one.operands[1]);
    if (made != nullptr &&
        (small(one.operands[1]) || (made->op == SpvOpConstantComposite &&
                                    std::all_of(made->operands.begin(), made->operands.end(), small))))
      return;
    const Id type = module_.typeOf(one.operands[1]);
    const Instruction* shape = module_.global(type);
    if (shape == nullptr) return;
    const bool vector = shape->op == SpvOpTypeVector;
    const std::uint32_t length = vector ? shape->operands[1] : 1;
    const Id component = vector ? shape->operands[0] : type;
    Id mask = module_.globalOf(SpvOpConstant, component, {31});
    if (vector) mask = module_.globalOf(SpvOpConstantComposite, type, Words(length, mask));
    const Id held = module_.fresh();
    module_.noteType(held, type);
    module_.body.push_back({SpvOpBitwiseAnd, type, held, {one.operands[1], mask}});
    one.operands[1] = held;
  }

  Module& module_;
  Id set_;
  bool hlsl_;
  bool careful_;
  std::vector<PlacedCall> calls_;
};

}  // namespace

void forbidContraction(Module& module) {
  std::vector<Id> marked;
  for (const Instruction& one : module.decorations)
    if (one.op == SpvOpDecorate && one.operands[1] == SpvDecorationNoContraction)
      marked.push_back(one.operands[0]);
  std::sort(marked.begin(), marked.end());
  for (const Instruction& one : module.body)
    if (isArithmetic(one.op) && !std::binary_search(marked.begin(), marked.end(), one.result))
      module.decorate(one.result, SpvDecorationNoContraction);
}

std::vector<PlacedCall> placeCalls(Module& module, Language language, bool careful) {
  std::vector<PlacedCall> calls = Placing(module, language, careful).run();
  forbidContraction(module);
  return calls;
}

}  // namespace simreel::kernels
