// ribbon-play as its users run it.
#include <gtest/gtest.h>
#include <png.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "files/files.h"
#include "player/picture/picture.h"
#include "player/report/follow.h"
#include "player/ribbon_play.h"
#include "recording/sample_recording.h"
#include "recording/writer/recording_writer.h"

namespace ribbon::command_line_test {

namespace fs = std::filesystem;

PictureSize png_size(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
  png_image_free(&image);
  return {static_cast<int>(image.width), static_cast<int>(image.height)};
}

TEST_F(RibbonPlay, every_frame_becomes_a_picture) {
  EXPECT_THAT(output_of(play_small("-o 'frames/{frame:04}.png'")), HasSubstr("7 pictures"));
  EXPECT_THAT(pictures("frames"), ElementsAre("0001.png", "0002.png", "0003.png", "0004.png",
                                              "0005.png", "0006.png", "0007.png"));
  EXPECT_EQ(png_size(bytes("frames/0007.png")), (PictureSize{64, 48}));
}

TEST_F(RibbonPlay, frames_are_chosen_by_range_and_step) {
  EXPECT_EQ(play_small("-o 'a/{frame:04}.png' --frames 2:-1:2 --quiet").exit_code, 0);
  EXPECT_THAT(pictures("a"), ElementsAre("0002.png", "0004.png", "0006.png"));
  expect_refusal(play_small("-o 'b/{frame}.png' --frames 8"), "7 frames");
}

TEST_F(RibbonPlay, a_single_picture_needs_no_place_for_its_number) {
  EXPECT_EQ(play_small("-o last.png --frames -1 --quiet").exit_code, 0);
  EXPECT_EQ(png_size(bytes("last.png")), (PictureSize{64, 48}));
  expect_refusal(play_small("-o last.png"), "no place for the frame number");
}

TEST_F(RibbonPlay, the_noise_that_was_reached_is_told) {
  EXPECT_THAT(output_of(run("knot.rbn --size 64x48 -o asked.png --frames -1 --noise 4")),
              HasSubstr("estimated error up to "));
  EXPECT_THAT(output_of(play_small("-o even.png --frames -1")), Not(HasSubstr("estimated error")));
}

TEST_F(RibbonPlay, a_frame_is_the_same_whatever_else_is_rendered_and_by_how_many_threads) {
  ASSERT_EQ(play_small("-o 'all/{frame:01}.png' --threads 1").exit_code, 0);
  ASSERT_EQ(play_small("-o 'one/{frame:01}.png' --frames 5 --threads 3").exit_code, 0);
  ASSERT_FALSE(bytes("one/5.png").empty());
  EXPECT_EQ(bytes("all/5.png"), bytes("one/5.png"));
  EXPECT_NE(bytes("all/5.png"), bytes("all/6.png"));
}

TEST_F(RibbonPlay, a_preview_needs_no_display_and_is_the_same_by_any_number_of_threads) {
  const auto preview = [&](const std::string& folder, int threads) {
    return run("knot.rbn --preview --size 320x200 --quiet -o '" + folder +
                   "/{frame:01}.png' --threads " + std::to_string(threads),
               "env -u DISPLAY -u WAYLAND_DISPLAY");
  };
  EXPECT_EQ(output_of(preview("one", 1)), "");
  EXPECT_EQ(output_of(preview("many", 3)), "");
  ASSERT_EQ(png_size(bytes("one/7.png")), (PictureSize{320, 200}));
  for (int frame = 1; frame <= 7; ++frame) {
    const std::string name = "/" + std::to_string(frame) + ".png";
    EXPECT_EQ(bytes("one" + name), bytes("many" + name)) << frame;
  }
  EXPECT_NE(bytes("one/1.png"), bytes("one/7.png"));
}

TEST_F(RibbonPlay, more_samples_smooth_the_edges_of_a_preview) {
  ASSERT_EQ(run("knot.rbn --preview --frames 1 --size 64x48 -o rough.png").exit_code, 0);
  ASSERT_EQ(play_small("--preview --frames 1 -o 1.png").exit_code, 0);
  ASSERT_EQ(run("knot.rbn --preview --frames 1 --size 64x48 --samples 4 -o 4.png").exit_code, 0);
  EXPECT_EQ(bytes("rough.png"), bytes("1.png")) << "as usual";
  EXPECT_NE(bytes("1.png"), bytes("4.png"));
}

TEST_F(RibbonPlay, a_preview_without_osmesa_is_refused_and_nothing_else_is) {
  ASSERT_TRUE(write_file(folder_ / "libOSMesa.so.8", "no library"));
  const std::string without = "LD_LIBRARY_PATH='" + folder_.string() + "'";
  expect_refusal(run("knot.rbn --preview --frames 1 -o 1.png", without), "cannot load OSMesa: ");
  EXPECT_THAT(run("knot.rbn --preview --frames 1 -o 1.png", without).errors,
              HasSubstr("install OSMesa (Debian: libosmesa6)"));
  EXPECT_EQ(run("knot.rbn --frames 1 --size 16x16 -o 1.png", without).exit_code, 0);
}

TEST_F(RibbonPlay, a_preview_takes_captions_and_refuses_what_only_the_ray_tracer_shows) {
  const std::string preview = "knot.rbn --preview --frames 1 --size 320x200 ";
  ASSERT_EQ(run(preview + "-o plain.png").exit_code, 0);
  ASSERT_EQ(run(preview + "-o told.png --overlay frame,time").exit_code, 0);
  EXPECT_NE(bytes("plain.png"), bytes("told.png"));
  expect_refusal(run(preview + "-o 1.png --overlay wireframe"),
                 "does not go with wireframe overlays");
  const std::string drawn = preview + "-o 1.png ";
  for (const std::string option : {"--color-by strain", "--quality final", "--noise 1", "--ground",
                                   "--thickness 1", "--shard 1/2", "--shard 1/2 --isa avx2"})
    expect_refusal(run(drawn + option), "--preview: does not go with --");
  expect_refusal(play_small("-o 1.png --frames 1 --backdrop environment"),
                 "add --environment FILE");
  expect_refusal(run(preview + "-o 1.exr"), "write .png files, or leave --preview out");
}

TEST_F(RibbonPlay, the_input_curve_is_laid_over_pictures_where_the_recording_tells_it) {
  ASSERT_EQ(play_small("-o plain.png --frames 1").exit_code, 0);
  ASSERT_EQ(play_small("-o curve.png --frames 1 --overlay curve").exit_code, 0);
  EXPECT_NE(bytes("plain.png"), bytes("curve.png"));
  RecordingHeader header = sample_header();
  header.input_curve.resize(3, 0);
  fs::remove(recording_);
  write_recording(recording_, header, {sample_positions(0)}, Ending::finished);
  expect_refusal(play_small("-o none.png --overlay curve"), "does not tell the curve");
}

TEST_F(RibbonPlay, a_contact_sheet_can_be_a_preview) {
  ASSERT_EQ(run("knot.rbn --preview --sheet sheet.png").exit_code, 0);
  EXPECT_GT(png_size(bytes("sheet.png")).width, 5 * 520);
}

TEST_F(RibbonPlay, a_preview_of_no_frames_or_of_an_absurd_size_is_refused) {
  write_sample_recording(recording_, 0);
  expect_refusal(play_small("--preview -o '{frame}.png'"), "holds no frames");
  expect_refusal(run("knot.rbn --preview --size 99999x5 -o '{frame}.png'"), "not a picture size");
}

TEST_F(RibbonPlay, a_contact_sheet_is_one_file) {
  EXPECT_EQ(run("knot.rbn --samples 1 --sheet out/sheet.png").exit_code, 0);
  EXPECT_GT(png_size(bytes("out/sheet.png")).width, 5 * 520);
}

TEST_F(RibbonPlay, a_contact_sheet_of_stages_shows_where_they_end_and_the_last_frame) {
  RecordingHeader header = sample_header();
  header.stages = {"half knot", "bow"};
  auto writer = RecordingWriter::create(recording_, header, Overwrite::yes).value();
  for (int frame = 0; frame < 70; ++frame) {
    FrameNumbers numbers = sample_numbers(frame);
    numbers.stage = frame < 30 ? 1 : frame < 50 ? 2 : 0;
    ASSERT_TRUE(writer.append(numbers, sample_positions(frame)).has_value());
  }
  ASSERT_TRUE(writer.finish().has_value());
  const auto columns_of = [&](const std::string& frames) {
    EXPECT_EQ(run("knot.rbn --samples 1 --force --sheet sheet.png --frames " + frames).exit_code,
              0);
    return png_size(bytes("sheet.png")).width / 520;
  };
  EXPECT_EQ(columns_of("1:70"), 4) << "1, 30, 50, 70";
  EXPECT_EQ(columns_of("70:1:-1"), 4);
  EXPECT_EQ(columns_of("1:51"), 3) << "1, 30, 50: the next is hardly another";
  EXPECT_EQ(columns_of("1:50"), 3) << "1, 30, 50";
  EXPECT_EQ(columns_of("30:50"), 2) << "30, 50";
  EXPECT_EQ(columns_of("40:70"), 5) << "without the end of the first";
}

TEST_F(RibbonPlay, a_contact_sheet_shows_the_frames_and_views_that_are_named) {
  write_sample_recording(recording_, 20);
  const auto sheet = [&](const std::string& arguments, const std::string& told) {
    EXPECT_THAT(output_of(run("knot.rbn --samples 1 --force --sheet s.png " + arguments)),
                HasSubstr("s.png, " + told));
    const PictureSize size = png_size(bytes("s.png"));
    return std::pair(size.width / 520, size.height / 300);
  };
  EXPECT_EQ(sheet("--frames 1,2,3,4,5,6,7,8", "8 of 8 frames"), std::pair(8, 2));
  EXPECT_EQ(sheet("--frames ::2", "10 of 10 frames"), std::pair(10, 2));
  EXPECT_EQ(sheet("--frames 1:12", "12 of 12 frames"), std::pair(12, 2));
  EXPECT_EQ(sheet("--frames 1:13", "5 of 13 frames"), std::pair(5, 2));
  EXPECT_EQ(sheet("", "5 of 20 frames"), std::pair(5, 2));
  EXPECT_EQ(sheet("--frames 7 --view top", "1 of 1 frames"), std::pair(1, 1));
  const std::string top = bytes("s.png");
  EXPECT_EQ(sheet("--frames 7 --view front", "1 of 1 frames"), std::pair(1, 1));
  EXPECT_NE(bytes("s.png"), top);
  EXPECT_EQ(sheet("--frames 7 --view top --view knot --view front", "1 of 1 frames"),
            std::pair(1, 3));
}

TEST_F(RibbonPlay, a_ribbon_is_coloured_by_what_is_measured) {
  ASSERT_EQ(play_small("-o cloth.png --frames 5").exit_code, 0);
  std::set<std::string> pictures = {bytes("cloth.png")};
  for (const std::string quantity : {"strain", "speed", "contact", "gap"}) {
    ASSERT_EQ(play_small("-o c.png --force --frames 5 --color-by " + quantity).exit_code, 0)
        << quantity;
    EXPECT_TRUE(pictures.insert(bytes("c.png")).second) << quantity;
    EXPECT_EQ(
        run("knot.rbn --samples 1 --sheet sheet.png --force --color-by " + quantity).exit_code, 0)
        << quantity;
  }
  ASSERT_EQ(
      play_small("-o c.png --force --frames 5 --color-by strain --color-range 0:90").exit_code, 0);
  EXPECT_TRUE(pictures.insert(bytes("c.png")).second);
}

TEST_F(RibbonPlay, colours_and_overlays_do_not_depend_on_threads) {
  const std::string arguments =
      "--frames 3:5 --color-by gap --overlay wireframe,obstacle-wireframe,curve,frame,time,numbers "
      "--threads ";
  ASSERT_EQ(play_small("-o 'a/{frame:01}.png' " + arguments + "1").exit_code, 0);
  ASSERT_EQ(play_small("-o 'b/{frame:01}.png' " + arguments + "3").exit_code, 0);
  for (const std::string file : {"3.png", "4.png", "5.png"}) {
    ASSERT_FALSE(bytes("a/" + file).empty());
    EXPECT_EQ(bytes("a/" + file), bytes("b/" + file));
  }
}

TEST_F(RibbonPlay, what_colours_and_overlays_cannot_be_is_told) {
  expect_refusal(play_small("-o c.png --frames 1 --color-by mood"), "--color-by");
  expect_refusal(play_small("-o c.png --frames 1 --color-range 0:1"), "--color-by");
  expect_refusal(play_small("-o c.png --frames 1 --color-by gap --color-range 3"),
                 "--color-range 3: is not a range; write A:B");
  expect_refusal(play_small("-o c.png --frames 1 --overlay frames"), "does not know 'frames'");
  expect_refusal(play_small("-o '{frame}.png' --follow --color-by speed"), "add --color-range");
}

TEST_F(RibbonPlay, followed_pictures_have_colours_and_overlays) {
  const std::string arguments = " --color-by speed --color-range 0:1 --overlay frame,wireframe";
  ASSERT_EQ(play_small("-o 'a/{frame:01}.png' --follow --quiet" + arguments).exit_code, 0);
  ASSERT_EQ(play_small("-o 'b/{frame:01}.png'" + arguments).exit_code, 0);
  for (const std::string file : {"1.png", "7.png"}) {
    ASSERT_FALSE(bytes("a/" + file).empty());
    EXPECT_EQ(bytes("a/" + file), bytes("b/" + file));
  }
}

TEST_F(RibbonPlay, charts_are_svg_or_png_as_the_name_says) {
  EXPECT_THAT(output_of(run("knot.rbn --plot out/knot.svg")), HasSubstr("charts: out/knot.svg"));
  EXPECT_THAT(bytes("out/knot.svg"), HasSubstr("recovery iterations"));
  EXPECT_EQ(run("knot.rbn --plot capital.SVG").exit_code, 0);
  EXPECT_TRUE(bytes("capital.SVG") == bytes("out/knot.svg"));
  EXPECT_EQ(run("knot.rbn --plot knot.png").exit_code, 0);
  EXPECT_GT(png_size(bytes("knot.png")).width, 800);
  expect_refusal(run("knot.rbn --plot knot.pdf"), "is neither .svg nor .png");
  expect_refusal(run("knot.rbn --plot knot.rbn/knot.svg"), "knot.rbn");
}

TEST_F(RibbonPlay, no_two_files_have_one_name) {
  const std::string recording = bytes("knot.rbn");
  expect_refusal(run("knot.rbn --sheet a.png --plot ./a.png"), "./a.png: is the name of two files");
  expect_refusal(run("knot.rbn -o a.png --frames 1 --sheet a.png --force"), "two files");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
  EXPECT_TRUE(bytes("knot.rbn") == recording);
}

TEST_F(RibbonPlay, a_taken_name_is_told_before_anything_is_rendered) {
  ASSERT_TRUE(write_file(folder_ / "taken.png", "older"));
  for (const std::string job :
       {"-o 'film/{frame}.png' --sheet taken.png", "-o 'film/{frame}.png' --plot taken.png",
        "--plot new.svg --sheet taken.png"})
    expect_refusal(run("knot.rbn --samples 1 " + job), "taken.png: exists already");
  EXPECT_THAT(names("."), ElementsAre("knot.rbn", "taken.png"));
}

TEST_F(RibbonPlay, a_folder_is_told_before_anything_is_rendered) {
  for (const std::string name : {"a.mp4", "a.png", "a.svg"}) fs::create_directory(folder_ / name);
  for (const std::string job :
       {"-o a.mp4", "-o {frame}.png --sheet a.png", "-o {frame}.png --plot a.svg"})
    expect_refusal(run("knot.rbn --samples 1 --force " + job), " is a folder; choose another name");
  EXPECT_THAT(names("."), ElementsAre("a.mp4", "a.png", "a.svg", "knot.rbn"));
}

// Not even by --force.
TEST_F(RibbonPlay, nothing_that_is_read_is_replaced) {
  ASSERT_EQ(run("knot.rbn -o 1.png --frames 1 --size 32x16").exit_code, 0);
  ASSERT_EQ(run("knot.rbn -o front.png --frames 2 --size 32x16").exit_code, 0);
  ASSERT_TRUE(write_file(folder_ / "path.png", "time,azimuth\n0,10\n1,20\n").has_value());
  const std::string recording = bytes("knot.rbn");
  const std::string picture = bytes("1.png");
  const std::string path = bytes("path.png");
  for (const char* output : {"-o 1.png --size 32x16 --frames 1", "-o ./{frame:01}.png",
                             "--sheet 1.png", "-o {frame:01}.png --resume"})
    for (const char* input :
         {"--texture 1.png", "--texture front.png --texture-back 1.png", "--environment 1.png"})
      expect_refusal(run(std::string("knot.rbn --force ") + output + " " + input),
                     "1.png: is read for what would be written there; choose another name");
  expect_refusal(run("knot.rbn --force --plot 1.png --sheet 2.png --texture 1.png"),
                 "1.png: is read for what would be written there");
  expect_refusal(run("knot.rbn -o path.png --frames 1 --force --camera-path path.png"),
                 "path.png: is read");
  expect_refusal(run("knot.rbn --sheet knot.rbn --force"), "is no .png");
  expect_refusal(run("knot.rbn -o knot.rbn --force"), "knot.rbn");
  EXPECT_TRUE(bytes("1.png") == picture && bytes("path.png") == path);
  EXPECT_TRUE(bytes("knot.rbn") == recording);
  EXPECT_EQ(run("knot.rbn -o 2.png --frames 1 --size 32x16 --texture 1.png").exit_code, 0);
}

TEST_F(RibbonPlay, charts_of_a_damaged_recording_have_gaps_and_say_so) {
  damage();
  const ToolRun plot = run("knot.rbn --plot knot.svg");
  EXPECT_EQ(plot.exit_code, 1);
  EXPECT_THAT(bytes("knot.svg"), HasSubstr("lost to damage"));
}

TEST_F(RibbonPlay, quiet_says_nothing) {
  EXPECT_EQ(output_of(play_small("-o '{frame}.png' --frames 1 --quiet")), "");
}

TEST_F(RibbonPlay, info_tells_what_the_recording_holds) {
  EXPECT_THAT(output_of(run("knot.rbn --info")),
              AllOf(HasSubstr("frames          7 in 0.12 s, 50 per second\n"),
                    HasSubstr("stone, 6 vertices, 8 triangles")));
}

TEST_F(RibbonPlay, info_as_json_parses) {
  const auto json = nlohmann::json::parse(output_of(run("knot.rbn --info --json")));
  EXPECT_EQ(json["frame_count"], 7);
  EXPECT_EQ(json["frames"][6]["recovery_iterations"], 12);
  EXPECT_EQ(json["file_bytes"], fs::file_size(recording_));
}

TEST_F(RibbonPlay, damage_costs_frames_and_is_told) {
  damage();
  const ToolRun info = run("knot.rbn --json");
  ASSERT_EQ(info.exit_code, 1);
  const auto missing = nlohmann::json::parse(info.output)["missing_frames"];
  ASSERT_FALSE(missing.empty());
  EXPECT_FALSE(nlohmann::json::parse(info.output)["damage"].empty());
  const ToolRun outcome = play_small("-o 'frames/{frame}.png'");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(pictures("frames").size(), 7 - missing.size());
  EXPECT_THAT(outcome.errors, HasSubstr("frames " + std::to_string(missing[0].get<int>())));
}

TEST_F(RibbonPlay, that_a_recording_was_cut_off_is_told_beside_its_pictures) {
  EXPECT_EQ(play_small("-o done.png --frames 1 --quiet").errors, "");
  fs::remove(recording_);
  write_sample_recording(recording_, 5, Ending::killed);
  for (const std::string job :
       {"-o 1.png --frames 1 --size 64x48", "--plot 1.svg", "--sheet 2.png"}) {
    const ToolRun cut_off = run("knot.rbn --quiet " + job);
    EXPECT_EQ(cut_off.exit_code, 0);
    EXPECT_EQ(
        cut_off.errors,
        "ribbon-play: knot.rbn: unfinished: it ends with frame 5, where its recorder was stopped\n")
        << job;
  }
}

TEST_F(RibbonPlay, follow_tells_of_every_frame_until_the_recorder_ends) {
  auto writer = RecordingWriter::create(recording_, sample_header()).value();
  append_sample_frames(writer, 0, 1);
  EXPECT_THAT(run("knot.rbn --info").output, HasSubstr("; more are being recorded"));
  ToolRun outcome;
  std::thread follower([&] { outcome = run("knot.rbn --follow --info"); });
  for (int frame = 1; frame < 20; ++frame) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    append_sample_frames(writer, frame, frame + 1);
  }
  { const RecordingWriter killed = std::move(writer); }
  follower.join();
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(
      outcome.errors,
      "ribbon-play: knot.rbn: unfinished: it ends with frame 20, where its recorder was stopped\n");
  for (int frame = 0; frame < 20; ++frame)
    EXPECT_THAT(outcome.output, HasSubstr(frame_line(frame, sample_numbers(frame)) + "\n"));
  EXPECT_THAT(outcome.output, HasSubstr("20 in 0.38 s, 50 per second; the recorder was stopped"));
}

