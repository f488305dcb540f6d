// count_strained_springs RECORDING: as JSON, how many springs are more than 10 % from their rest
// length.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commandline/tool.h"
#include "soak/strained_springs.h"

namespace ribbon {
namespace {

constexpr double limit = 0.1;  // of the paper's section 5.5

Result<ExitCode> count(int argc, char** argv) {
  if (argc != 2) return failure("", "one argument is needed", "name a recording");
  auto recording = RecordingReader::open(argv[1]);
  if (!recording) return tl::unexpected(recording.error());
  const auto strained = strained_springs(*recording, limit);
  if (!strained) return tl::unexpected(strained.error());
  const nlohmann::ordered_json json = {{"springs", strained->springs},
                                       {"limit", strained->limit},
                                       {"worst_share", strained->worst_share},
                                       {"worst_share_frame", strained->worst_share_frame},
                                       {"mean_share", strained->mean_share},
                                       {"last_share", strained->last_share},
                                       {"worst_elongation", strained->worst_elongation},
                                       {"worst_frame", strained->worst_frame}};
  std::puts(json.dump(2).c_str());
  return ExitCode::done;
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("count_strained_springs", [&] { return ribbon::count(argc, argv); });
}
