// Determines which operands of an instruction are ids.
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

namespace {

/// Returns the number of id operands before the literals, for instructions that end in literals. Returns -1
/// if all operands are ids.
int idsBeforeLiterals(SpvOp op) {
  switch (op) {
    case SpvOpTypeInt:
    case SpvOpTypeFloat:
    case SpvOpConstant:
    case SpvOpSpecConstant:
    case SpvOpString:
    case SpvOpExtInstImport:
    case SpvOpCapability:
    case SpvOpExtension:
    case SpvOpMemoryModel:
    case SpvOpSource:
    case SpvOpSourceContinued:
    case SpvOpSourceExtension:
    case SpvOpModuleProcessed:
      return 0;
    case SpvOpTypeVector:
    case SpvOpTypeMatrix:
    case SpvOpTypeImage:
    case SpvOpLoad:
    case SpvOpCompositeExtract:
    case SpvOpSelectionMerge:
    case SpvOpArrayLength:
    case SpvOpName:
    case SpvOpMemberName:
    case SpvOpDecorate:
    case SpvOpMemberDecorate:
    case SpvOpExecutionMode:
    case SpvOpLine:
      return 1;
    case SpvOpStore:
    case SpvOpCompositeInsert:
    case SpvOpVectorShuffle:
    case SpvOpLoopMerge:
    case SpvOpCopyMemory:
      return 2;
    case SpvOpBranchConditional:
      return 3;
    default:
      return -1;
  }
}

/// Returns the index of the image operands mask of an image instruction; -1 for other instructions.
int imageMask(SpvOp op) {
  switch (op) {
    case SpvOpImageSampleImplicitLod:
    case SpvOpImageSampleExplicitLod:
    case SpvOpImageSampleProjImplicitLod:
    case SpvOpImageSampleProjExplicitLod:
    case SpvOpImageFetch:
    case SpvOpImageRead:
      return 2;
    case SpvOpImageSampleDrefImplicitLod:
    case SpvOpImageSampleDrefExplicitLod:
    case SpvOpImageSampleProjDrefImplicitLod:
    case SpvOpImageSampleProjDrefExplicitLod:
    case SpvOpImageGather:
    case SpvOpImageDrefGather:
    case SpvOpImageWrite:
      return 3;
    default:
      return -1;
  }
}

}  // namespace

bool isId(const Instruction& instruction, std::size_t at) {
  const int number = static_cast<int>(at);
  switch (instruction.op) {
    case SpvOpTypePointer:
    case SpvOpVariable:
    case SpvOpFunction:
      return number >= 1;
    case SpvOpExtInst:
      return number != 1;
    case SpvOpSwitch:
      return number <= 1 || number % 2 == 1;
    case SpvOpEntryPoint: {
      if (number == 1) return true;
      const std::size_t text = literalText(std::span(instruction.operands).subspan(2)).size() / 4 + 1;
      return at >= 2 + text;
    }
    default:
      break;
  }
  if (const int mask = imageMask(instruction.op); mask >= 0) return number != mask;
  const int ids = idsBeforeLiterals(instruction.op);
  return ids < 0 || number < ids;
}

}  // namespace simreel::kernels