TEST_F(RibbonPlay, follow_renders_what_is_there_and_tells_what_is_lost) {
  const ToolRun whole = play_small("-o 'frames/{frame}.png' --follow --quiet");
  EXPECT_EQ(whole.output + whole.errors, "");
  EXPECT_EQ(names("frames").size(), 7U);
  damage();
  const ToolRun damaged = play_small("-o 'frames/{frame}.png' --follow --force");
  EXPECT_EQ(damaged.exit_code, 1);
  EXPECT_THAT(damaged.errors, HasSubstr("lost to damage: frames "));
  expect_refusal(run("knot.rbn --follow --sheet sheet.png"), "--sheet");
  expect_refusal(run("knot.rbn --follow --frames 2"), "--frames");
}

TEST_F(RibbonPlay, a_recording_in_order_is_verified) {
  EXPECT_THAT(
      output_of(run("knot.rbn --verify")),
      AllOf(HasSubstr("frames          7 of 7 checked\n"), HasSubstr("intersections   none\n"),
            HasSubstr("; at least the stated 0.0001 m\n"), HasSubstr("knot            unknot"),
            HasSubstr("verdict         nothing is wrong\n")));
}

TEST_F(RibbonPlay, verification_as_json_does_not_depend_on_threads) {
  const std::string verify = "knot.rbn --verify --json --certify-every 3 --threads ";
  const std::string one = output_of(run(verify + "1"));
  EXPECT_EQ(one, output_of(run(verify + "3")));
  const auto json = nlohmann::json::parse(one);
  EXPECT_EQ(json["passed"], true);
  EXPECT_EQ(json["frames"]["checked"], 7);
  EXPECT_EQ(json["knot"]["certified_frames"], 3);
}

