// The numbers that a recording keeps with each frame, as a table.
#pragma once

#include <string>
#include <vector>

#include "converter/conversion.h"

namespace ribbon {

// Writes the numbers of `frames` (indices from 0) to request.output as CSV: a line of names with
// their units in brackets, then a line a frame. Cells are empty where the recording lost the
// numbers or has none (tightness, where nothing fastens the ribbon). Decimals read back as the same
// number. Where the ribbon is fastened in stages, the last column names the frame's. No positions
// are decoded, so all of the recording is checked in the end: frames that are lost, also those
// whose numbers are still known, are listed as missing.
Result<ConversionReport> write_number_table(const ConversionRequest& request,
                                            RecordingReader& reader,
                                            const std::vector<int>& frames);

// Its lines: the names, and a frame's numbers (index from 0).
std::string number_table_title(const RecordingHeader& header);
std::string number_table_line(const RecordingReader& reader, int index);

}  // namespace ribbon
