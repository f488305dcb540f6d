// What ribbon-play writes, as its users and other programs meet it.
#include <gtest/gtest.h>

#include <sys/ioctl.h>
#include <sys/stat.h>

#include <chrono>
#include <climits>
#include <cstdlib>
#include <numeric>
#include <thread>

#include "player/ribbon_play.h"
#include "recorder/process.h"

namespace ribbon::output_test {

namespace fs = std::filesystem;

constexpr std::size_t frame_bytes = std::size_t{64} * 48 * 3;

class Output : public RibbonPlay {
 protected:
  // What a shell does in the folder; its exit code.
  [[nodiscard]] int shell(const std::string& command) const {
    return waited_for(spawned({"/bin/sh", "-c", "cd '" + folder_.string() + "' && " + command}));
  }
  [[nodiscard]] bool has_ffmpeg() const { return shell("ffmpeg -version > version.txt") == 0; }

  // A program called ffmpeg that does this.
  [[nodiscard]] std::string with_ffmpeg_that(const std::string& does) const {
    fs::create_directory(folder_ / "bin");
    EXPECT_TRUE(write_file(folder_ / "bin/ffmpeg", "#!/bin/sh\n" + does + "\n"));
    fs::permissions(folder_ / "bin/ffmpeg", fs::perms::owner_all);
    return "PATH=\"$PWD/bin:$PATH\"";
  }