TEST_F(RibbonPlay, the_knot_between_two_places_is_certified_by_itself) {
  RecordingHeader header = sample_header();
  header.marks = {{"tip", 0.25}};
  write_recording(recording_, header, {sample_positions(0)});
  EXPECT_THAT(output_of(run("knot.rbn --verify --between tip 0.75")),
              HasSubstr("between         rows 10 and 29: unknot"));
  expect_refusal(run("knot.rbn --verify --between tipp 0.75"),
                 "--between tipp: is no place of the ribbon; write a share of the ribbon's length "
                 "from 0 to 1, or one of 'tip'");
  expect_refusal(run("knot.rbn --verify --between tip 1.5"), "--between 1.5: is no place");
  expect_refusal(run("knot.rbn --verify --between tip 0.25"), "no two rows lie between");
  expect_refusal(run("knot.rbn --between tip 0.75"), "--between requires --verify");
  expect_refusal(run("knot.rbn --verify --between tip"), "--between");
}

TEST_F(RibbonPlay, what_is_wrong_is_answered_with_1) {
  RecordingHeader header = sample_header();
  header.obstacle->vertices.row(1).array() += 0.2F;  // its tip is in the cloth
  write_recording(recording_, header, {sample_positions(0), sample_positions(1)});
  const ToolRun outcome = run("knot.rbn --verify");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("frame 1 (0.00 s): ribbon row"));
  EXPECT_THAT(outcome.output, HasSubstr("and obstacle triangle"));
  EXPECT_THAT(outcome.output, HasSubstr("WRONG: triangles intersect"));
}

