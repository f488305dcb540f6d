#include "player/output/video.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "commandline/extension.h"
#include "player/output/existing_file.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// At whether ffmpeg has ended.
constexpr std::chrono::milliseconds between_looks{5};

// Viewers show anything faster at ten a second.
constexpr double fastest_gif = 50;

// The pixels are sRGB; videos are tagged and converted as BT.709, whose primaries are the same.
// H.264 of this kind, which every viewer knows, needs even sides.
const std::string to_video =
    "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white,scale=out_color_matrix=bt709:out_range=tv,"
    "format=yuv420p";
// Each picture gets the 256 colours that suit it: one palette for all would need all in memory.
const std::string to_gif =
    "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=bayer";

Words coding_words(const std::string& extension) {
  if (extension == ".gif") return {"-filter_complex", to_gif, "-f", "gif"};
  Words words{"-vf",   to_video,     "-colorspace", "bt709",        "-color_primaries",
              "bt709", "-color_trc", "bt709",       "-color_range", "tv"};
  const Words mp4{"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", "-f", "mp4"};
  const Words webm{"-c:v", "libvpx-vp9", "-crf", "24",      "-b:v", "0",  "-deadline",
                   "good", "-cpu-used",  "4",    "-row-mt", "1",    "-f", "webm"};
  const Words& coder = extension == ".webm" ? webm : mp4;
  words.insert(words.end(), coder.begin(), coder.end());
  return words;
}

Words ffmpeg_words(const fs::path& file, const std::string& extension, PictureSize size,
                   double frames_per_second) {
  Words words{"ffmpeg",
              "-nostdin",
              "-loglevel",
              "error",
              "-y",
              "-f",
              "rawvideo",
              "-pixel_format",
              "rgb24",
              "-video_size",
              filled_in("{}x{}", size.width, size.height),
              "-framerate",
              short_number(frames_per_second, 12),
              "-i",
              "pipe:0",
              "-an"};
  const Words coding = coding_words(extension);
  words.insert(words.end(), coding.begin(), coding.end());
  // Bit for bit the same each time: neither versions nor dates.
  for (const char* word : {"-fflags", "+bitexact", "-flags:v", "+bitexact", "-map_metadata", "-1"})
    words.emplace_back(word);
  words.push_back("file:" + file.string());
  return words;
}

// In a process group of its own, so that Ctrl-C reaches us alone; the pixels are its standard
// input, what it says goes to `complaints`. The system's error number where it cannot be started.
int spawn_ffmpeg(Words words, int input, int complaints, pid_t& process) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, complaints, STDERR_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, complaints, STDOUT_FILENO);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int problem = ::posix_spawnp(&process, words.front().c_str(), &files, &attributes,
                                     arguments.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  return problem;
}

}  // namespace

Video::Video(fs::path file, PartFile part, Older older, Stopped stopped)
    : file_(std::move(file)), part_(std::move(part)), older_(older), stopped_(std::move(stopped)) {}

Result<std::unique_ptr<PictureSink>> Video::open(const fs::path& file, PictureSize size,
                                                 double frames_per_second,
                                                 const Replaceable& replaceable, Stopped stopped) {
  if (auto free = check_place(file, replaceable); !free) return tl::unexpected(free.error());
  if (lower_case_extension(file) == ".gif" && frames_per_second > fastest_gif)
    return failure(file.string(),
                   filled_in("cannot show {:.6g} pictures a second, a GIF has at most {:.6g}",
                             frames_per_second, fastest_gif),
                   "choose fewer by --fps");
  auto part = PartFile::create(file);
  if (!part) return tl::unexpected(part.error());
  std::unique_ptr<Video> video(
      new Video(file, *std::move(part), replaceable.later(), std::move(stopped)));
  if (auto started = video->start(size, frames_per_second); !started)
    return tl::unexpected(started.error());
  return video;
}

Result<void> Video::start(PictureSize size, double frames_per_second) {
  std::array<int, 2> ends{};
  complaints_ = FileDescriptor(::memfd_create("ffmpeg", MFD_CLOEXEC));
  if (!complaints_.is_open() || ::pipe2(ends.data(), O_CLOEXEC) != 0)
    return cannot_be_written(file_);
  const FileDescriptor input(ends[0]);
  pixels_ = FileDescriptor(ends[1]);
  const int problem =
      spawn_ffmpeg(ffmpeg_words(part_.path(), lower_case_extension(file_), size, frames_per_second),
                   input.number(), complaints_.number(), ffmpeg_);
  if (problem == 0) return {};
  ffmpeg_ = -1;
  return failure(file_.string(),
                 problem == ENOENT ? "needs ffmpeg, which is not installed"
                                   : "needs ffmpeg, which cannot be started (" +
                                         std::generic_category().message(problem) + ")",
                 "install it, or write pictures (.png) or raw frames (-o -)");
}

Video::~Video() {
  pixels_.close();
  if (ffmpeg_ > 0) {
    ::kill(ffmpeg_, SIGKILL);
    ::waitpid(ffmpeg_, nullptr, 0);
  }
}

Result<void> Video::put(OutputPicture picture) {
  const auto& rgb = std::get<Picture>(picture.image).rgb;
  const Sent sent =
      send_all(pixels_, {reinterpret_cast<const char*>(rgb.data()), rgb.size()}, stopped_);
  if (sent == Sent::all) return {};
  if (sent == Sent::given_up) return interrupted();
  // It has closed its end, and says why.
  return wait_for_ffmpeg().and_then([&]() -> Result<void> {
    return failure(file_.string(), "ffmpeg ended before it had all pictures",
                   "write pictures (.png) and try by hand");
  });
}

Result<void> Video::finish() {
  if (auto ended = wait_for_ffmpeg(); !ended) return ended;
  const FileDescriptor written(::open(part_.path().c_str(), O_RDONLY | O_CLOEXEC));
  if (!written.is_open() || ::fsync(written.number()) != 0) return cannot_be_written(file_);
  return part_.take_place_of(file_, older_).map([&] { sync_folder_of(file_); });
}

// The last line, with what matters most.
std::string Video::complaint() const {
  std::string text(4096, '\0');
  const off_t end = ::lseek(complaints_.number(), 0, SEEK_END);
  const off_t begin = std::max<off_t>(0, end - static_cast<off_t>(text.size()));
  const ssize_t got = ::pread(complaints_.number(), text.data(), text.size(), begin);
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  while (text.ends_with('\n')) text.pop_back();
  const std::size_t line = text.rfind('\n');
  return line == std::string::npos ? text : text.substr(line + 1);
}

tl::unexpected<Error> Video::interrupted() const {
  return passing_failure(file_.string(), "was interrupted before ffmpeg was done", "run it again");
}

// Fails where it did, in its words.
Result<void> Video::wait_for_ffmpeg() {
  pixels_.close();
  int status = 0;
  pid_t ended = 0;
  while ((ended = ::waitpid(ffmpeg_, &status, WNOHANG)) == 0) {
    if (stopped_ && stopped_()) return interrupted();
    std::this_thread::sleep_for(between_looks);
  }
  ffmpeg_ = -1;
  if (ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  const std::string said = complaint();
  const bool no_room = said.find(std::generic_category().message(ENOSPC)) != std::string::npos;
  return tl::unexpected<Error>(
      Error{file_.string(), "ffmpeg gave up (" + (said.empty() ? "without a word" : said) + ")",
            no_room ? "free some space" : "write pictures (.png) and try by hand", no_room});
}

}  // namespace ribbon
