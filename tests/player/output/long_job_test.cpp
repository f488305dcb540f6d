// Sequences that are interrupted, go on, and are shared by several machines.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "files/part_file.h"
#include "parallel/instruction_set.h"
#include "player/output/picture_files.h"
#include "player/picture/png_encoder.h"
#include "player/ribbon_play.h"
#include "recorder/process.h"
#include "text/number_text.h"

namespace ribbon::long_job_test {

namespace fs = std::filesystem;

class LongJob : public RibbonPlay {
 protected:
  [[nodiscard]] ToolRun render_into(const std::string& below, const std::string& more = "") const {
    return play_small("-o '" + below + "/{frame:02}.png' --resume " + more);
  }

  // All pictures of a folder by name.
  [[nodiscard]] std::map<std::string, std::string> all(const std::string& below) const {
    std::map<std::string, std::string> all;
    const std::string folder = below + "/";
    for (const std::string& name : pictures(below)) all[name] = bytes(folder + name);
    return all;
  }
};

TEST_F(LongJob, what_is_complete_is_not_rendered_again) {
  EXPECT_THAT(output_of(render_into("a")), StartsWith("7 pictures, "));
  const auto before = fs::last_write_time(folder_ / "a/05.png");
  EXPECT_EQ(output_of(render_into("a")), "0 pictures, 7 were complete\n");
  EXPECT_EQ(fs::last_write_time(folder_ / "a/05.png"), before);
}

TEST_F(LongJob, what_is_missing_or_not_as_it_was_is_rendered_again) {
  ASSERT_EQ(render_into("a").exit_code, 0);
  const auto before = all("a");
  fs::remove(folder_ / "a/02.png");
  ASSERT_TRUE(write_file(folder_ / "a/05.png", bytes("a/05.png").substr(0, 100)));
  EXPECT_THAT(output_of(render_into("a")), StartsWith("2 pictures, 5 were complete, "));
  EXPECT_TRUE(all("a") == before);
}

TEST_F(LongJob, where_all_is_complete_nothing_is_prepared_for_rendering) {
  const std::string preview = "--preview -o 'a/{frame}.png' --resume";
  ASSERT_EQ(play_small(preview).exit_code, 0);
  ASSERT_TRUE(write_file(folder_ / "libOSMesa.so.8", "no library"));
  const std::string without = "LD_LIBRARY_PATH='" + folder_.string() + "'";
  const ToolRun complete = play_small(preview + " --progress json", without);
  EXPECT_EQ(complete.exit_code, 0);
  EXPECT_EQ(complete.output, "0 pictures, 7 were complete\n");
  EXPECT_THAT(complete.errors, StartsWith(R"({"unit":"picture","done":0,"total":0,)"));
  fs::remove(folder_ / "a/0003.png");
  expect_refusal(play_small(preview, without), "cannot load OSMesa");
}

TEST_F(LongJob, goes_on_with_one_that_was_not_begun_with_resume) {
  ASSERT_EQ(play_small("-o 'a/{frame:02}.png'").exit_code, 0);
  EXPECT_EQ(output_of(render_into("a")), "0 pictures, 7 were complete\n");
  expect_refusal(play_small("-o 'a/{frame:02}.png'"), "go on with a sequence by --resume");
}

TEST_F(LongJob, a_changed_setting_renders_all_anew_and_threads_are_none) {
  ASSERT_EQ(render_into("a").exit_code, 0);
  EXPECT_EQ(output_of(render_into("a", "--threads 1")), "0 pictures, 7 were complete\n");
  EXPECT_THAT(output_of(run("knot.rbn --size 32x24 --samples 1 --resume -o 'a/{frame:02}.png'")),
              StartsWith("7 pictures, "));
  EXPECT_THAT(output_of(render_into("a", "--view top")), StartsWith("7 pictures, "));
}

TEST_F(LongJob, another_recording_renders_all_anew) {
  ASSERT_EQ(render_into("a").exit_code, 0);
  write_sample_recording(recording_, 8);
  EXPECT_THAT(output_of(render_into("a")), StartsWith("8 pictures, "));
}

TEST_F(LongJob, another_order_is_told_by_the_frame_that_a_picture_shows) {
  ASSERT_EQ(render_into("a").exit_code, 0);
  EXPECT_THAT(output_of(render_into("a", "--reverse")), StartsWith("6 pictures, 1 were complete"));
}

TEST_F(LongJob, a_file_that_an_option_names_counts_by_what_is_in_it) {
  const std::string path = "--camera-path keys.txt";
  ASSERT_TRUE(write_file(folder_ / "keys.txt", "time,azimuth\n0,10\n1,20\n"));
  ASSERT_EQ(render_into("a", path).exit_code, 0);
  EXPECT_EQ(output_of(render_into("a", path)), "0 pictures, 7 were complete\n");
  ASSERT_TRUE(write_file(folder_ / "keys.txt", "time,azimuth\n0,10\n1,80\n"));
  EXPECT_THAT(output_of(render_into("a", path)), StartsWith("7 pictures, "));
}

TEST_F(LongJob, each_of_several_views_goes_on_by_itself) {
  const std::string views = "-o '{view}/{frame:02}.png' --view front --view top --resume";
  ASSERT_EQ(play_small(views).exit_code, 0);
  for (const std::string lost : {"top/03.png", "front/05.png"}) {
    fs::remove(folder_ / lost);
    const std::string said = output_of(play_small(views));
    EXPECT_THAT(said, StartsWith("1 picture, 13 were complete, "));
    EXPECT_THAT(said, EndsWith("last: " + lost + "\n"));
  }
}

TEST_F(LongJob, shards_together_are_one_run_byte_for_byte) {
  ASSERT_EQ(render_into("one", "--isa sse2 --threads 1").exit_code, 0);
  for (const std::string shard : {"3/3", "1/3", "2/3"})
    EXPECT_EQ(render_into("three", "--isa sse2 --shard " + shard).exit_code, 0);
  EXPECT_TRUE(all("one") == all("three"));
  EXPECT_EQ(output_of(render_into("three", "--isa sse2 --shard 2/2")),
            "0 pictures, 3 were complete\n");
  EXPECT_EQ(output_of(render_into("three", "--isa sse2")), "0 pictures, 7 were complete\n");
}

TEST_F(LongJob, a_turning_camera_turns_alike_in_all_shards) {
  ASSERT_EQ(render_into("one", "--turns 1 --isa sse2").exit_code, 0);
  for (const std::string shard : {"1/2", "2/2"})
    ASSERT_EQ(render_into("two", "--turns 1 --isa sse2 --shard " + shard).exit_code, 0);
  EXPECT_TRUE(all("one") == all("two"));
  EXPECT_THAT(output_of(render_into("one", "--turns 1 --isa sse2 --frames 1:4")),
              StartsWith("4 pictures, "));
}

TEST_F(LongJob, a_turntable_of_one_frame_is_made_of_different_pictures_that_can_be_resumed) {
  const std::string turntable = "--isa sse2 --turns 1 --frames 3 --hold ";
  ASSERT_EQ(render_into("one", turntable + "4").exit_code, 0);
  const auto whole = all("one");
  ASSERT_EQ(whole.size(), 4U);
  EXPECT_NE(whole.at("01.png"), whole.at("03.png")) << "seen from the other side";
  const std::string quarters = turntable + "4 --shard ";
  for (const std::string shard : {"1/2", "2/2"})
    ASSERT_EQ(render_into("two", quarters + shard).exit_code, 0);
  EXPECT_TRUE(all("two") == whole);
  fs::remove(folder_ / "one/02.png");
  EXPECT_THAT(output_of(render_into("one", turntable + "4")),
              StartsWith("1 picture, 3 were complete"));
  EXPECT_TRUE(all("one") == whole);
  EXPECT_THAT(output_of(render_into("one", turntable + "8")), StartsWith("8 pictures, "));
}

TEST_F(LongJob, what_is_interpolated_is_told_and_goes_on_in_shards_and_after_a_stop) {
  const std::string slow = "--isa sse2 --fps 100 --interpolate ";
  const ToolRun whole = render_into("one", slow);
  EXPECT_EQ(whole.exit_code, 0);
  EXPECT_THAT(whole.errors, HasSubstr("6 moments lie between recorded frames, and interpolated: "
                                      "not certified; nothing intersects there"));
  EXPECT_THAT(bytes("one/manifest.png.txt"), HasSubstr("picture 04 of frame 2.5, interpolated: "));
  const auto pictures = all("one");
  ASSERT_EQ(pictures.size(), 13U);
  ASSERT_EQ(render_into("recorded", "--isa sse2").exit_code, 0);
  EXPECT_TRUE(pictures.at("03.png") == bytes("recorded/02.png"));
  EXPECT_TRUE(pictures.at("05.png") == bytes("recorded/03.png"));
  EXPECT_NE(pictures.at("04.png"), pictures.at("03.png"));
  EXPECT_NE(pictures.at("04.png"), pictures.at("05.png"));
  const std::string sharded = slow + "--shard ";
  for (const std::string shard : {"2/2", "1/2"})
    ASSERT_EQ(render_into("two", sharded + shard).exit_code, 0);
  EXPECT_TRUE(all("two") == pictures);
  fs::remove(folder_ / "one/04.png");
  EXPECT_THAT(render_into("one", slow).output, StartsWith("1 picture, 12 were complete"));
  EXPECT_TRUE(all("one") == pictures);
  expect_refusal(render_into("one", "--interpolate"), "--fps");
  expect_refusal(render_into("one", slow + "--hold 2"), "--hold");
}

TEST_F(LongJob, colours_are_those_of_all_frames_in_all_shards) {
  ASSERT_EQ(render_into("one", "--color-by strain --isa sse2").exit_code, 0);
  for (const std::string shard : {"1/2", "2/2"})
    ASSERT_EQ(render_into("two", "--color-by strain --isa sse2 --shard " + shard).exit_code, 0);
  EXPECT_TRUE(all("one") == all("two"));
  EXPECT_THAT(output_of(render_into("one", "--color-by strain --isa sse2 --frames 1:4")),
              StartsWith("4 pictures, "));
}

TEST_F(LongJob, shards_that_have_nothing_to_do_are_done) {
  EXPECT_EQ(output_of(render_into("a", "--isa sse2 --shard 9/9")), "0 pictures\n");
}

TEST_F(LongJob, instruction_sets_do_not_mix) {
  if (!is_available(InstructionSet::avx2)) GTEST_SKIP() << "this processor has no AVX2";
  ASSERT_EQ(render_into("a", "--isa avx2").exit_code, 0);
  EXPECT_EQ(output_of(render_into("a", "--isa avx2")), "0 pictures, 7 were complete\n");
  EXPECT_THAT(bytes("a/manifest.png.txt"), HasSubstr(" with avx2; "));
  EXPECT_THAT(output_of(render_into("a", "--isa sse2")), StartsWith("7 pictures, "));
  expect_refusal(render_into("a", "--isa mmx"), "--isa");
}

TEST_F(LongJob, shards_say_which_instructions_so_that_two_kinds_of_machine_never_mix) {
  expect_refusal(render_into("a", "--shard 1/2"), "add --isa avx2");
  EXPECT_EQ(render_into("a", "--shard 1/1").exit_code, 0);
}

TEST_F(LongJob, kill_at_any_moment_then_a_rerun_gives_identical_files) {
  write_sample_recording(recording_, 30);
  const auto before = std::chrono::steady_clock::now();
  ASSERT_EQ(render_into("whole").exit_code, 0);
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - before;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.1, 1);  // of that time
  std::size_t most_seen = 0;
  for (int kill = 0; kill < 12; ++kill) {
    const pid_t tool = spawned({RIBBON_PLAY, recording_, "--size", "64x48", "--samples", "1",
                                "--resume", "--quiet", "-o", folder_ / "killed/{frame:02}.png"});
    std::this_thread::sleep_for(share(random) * whole);
    ::kill(tool, SIGKILL);
    (void)waited_for(tool);
    if (!fs::exists(folder_ / "killed")) continue;
    for (const auto& [name, content] : all("killed")) {
      if (!name.ends_with(".png")) continue;
      EXPECT_TRUE(content == bytes("whole/" + name)) << name;
    }
    most_seen = std::max(most_seen, all("killed").size());
  }
  ASSERT_EQ(render_into("killed").exit_code, 0);
  EXPECT_TRUE(all("killed") == all("whole"));
  EXPECT_GT(most_seen, 0U);
}

