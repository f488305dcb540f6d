// How often each symbol is to be expected, so that a short frame need not say it.
#pragma once

#include <string>
#include <vector>

namespace ribbon {

// A zstd dictionary for each kind of run of symbols (see ResidualPacker), made from fastened sample
// ribbons. They go into the header of every recording; other tables are as good, only larger files
// come of it.
std::vector<std::string> standard_entropy_tables();

}  // namespace ribbon
