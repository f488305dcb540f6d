// A conversion that has been thought through, before anything is written.
#pragma once

#include <string>
#include <vector>

#include "converter/conversion.h"
#include "converter/output_format.h"
#include "model/model.h"
#include "playback/recording_reader.h"
#include "result/result.h"

namespace ribbon {

struct ConversionJob {
  OutputFormat format = OutputFormat::obj;
  RecordingReader reader;
  std::vector<int> frames;  // indices from 0, at least one
  Model model;
};

// Opens the recording and works out what is asked for. Fails, naming the place, where that cannot
// be.
Result<ConversionJob> open_job(const ConversionRequest& request);

// Where no frame of `model` is left to be written: could some have been, if not as this solid?
tl::unexpected<Error> no_frames(const Model& model, bool some_refused);

// Where the user has interrupted what cannot go on later.
tl::unexpected<Error> interrupted_conversion();

// What is written, in words, so that a later run can tell whether it would write the same.
std::string job_text(const ConversionRequest& request, const ConversionJob& job);

}  // namespace ribbon