  // The frames of a video as other programs see them.
  [[nodiscard]] std::string decoded(const std::string& video) const {
    EXPECT_EQ(
        shell("ffmpeg -loglevel error -y -i " + video + " -f rawvideo -pix_fmt rgb24 decoded.rgb"),
        0);
    return bytes("decoded.rgb");
  }
};

double mean_difference(const std::string& a, const std::string& b) {
  EXPECT_EQ(a.size(), b.size());
  double sum = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    sum += std::abs(static_cast<unsigned char>(a[i]) - static_cast<unsigned char>(b[i]));
  return sum / static_cast<double>(a.size());
}

TEST_F(Output, raw_frames_are_alone_on_standard_output) {
  const ToolRun raw = play_small("-o -");
  EXPECT_EQ(raw.exit_code, 0);
  EXPECT_EQ(raw.output.size(), 7 * frame_bytes);
  EXPECT_THAT(raw.errors, HasSubstr("7 pictures"));
  EXPECT_EQ(output_of(play_small("-o - --frames 3 --quiet")),
            raw.output.substr(2 * frame_bytes, frame_bytes));
}

TEST_F(Output, what_else_is_told_does_not_get_among_raw_frames) {
  expect_refusal(play_small("-o - --info"), "--info: would stand among the raw frames");
  expect_refusal(play_small("-o - --json"), "--json: would stand among the raw frames");
  const ToolRun followed = play_small("-o - --follow");
  EXPECT_EQ(followed.output.size(), 7 * frame_bytes);
  EXPECT_THAT(followed.errors, HasSubstr("frame 7"));
}

TEST_F(Output, raw_frames_come_in_any_order) {
  const std::string all = output_of(play_small("-o - --quiet"));
  const auto frames = [&](const std::vector<int>& numbers) {
    std::string bytes;
    for (const int number : numbers) bytes += all.substr((number - 1) * frame_bytes, frame_bytes);
    return bytes;
  };
  EXPECT_TRUE(output_of(play_small("-o - --quiet --frames 1,5,3:4")) == frames({1, 5, 3, 4}));
  EXPECT_TRUE(output_of(play_small("-o - --quiet --ping-pong --frames 5:7")) ==
              frames({5, 6, 7, 6}));
  EXPECT_TRUE(output_of(play_small("-o - --quiet --reverse --fps 25")) == frames({7, 5, 3, 1}));
}

TEST_F(Output, a_lost_frame_is_held_in_a_stream) {
  damage();
  const ToolRun raw = play_small("-o - --quiet");
  EXPECT_EQ(raw.exit_code, 1);
  EXPECT_EQ(raw.output.size(), 7 * frame_bytes);
}

TEST_F(Output, lost_frames_are_held_in_a_stream_that_follows_too) {
  write_sample_recording(recording_, 40);
  const std::string whole = bytes("knot.rbn");
  const std::vector<std::pair<std::size_t, std::string>> lost{
      {whole.size() / 10, "frames 1-20\n"},
      {whole.size() / 8, "frames 2-20\n"},
      {whole.size() * 9 / 10, "frames 38-40\n"}};
  for (const auto& [at, frames] : lost) {
    ASSERT_TRUE(write_file(recording_, flipped(whole, at)));
    for (const std::string view : {"", " --view knot"}) {
      const ToolRun raw = play_small("-o - --quiet" + view);
      const ToolRun followed = play_small("-o - --quiet --follow" + view);
      EXPECT_THAT(raw.errors, EndsWith(frames));
      EXPECT_EQ(raw.exit_code, 1);
      EXPECT_EQ(followed.exit_code, 1);
      EXPECT_EQ(raw.output.size(), 40 * frame_bytes);
      EXPECT_TRUE(followed.output == raw.output) << frames << view;
    }
  }
}

TEST_F(Output, a_reader_that_goes_is_an_error_with_a_sentence) {
  const std::string command = "('" RIBBON_PLAY
                              "' knot.rbn --size 640x480 --samples 1 -o - 2> errors.txt; "
                              "echo $? > code.txt) | head -c 10 > head.txt";
  EXPECT_EQ(shell(command), 0);
  EXPECT_EQ(bytes("code.txt"), "2\n");
  EXPECT_THAT(bytes("errors.txt"), HasSubstr("was closed by the program that reads it"));
}

TEST_F(Output, a_full_disk_may_pass) {
  EXPECT_EQ(shell("'" RIBBON_PLAY "' knot.rbn --samples 1 -o - > /dev/full 2> errors.txt"), 3);
  EXPECT_THAT(bytes("errors.txt"), HasSubstr("standard output: cannot be written (No space left"));
}

TEST_F(Output, what_is_printed_and_lost_is_no_success) {
  for (const std::string words : {"--info", "--verify"}) {
    EXPECT_EQ(shell("'" RIBBON_PLAY "' knot.rbn " + words + " > /dev/full 2> errors.txt"), 3);
    EXPECT_THAT(bytes("errors.txt"), HasSubstr("ribbon-play: standard output: cannot be written"));
  }
}

TEST_F(Output, pictures_that_are_counted_anew_have_numbers_in_the_order_of_playing) {
  ASSERT_EQ(play_small("-o 'a/{frame:01}.png'").exit_code, 0);
  ASSERT_EQ(play_small("-o 'b/{frame:01}.png' --frames 2:4 --ping-pong").exit_code, 0);
  EXPECT_THAT(pictures("b"), ElementsAre("1.png", "2.png", "3.png", "4.png"));
  EXPECT_TRUE(bytes("b/1.png") == bytes("a/2.png"));
  EXPECT_TRUE(bytes("b/4.png") == bytes("a/3.png"));
}

TEST_F(Output, a_video_shows_what_raw_frames_show) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const std::string raw = output_of(play_small("-o - --quiet"));
  for (const std::string video : {"knot.mp4", "knot.webm"}) {
    EXPECT_EQ(output_of(play_small("--quiet -o " + video)), "");
    EXPECT_LT(mean_difference(decoded(video), raw), 4) << video;
  }
  EXPECT_EQ(output_of(play_small("--quiet -o knot.gif --fps 25")), "");
  EXPECT_EQ(decoded("knot.gif").size(), 4 * frame_bytes);
  EXPECT_THAT(names("."), ElementsAre("decoded.rgb", "knot.gif", "knot.mp4", "knot.rbn",
                                      "knot.webm", "version.txt"));
}

TEST_F(Output, a_video_is_the_same_bytes_each_time) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  ASSERT_EQ(play_small("-o one.mp4 --threads 1").exit_code, 0);
  ASSERT_EQ(play_small("-o two.mp4 --threads 2").exit_code, 0);
  EXPECT_TRUE(bytes("one.mp4") == bytes("two.mp4"));
}

