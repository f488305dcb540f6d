// Which vector instructions the innermost loops use. Those that are compiled for several sets give
// the same bits with each.
#pragma once

namespace ribbon {

enum class InstructionSet { baseline, avx2, avx512 };

// Does this processor have it?
bool is_available(InstructionSet set);

// The widest that it has.
InstructionSet best_instruction_set();

// The one to use: the best, or the one chosen last.
InstructionSet instruction_set();

// While no loop runs. It must be available.
void choose_instruction_set(InstructionSet set);

}  // namespace ribbon