TEST_F(LongJob, an_interruption_asks_for_another_try) {
  write_sample_recording(recording_, 200);
  const pid_t tool = spawned({RIBBON_PLAY, recording_, "--size", "640x480", "--samples", "4",
                              "--quiet", "-o", folder_ / "a/{frame:03}.png"});
  while (!fs::exists(folder_ / "a/001.png") && !has_ended(tool))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ::kill(tool, SIGTERM);
  EXPECT_EQ(waited_for(tool), 3);
  EXPECT_LT(pictures("a").size(), 200U);
  for (const std::string& name : pictures("a")) EXPECT_TRUE(name.ends_with(".png")) << name;
}

TEST_F(LongJob, a_full_disk_asks_for_another_try_and_the_next_one_goes_on) {
  // In a namespace of our own, where everybody may mount.
  const std::string full =
      "unshare --user --map-root-user --mount sh -c 'mkdir -p disk copy && "
      "mount -t tmpfs -o size=48k none disk && cd disk && \"" RIBBON_PLAY
      "\" ../knot.rbn --size 64x48 --samples 1 --resume -o {frame}.png; code=$?; "
      "cp *.png manifest* ../copy; exit $code'";
  const auto shell = [&](const std::string& command) {
    return waited_for(spawned({"/bin/sh", "-c", "cd '" + folder_.string() + "' && " + command}));
  };
  if (shell("unshare --user --map-root-user --mount true") != 0)
    GTEST_SKIP() << "this machine lets nobody mount a small disk";
  write_sample_recording(recording_, 30);
  EXPECT_EQ(shell(full + " 2> errors.txt"), 3);
  EXPECT_THAT(bytes("errors.txt"), HasSubstr("cannot be written (No space left on device)"));
  const std::size_t complete = pictures("copy").size();
  EXPECT_GT(complete, 0U);
  EXPECT_LT(complete, 30U);
  EXPECT_THAT(output_of(play_small("--resume -o 'copy/{frame}.png'")),
              HasSubstr(std::to_string(complete) + " were complete"));
}