TEST_F(Output, a_video_of_odd_size_is_padded) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const std::string odd = "knot.rbn --samples 1 --size 63x47 --quiet -o ";
  ASSERT_EQ(run(odd + "odd.mp4").exit_code, 0);
  const std::string raw = output_of(run(odd + "-"));
  const std::string video = decoded("odd.mp4");
  ASSERT_EQ(video.size(), 7 * frame_bytes);
  ASSERT_EQ(raw.size(), std::size_t{7} * 63 * 47 * 3);
  std::string picture;
  std::string added;
  for (std::size_t row = 0; row < std::size_t{7} * 48; ++row) {
    const std::string line = video.substr(row * 64 * 3, std::size_t{64} * 3);
    const std::size_t of_picture = row % 48 < 47 ? std::size_t{63} * 3 : 0;
    picture += line.substr(0, of_picture);
    added += line.substr(of_picture);
  }
  EXPECT_LT(mean_difference(picture, raw), 4);
  EXPECT_LT(mean_difference(added, std::string(added.size(), '\xFF')), 4);
}

TEST_F(Output, without_ffmpeg_there_is_no_video_and_a_sentence_says_so) {
  expect_refusal(play_small("-o knot.mp4", "PATH=/nowhere"),
                 "knot.mp4: needs ffmpeg, which is not installed; install it, or write pictures");
  EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
}

TEST_F(Output, what_ffmpeg_complains_of_is_told_and_nothing_stays) {
  const std::string failing = with_ffmpeg_that(
      "head -c 100 > /dev/null; echo 'first' >&2; echo 'no such coder' >&2; exit 1");
  expect_refusal(play_small("-o knot.mp4", failing), "knot.mp4: ffmpeg gave up (no such coder)");
  fs::remove_all(folder_ / "bin");
  EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
}

// Had that been taken for success, the next picture would have waited for ever.
TEST_F(Output, ffmpeg_that_ends_early_and_is_content_has_made_no_video) {
  const std::string content = with_ffmpeg_that("head -c 100 > /dev/null");
  expect_refusal(play_small("-o knot.mp4", content),
                 "knot.mp4: ffmpeg ended before it had all pictures; write pictures (.png)");
  fs::remove_all(folder_ / "bin");
  EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
}

TEST_F(Output, a_film_that_came_meanwhile_is_not_replaced) {
  const std::string slow = with_ffmpeg_that(
      "cat > /dev/null; echo \"somebody else's\" > knot.mp4; for f; do :; done; "
      "echo ours > \"${f#file:}\"");
  expect_refusal(play_small("-o knot.mp4", slow), "knot.mp4: was put there by somebody else");
  EXPECT_EQ(bytes("knot.mp4"), "somebody else's\n");
  EXPECT_EQ(play_small("-o knot.mp4 --force", slow).exit_code, 0);
  EXPECT_EQ(bytes("knot.mp4"), "ours\n");
}

TEST_F(Output, of_several_films_the_others_are_finished_where_one_is_not) {
  const std::string slow = with_ffmpeg_that(
      "cat > /dev/null; echo \"somebody else's\" > front.mp4; for f; do :; done; "
      "echo ours > \"${f#file:}\"");
  expect_refusal(play_small("-o '{view}.mp4' --view front --view knot", slow),
                 "front.mp4: was put there by somebody else");
  EXPECT_EQ(bytes("front.mp4"), "somebody else's\n");
  EXPECT_EQ(bytes("knot.mp4"), "ours\n");
}

TEST_F(Output, a_disk_that_is_too_full_for_ffmpeg_may_pass) {
  const std::string failing =
      with_ffmpeg_that("cat > /dev/null; echo 'out: No space left on device' >&2; exit 1");
  const ToolRun full = play_small("-o knot.mp4", failing);
  EXPECT_EQ(full.exit_code, 3);
  EXPECT_THAT(full.errors, EndsWith("; free some space\n"));
}