TEST_F(RibbonPlay, a_recording_made_to_break_its_limit_of_strain_is_answered_with_1_and_its_place) {
  std::vector<Eigen::Matrix3Xd> frames(5, sample_positions(0));
  // Particle 6 of row 20 goes across, away from its neighbour, by a third of what is between them.
  frames[3](2, 125) += 0.02 / 3;
  RecordingHeader header = sample_header();
  header.strain_limit = 0.1;
  write_recording(recording_, header, frames);
  const ToolRun outcome = run("knot.rbn --verify");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output,
              HasSubstr(" % of edges along and across, in frame 4, from row 20 column 4 to row 20 "
                        "column 5; BEYOND the stated 10 %\n"));
  EXPECT_THAT(outcome.output, HasSubstr("WRONG: edges are strained beyond the limit\n"));

  header.strain_limit = 0;
  fs::remove(recording_);
  write_recording(recording_, header, frames);
  EXPECT_THAT(output_of(run("knot.rbn --verify")), HasSubstr("; no limit is stated\n"));
}

TEST_F(RibbonPlay, lost_frames_are_not_verified_and_that_is_wrong) {
  damage();
  const ToolRun outcome = run("knot.rbn --verify --json");
  EXPECT_EQ(outcome.exit_code, 1);
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_FALSE(json["frames"]["lost"].empty());
  EXPECT_EQ(json["wrong"], nlohmann::json::array({"frames are lost"}));
}