TEST_F(LongJob, what_a_kill_left_is_removed_beside_pictures_in_no_folder_too) {
  for (const std::string leftover :
       {"0003.png.part99", "a/0003.png.part99", "0003.png.note", "0003.png.partial"})
    ASSERT_TRUE(write_file(folder_ / leftover, "half a picture"));
  for (const std::string pattern : {"{frame}.png", "a/{frame}.png"})
    ASSERT_EQ(play_small("--resume -o '" + pattern + "'").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "0003.png.part99"));
  EXPECT_FALSE(fs::exists(folder_ / "a/0003.png.part99"));
  for (const std::string nobodys : {"0003.png.note", "0003.png.partial"})
    EXPECT_TRUE(fs::exists(folder_ / nobodys)) << nobodys;
}

// As a second task of the same shard removes it when it begins.
TEST_F(LongJob, a_picture_whose_temporary_file_is_taken_for_a_leftover_is_written_all_the_same) {
  const auto pattern = FramePattern::parse((folder_ / "a/{frame}.png").string()).value();
  fs::create_directory(folder_ / "a");
  std::atomic<bool> removed = false;
  std::thread remover([&] {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    std::error_code code;
    while (!removed && std::chrono::steady_clock::now() < end)
      for (const auto& entry : fs::directory_iterator(folder_ / "a", code))
        if (entry.path().string().find(temporary_mark) != std::string::npos &&
            fs::remove(entry.path(), code))
          removed = true;
  });
  PictureFiles files(pattern, std::nullopt, {.all = true, .never = {}});
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!removed && std::chrono::steady_clock::now() < end)
    EXPECT_TRUE(files.put({1, 1, blank_picture({320, 200}, Color::Ones())}));
  remover.join();
  EXPECT_THAT(pictures("a"), ElementsAre("0001.png"));
}