TEST_F(Output, what_cannot_be_is_refused_before_anything_is_written) {
  expect_refusal(play_small("-o 'frames/{frame}.bmp'"), "is not written as .bmp; choose .png");
  expect_refusal(play_small("-o 'frames/{frame}'"), "has no extension");
  expect_refusal(play_small("-o 'knot{frame}.mp4'"), "holds all frames; leave {frame} out");
  expect_refusal(run("knot.rbn -o 'pg.{frame}.html'"), "holds all frames; leave {frame} out");
  expect_refusal(run("knot.rbn -o '{view}.html'"), "leave {view} out");
  expect_refusal(run("knot.rbn -o pg.html --follow"), "--follow: does not go with a page");
  expect_refusal(run("knot.rbn -o ''"), "--output: is followed by an empty text; write PATTERN");
  expect_refusal(play_small("-o knot.gif --fps 60"), "a GIF has at most 50; choose fewer by --fps");
  expect_refusal(play_small("-o knot.mp4 --isa sse2 --shard 1/2"), "cannot be written in parts");
  expect_refusal(play_small("-o - --resume"), "cannot be written in parts");
  expect_refusal(play_small("-o 'frames/{frame}.png' --shard 3/2"), "--shard 3/2");
  expect_refusal(play_small("-o 'frames/{frame}.png' --fps 0"), "--fps");
  expect_refusal(run("knot.rbn --info --reverse"), "--output");
  EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
}

TEST_F(Output, a_refused_job_leaves_nothing_in_the_way_of_the_next) {
  expect_refusal(run("knot.rbn --preview -o 'e/{frame}.exr'"), "knows no linear light");
  expect_refusal(run("knot.rbn --plot p.svg -o bad.bmp"), "is not written as .bmp");
  expect_refusal(run("knot.rbn --plot p.svg --sheet s.png -o '{frame}.png' --view top --view knot"),
                 "put {view} into the name");
  RecordingHeader header = sample_header();
  header.input_curve.resize(3, 0);
  write_recording(recording_, header, {sample_positions(0), sample_positions(1)});
  expect_refusal(play_small("-o 'c/{frame}.png' --plot p.svg --overlay curve"),
                 "does not tell the curve");
  EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
}

TEST_F(Output, an_exr_holds_the_light_before_exposure_and_tone_that_a_screen_shows) {
  for (const std::string file : {"last.exr", "last.png"}) {
    ASSERT_EQ(play_small("--frames -1 -o " + file).exit_code, 0);
    ASSERT_EQ(play_small("--frames -1 --exposure 3 -o exposed-" + file).exit_code, 0);
    ASSERT_EQ(play_small("--frames -1 --exposure 3 --tone soft -o soft-" + file).exit_code, 0);
  }
  EXPECT_THAT(bytes("last.exr"), StartsWith("\x76\x2f\x31\x01"));
  EXPECT_TRUE(bytes("exposed-last.exr") == bytes("last.exr"));
  EXPECT_TRUE(bytes("soft-last.exr") == bytes("last.exr"));
  EXPECT_FALSE(bytes("exposed-last.png") == bytes("last.png"));
  EXPECT_FALSE(bytes("soft-last.png") == bytes("exposed-last.png"));
}

TEST_F(Output, what_is_there_is_not_replaced_unless_asked) {
  ASSERT_TRUE(write_file(folder_ / "last.png", "a photograph"));
  ASSERT_TRUE(write_file(folder_ / "a/3.png", "a photograph"));
  ASSERT_TRUE(write_file(folder_ / "knot.mp4", "a film"));
  expect_refusal(play_small("-o last.png --frames -1"), "last.png: exists already");
  expect_refusal(play_small("-o 'a/{frame:01}.png'"), "a/3.png: exists already");
  expect_refusal(play_small("-o 'a/{frame:01}.png' --resume"),
                 "a/3.png: exists already; choose another name, or replace it by --force\n");
  expect_refusal(play_small("-o knot.mp4"), "knot.mp4: exists already");
  expect_refusal(run("knot.rbn --samples 1 --sheet last.png"), "last.png: exists already");
  EXPECT_THAT(pictures("a"), ElementsAre("3.png"));
  EXPECT_EQ(bytes("last.png") + bytes("a/3.png") + bytes("knot.mp4"),
            "a photographa photographa film");
  EXPECT_EQ(play_small("-o last.png --frames -1 --force").exit_code, 0);
  EXPECT_EQ(play_small("-o 'a/{frame:01}.png' --force").exit_code, 0);
  EXPECT_EQ(run("knot.rbn --samples 1 --sheet last.png --force").exit_code, 0);
  EXPECT_THAT(bytes("a/3.png"), StartsWith("\x89PNG"));
}

