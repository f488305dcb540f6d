// kill_recorder RECORDER SCENE KILLS SEED: records the scene again and again with SIGKILL at random
// moments, plays what is left and goes on with it, and prints the figures as JSON. Works in the
// scene's folder. Exit codes: 0 all frames were those of an uninterrupted run, 1 they were not, 2
// could not.
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "commandline/tool.h"
#include "recorder/killed_runs.h"

namespace ribbon {

namespace {

Result<ExitCode> run(int argc, char** argv) {
  if (argc != 5)
    return failure("", "four arguments are needed", "call it with RECORDER SCENE KILLS SEED");
  const std::filesystem::path scene = argv[2];
  const KillReport report = kill_and_resume(argv[1], scene, scene.parent_path(), std::stoi(argv[3]),
                                            static_cast<unsigned>(std::stoul(argv[4])));
  const nlohmann::ordered_json json = {{"scene", scene.stem().string()},
                                       {"kills", report.kills},
                                       {"of_resumed_runs", report.of_resumed_runs},
                                       {"before_the_header", report.before_the_header},
                                       {"without_frames", report.without_frames},
                                       {"came_to_their_end", report.came_to_their_end},
                                       {"frames_played", report.frames_played},
                                       {"frames_resumed", report.frames_resumed},
                                       {"problem", report.problem}};
  std::printf("%s\n", json.dump().c_str());
  return report.problem.empty() ? ExitCode::done : ExitCode::answer_is_no;
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("kill_recorder", [&] { return ribbon::run(argc, argv); });
}