TEST_F(RibbonPlay, verification_is_refused_where_there_is_nothing_to_verify) {
  expect_refusal(run("knot.rbn --verify --frames 8"), "7 frames");
  expect_refusal(run("knot.rbn --verify --certify-every 0"), "--certify-every");
  expect_refusal(run("knot.rbn --info --certify-every 5"), "--verify");
  expect_refusal(run("knot.rbn --verify --sheet sheet.png"), "--sheet");
  expect_refusal(run("nowhere.rbn --verify"), "nowhere.rbn");
  write_sample_recording(recording_, 0);
  expect_refusal(run("knot.rbn --verify"), "no frames");
}

TEST_F(RibbonPlay, what_cannot_be_read_is_refused) {
  expect_refusal(run("nowhere.rbn --info"), "nowhere.rbn");
  ASSERT_TRUE(write_file(folder_ / "letter.rbn", "Dear reader, this is no recording at all."));
  expect_refusal(run("letter.rbn --info"), "letter.rbn");
  ASSERT_TRUE(write_file(folder_ / "empty.rbn", ""));
  expect_refusal(run("empty.rbn --info"), "empty.rbn");
}

TEST_F(RibbonPlay, a_recording_without_frames_has_no_pictures) {
  write_sample_recording(recording_, 0);
  EXPECT_EQ(run("knot.rbn --info").exit_code, 0);
  expect_refusal(play_small("-o '{frame}.png'"), "no frames");
  expect_refusal(run("knot.rbn --sheet sheet.png"), "no frames");
}