TEST_F(LongJob, a_limit_on_the_size_of_files_will_not_pass) {
  const ToolRun limited = play_small("-o '{frame}.png'", "ulimit -f 1;");
  EXPECT_EQ(limited.exit_code, 2);
  EXPECT_THAT(limited.errors, HasSubstr("cannot be written (File too large)"));
  for (const std::string& name : names(".")) EXPECT_THAT(name, Not(HasSubstr(".part")));
}

// Sanitizers keep books, and what was given back, in the same memory.
#if defined(__has_feature)
constexpr bool memory_is_measurable = !__has_feature(address_sanitizer);
#else
constexpr bool memory_is_measurable = true;
#endif

// The most that a process has had in memory, in bytes.
double peak_of(const std::vector<std::string>& words) {
  const Ended ended = end_of(spawned(words));
  EXPECT_EQ(ended.exit_code, 0);
  return ended.most_memory;
}

TEST_F(LongJob, info_tells_how_much_memory_pictures_take) {
  if (!memory_is_measurable) GTEST_SKIP() << "memory is not measured under sanitizers";
  for (const std::string name : {"{frame}.png", "{frame}.exr"})
    for (const std::string size : {"64x48", "1280x720"}) {
      const std::vector<std::string> words{RIBBON_PLAY, recording_, "--quality", "draft",
                                           "--size",    size,       "--frames",  "2:5",
                                           "--force",   "--quiet",  "-o",        folder_ / name};
      const double peak = peak_of(words);
      const auto json = nlohmann::json::parse(output_of(run(filled_in(
          "knot.rbn --json --force --quality draft --frames 2 --size {} -o {}", size, name))));
      const double forecast = json["memory_bytes"];
      EXPECT_LT(peak, forecast) << name << " " << size;
      EXPECT_GT(2.5 * peak, forecast) << name << " " << size;
    }
}

