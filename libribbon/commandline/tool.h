// What the three tools have in common: exit codes and how an error reaches the user.
#pragma once

#include <functional>
#include <string>

#include "result/result.h"

namespace ribbon {

// 0: done. 1: checked, and the answer is no. 2: could not, and will not. 3: was interrupted or
// found the disk full: the same may work another time.
enum class ExitCode { done = 0, answer_is_no = 1, could_not = 2, try_again = 3 };

// Runs `body`, with files that grow too large and readers that go as write errors instead of
// signals, and turns its answer into the process's exit code; an error goes to standard error as
// one sentence after the tool's name. An exception that escapes (no memory) is reported likewise.
int run_tool(const std::string& tool_name, const std::function<Result<ExitCode>()>& body);

}  // namespace ribbon