TEST_F(RibbonPlay, without_an_obstacle_the_ribbon_is_shown_alone) {
  const auto last_picture = [&](const std::string& name, const std::string& options) {
    output_of(play_small("--quiet -o " + name + " --frames -1 " + options));
    return bytes(name);
  };
  const std::string words = "--color-by contact --overlay wireframe,obstacle-wireframe,numbers";
  const std::string with = last_picture("with.png", "--view front");
  RecordingHeader header = sample_header();
  header.obstacle.reset();
  fs::remove(recording_);
  write_recording(recording_, header, {sample_positions(0), sample_positions(1)}, Ending::finished);
  const std::string alone = last_picture("alone.png", "--view front");
  EXPECT_NE(alone, with);
  EXPECT_NE(last_picture("colours.png", "--view front " + words), alone);
  for (const std::string view : {"top", "knot"}) last_picture(view + ".png", "--view " + view);
  output_of(run("knot.rbn --quiet --preview --size 64x48 -o preview.png --frames -1"));
  output_of(run("knot.rbn --samples 1 --quiet --sheet sheet.png"));
  EXPECT_THAT(output_of(play_small("--bench")), HasSubstr("plain Embree "));
}

TEST_F(RibbonPlay, a_texture_that_is_missing_or_broken_is_refused) {
  ASSERT_TRUE(write_file(folder_ / "broken.png", "no picture"));
  for (const std::string option : {"--texture", "--environment", "--preview --texture"}) {
    expect_refusal(run("knot.rbn -o 1.png --frames 1 " + option + " nowhere.png"), "nowhere.png");
    expect_refusal(run("knot.rbn -o 1.png --frames 1 " + option + " broken.png"),
                   "broken.png: is not a PNG picture");
  }
  EXPECT_FALSE(fs::exists(folder_ / "1.png"));
}