TEST_F(Output, progress_is_told_to_programs) {
  const ToolRun json = play_small("-o 'a/{frame}.png' --progress json");
  EXPECT_EQ(json.exit_code, 0);
  EXPECT_THAT(json.errors, StartsWith(R"({"unit":"picture","done":1,"total":7,"seconds":)"));
  EXPECT_THAT(json.errors, HasSubstr(R"({"unit":"picture","done":7,"total":7,"seconds":)"));
}

// Sends it a signal and waits until it has ended by itself.
int ended_by_one_signal(pid_t process) {
  ::kill(process, SIGTERM);
  for (int look = 0; look < 100 && !has_ended(process); ++look)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_TRUE(has_ended(process));
  ::kill(process, SIGKILL);
  return waited_for(process);
}

TEST_F(Output, an_interrupted_sheet_asks_for_another_try) {
  const pid_t player =
      spawned({"/bin/sh", "-c",
               "cd '" + folder_.string() +
                   "' && exec '" RIBBON_PLAY
                   "' knot.rbn --quality final --sheet s.png --progress json 2> errors.txt"});
  while (!fs::exists(folder_ / "errors.txt") || bytes("errors.txt").empty())
    if (has_ended(player)) break;
  EXPECT_EQ(ended_by_one_signal(player), 3);
  EXPECT_THAT(bytes("errors.txt"), StartsWith(R"({"unit":"frame","done":1,"total":5,)"));
  EXPECT_THAT(bytes("errors.txt"), HasSubstr("interrupted before frame"));
  EXPECT_FALSE(fs::exists(folder_ / "s.png"));
}

TEST_F(Output, one_signal_ends_it_where_nobody_reads) {
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const FileDescriptor reader(::open(pipe.c_str(), O_RDWR | O_CLOEXEC));
  for (const std::string options : {"", "--follow "}) {
    const pid_t player =
        spawned({"/bin/sh", "-c",
                 "cd '" + folder_.string() +
                     "' && exec '" RIBBON_PLAY "' knot.rbn --size 640x480 --samples 1 -o - " +
                     options + "> pipe 2> errors.txt"});
    int waiting = 0;
    while (waiting < PIPE_BUF && !has_ended(player)) ::ioctl(reader.number(), FIONREAD, &waiting);
    EXPECT_EQ(ended_by_one_signal(player), 3);
    EXPECT_THAT(bytes("errors.txt"), HasSubstr("interrupted"));
    std::string rest(std::size_t{1} << 20, ' ');
    EXPECT_GT(::read(reader.number(), rest.data(), rest.size()), 0);
  }
}

TEST_F(Output, one_signal_ends_a_video_and_ffmpeg_that_is_stuck) {
  for (const std::string does : {"echo $$ > going.pid; mv going.pid ffmpeg.pid; exec sleep 600",
                                 "cat > /dev/null; echo $$ > going.pid; mv going.pid ffmpeg.pid; "
                                 "exec sleep 600"}) {
    const std::string stuck = with_ffmpeg_that(does);
    const pid_t player =
        spawned({"/bin/sh", "-c",
                 "cd '" + folder_.string() + "' && " + stuck +
                     " exec '" RIBBON_PLAY
                     "' knot.rbn --size 640x480 --samples 1 -o knot.mp4 2> errors.txt"});
    while (!fs::exists(folder_ / "ffmpeg.pid") && !has_ended(player)) std::this_thread::yield();
    EXPECT_EQ(ended_by_one_signal(player), 3);
    EXPECT_THAT(bytes("errors.txt"), HasSubstr("interrupted before"));
    EXPECT_NE(::kill(std::stoi(bytes("ffmpeg.pid")), 0), 0);
    fs::remove(folder_ / "ffmpeg.pid");
  }
  fs::remove_all(folder_ / "bin");
  EXPECT_THAT(names("."), ElementsAre("errors.txt", "knot.rbn"));
}

}  // namespace ribbon::output_test