TEST_F(LongJob, info_counts_the_memory_of_a_panorama_behind_the_scene) {
  ASSERT_TRUE(write_png(folder_ / "sky.png", blank_picture({2048, 1024}, Color::Ones())));
  const double peak = peak_of({RIBBON_PLAY, recording_, "--environment", folder_ / "sky.png",
                               "--backdrop", "environment", "--quality", "draft", "--frames", "2",
                               "--force", "--quiet", "-o", folder_ / "1.png"});
  const auto json = nlohmann::json::parse(output_of(
      run("knot.rbn --json --quality draft --environment sky.png --backdrop environment")));
  const double forecast = json["memory_bytes"];
  EXPECT_LT(peak, forecast);
  EXPECT_GT(2.5 * peak, forecast);
}

TEST_F(LongJob, info_tells_how_much_memory_previews_take) {
  if (!memory_is_measurable) GTEST_SKIP() << "memory is not measured under sanitizers";
  for (const std::string samples : {"1", "4"})
    for (const std::string size : {"64x48", "1280x720"}) {
      const double peak =
          peak_of({RIBBON_PLAY, recording_, "--preview", "--samples", samples, "--size", size,
                   "--frames", "2", "--force", "--quiet", "-o", folder_ / "1.png"});
      const auto json = nlohmann::json::parse(
          output_of(run(filled_in("knot.rbn --json --force --preview --samples {} --frames 2 "
                                  "--size {} -o 1.png",
                                  samples, size))));
      const double forecast = json["memory_bytes"];
      EXPECT_LT(peak, forecast) << samples << " " << size;
      EXPECT_GT(2.5 * peak, forecast) << samples << " " << size;
    }
}

// A strip that sways again and again.
void write_long_recording(const fs::path& path, int frames) {
  const RibbonGrid grid{60, 8};
  auto writer = RecordingWriter::create(path, sample_header(grid)).value();
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  for (int frame = 0; frame < frames; ++frame) {
    for (int p = 0; p < grid.particle_count(); ++p)
      positions.col(p) << 0.01 * grid.row(p), 0.01 * grid.column(p),
          0.001 * (frame % 100) * std::sin(0.2 * grid.row(p));
    ASSERT_TRUE(writer.append(sample_numbers(frame), positions).has_value());
  }
  ASSERT_TRUE(writer.finish().has_value());
}

TEST_F(LongJob, memory_does_not_grow_with_the_number_of_frames) {
  if (!memory_is_measurable) GTEST_SKIP() << "memory is not measured under sanitizers";
  const auto peak = [&](int frames) {
    write_long_recording(folder_ / "long.rbn", frames);
    // One thread: how many others find work in so short a run is chance, and each takes memory.
    return peak_of({RIBBON_PLAY, folder_ / "long.rbn", "--quality", "draft", "--size", "16x16",
                    "--threads", "1", "--quiet", "-o",
                    folder_ / ("{frame}-" + std::to_string(frames) + ".png"), "--plot",
                    folder_ / (std::to_string(frames) + ".svg")});
  };
  // But for the numbers and the place of each frame: a fifth of the 5760 bytes of its positions.
  constexpr double bytes_a_frame = 1000;
  // Many frames, for what the system counts as a program's most memory wavers by half a megabyte.
  EXPECT_LT(peak(2050), peak(50) + 2000 * bytes_a_frame);
}

TEST_F(LongJob, damage_is_told_and_the_rest_is_rendered) {
  damage();
  EXPECT_EQ(render_into("a", "--isa sse2 --shard 1/2").exit_code, 1);
  EXPECT_EQ(render_into("a", "--isa sse2 --shard 2/2").exit_code, 1);
  EXPECT_FALSE(pictures("a").empty());
}

}  // namespace ribbon::long_job_test