TEST_F(RibbonPlay, a_folder_that_cannot_be_written_is_refused) {
  ASSERT_TRUE(write_file(folder_ / "taken", "a file"));
  expect_refusal(play_small("-o 'taken/{frame}.png'"), "taken");
  expect_refusal(run("knot.rbn --sheet taken/sheet.png"), "taken");
}

TEST_F(RibbonPlay, absurd_sizes_are_refused) {
  for (const std::string size : {"0x0", "-5x100", "1e9x1e9", "99999x10", "1280", "x", "axb",
                                 "1280x720x3", "1280x", "9999999999999x16"})
    expect_refusal(run("knot.rbn -o '{frame}.png' --size=" + size), "--size");
}

TEST_F(RibbonPlay, absurd_numbers_are_refused) {
  expect_refusal(run("knot.rbn -o '{frame}.png' --samples 0"), "--samples");
  expect_refusal(run("knot.rbn -o '{frame}.png' --threads -1"), "--threads");
  expect_refusal(run("knot.rbn -o '{frame}.png' --turns nan"), "--turns");
  expect_refusal(run("knot.rbn -o '{frame}.png' --frames a:b"), "frames 'a:b'");
}

TEST_F(RibbonPlay, asking_for_nothing_or_for_something_unknown_is_refused) {
  expect_refusal(run("knot.rbn"), "nothing to do");
  expect_refusal(run("nothere.rbn"), "nothere.rbn: cannot be opened");
  expect_refusal(run("knot.rbn --turbo"), "--turbo");
  expect_refusal(run(""), "--help");
}

