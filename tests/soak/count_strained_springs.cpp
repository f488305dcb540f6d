// count_strained_springs RECORDING: as JSON, how many springs are more than 10 % from their rest
// length.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "result/demanded.h"
#include "soak/strained_springs.h"

int main(int argc, char** argv) {
  using namespace ribbon;
  if (argc != 2) {
    std::fputs("usage: count_strained_springs RECORDING\n", stderr);
    return 2;
  }
  constexpr double limit = 0.1;  // of the paper's section 5.5
  auto recording = demanded(RecordingReader::open(argv[1]));
  const auto strained = demanded(strained_springs(recording, limit));
  const nlohmann::ordered_json json = {{"springs", strained.springs},
                                       {"limit", strained.limit},
                                       {"worst_share", strained.worst_share},
                                       {"worst_share_frame", strained.worst_share_frame},
                                       {"mean_share", strained.mean_share},
                                       {"last_share", strained.last_share},
                                       {"worst_elongation", strained.worst_elongation},
                                       {"worst_frame", strained.worst_frame}};
  std::puts(json.dump(2).c_str());
}