TEST_F(RibbonPlay, what_nothing_that_is_asked_for_looks_at_is_refused) {
  expect_refusal(run("knot.rbn --info --frames 500"),
                 "--frames: is nothing that --info looks at; leave it out");
  expect_refusal(run("knot.rbn --json --color-by strain"), "--color-by: is nothing that --json");
  expect_refusal(run("knot.rbn --verify --color-by strain"),
                 "--color-by: is nothing that --verify");
  expect_refusal(run("knot.rbn --verify --json --size 64x48"), "--size: is nothing that --verify");
  expect_refusal(run("knot.rbn --plot plot.svg --info --overlay time"),
                 "that --plot, --info looks");
  expect_refusal(run("knot.rbn --sheet sheet.png --size 64x48"), "--size: is nothing that --sheet");
  expect_refusal(run("knot.rbn --follow --view top"), "--view: is nothing that --follow");
  for (const std::string other : {"--json", "--info", "--verify", "--follow", "--plot plot.svg"})
    expect_refusal(run("knot.rbn --bench " + other), "--bench");
  EXPECT_TRUE(names(".") == std::set<std::string>{"knot.rbn"});
  EXPECT_EQ(run("knot.rbn --info --size 64x48 --view top --quality draft").exit_code, 0);
  EXPECT_EQ(run("knot.rbn --plot plot.svg --info --frames 2:5").exit_code, 0);
  EXPECT_EQ(run("knot.rbn -o 1.png --sheet 2.png --size 64x48 --frames 1").exit_code, 0);
}

TEST_F(RibbonPlay, help_has_examples_and_version_is_a_line) {
  EXPECT_THAT(output_of(run("--help")),
              HasSubstr("ribbon-play knot.rbn -o 'frames/{frame:04}.png'"));
  EXPECT_EQ(output_of(run("--version")), "ribbon-play " RIBBON_VERSION "\n");
}

TEST_F(RibbonPlay, several_views_go_to_files_of_their_own) {
  EXPECT_EQ(
      play_small("-o '{view}/{frame}.png' --frames 1 --view top --view lens=85 --quiet").exit_code,
      0);
  EXPECT_THAT(names("top"), ElementsAre("0001.png"));
  EXPECT_THAT(names("camera1"), ElementsAre("0001.png"));
  EXPECT_NE(bytes("top/0001.png"), bytes("camera1/0001.png"));
  expect_refusal(play_small("-o '{frame}.png' --view top --view knot"), "{view}");
  expect_refusal(play_small("-o '{frame}.png' --view sideways"), "sideways");
}

TEST_F(RibbonPlay, bench_tells_each_stage_and_how_much_of_embree_is_kept) {
  const std::string table = output_of(play_small("--bench"));
  for (const char* stage : {"replay ", "seek ", "ribbon's BVH", "PNG", "rays ", "plain Embree "})
    EXPECT_THAT(table, HasSubstr(stage));
}

}  // namespace ribbon::command_line_test
