#include "player/write_pictures.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cstdio>
#include <utility>

#include "commandline/interrupt.h"
#include "commandline/progress.h"
#include "player/film_renderer.h"
#include "player/made_of.h"
#include "player/shots.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

OutputRequest request_of(const RecordingReader& reader, const Options& options, std::string name,
                         Stopped stopped) {
  return {.name = std::move(name),
          .size = options.size,
          .frames_per_second =
              options.order.frames_per_second.value_or(reader.header().frames_per_second),
          .made_of = {},
          .shard = options.shard,
          .resumes = options.resume,
          .replaceable = options.replaceable,
          .stopped = std::move(stopped)};
}

// What is to be done for each shot.
Result<std::vector<Output>> open_outputs(const RecordingReader& reader, const Options& options,
                                         const std::vector<PlayedFrame>& film,
                                         const Stopped& stopped) {
  const auto names = output_names(options);
  if (!names) return tl::unexpected(names.error());
  std::vector<MadeOf> made(names->size());
  if (has_manifest(options.pictures, film.size(), options.resume)) {
    auto known = made_of(reader, options, names->size());
    if (!known) return tl::unexpected(known.error());
    made = *std::move(known);
  }
  std::vector<Output> outputs;
  for (std::size_t shot = 0; shot < names->size(); ++shot) {
    OutputRequest request = request_of(reader, options, (*names)[shot], stopped);
    request.made_of = made[shot];
    auto output = open_output(request, film);
    if (!output) return tl::unexpected(output.error());
    outputs.push_back(*std::move(output));
  }
  return outputs;
}

// A stream keeps its time where frames are lost; files of the others keep their numbers.
Result<std::vector<PlayedFrame>> film_of(const RecordingReader& reader,
                                         const std::vector<int>& frames,
                                         const std::vector<int>& lost, const Options& options) {
  const auto format = picture_format(options.pictures);
  if (!format) return tl::unexpected(format.error());
  auto film = played_frames(frames, reader.header().frames_per_second, options.order);
  if (!film) return film;
  return is_one_file_each(*format) ? without(*std::move(film), lost)
                                   : held_over(*std::move(film), lost);
}

// All of them, whatever becomes of one.
Result<void> finish(std::vector<Output>& outputs) {
  Result<void> all;
  for (Output& output : outputs)
    if (auto finished = output.sink->finish(); !finished && all) all = finished;
  return all;
}

std::string pictures_text(std::size_t count) {
  return filled_in("{} {}", count, count == 1 ? "picture" : "pictures");
}

// Nothing where all pixels have the same number of samples.
std::string noise_text(const NoiseReached& noise) {
  if (noise.error == 0) return "";
  std::string text = filled_in(", estimated error up to {:.2g} levels of 255", noise.error);
  if (noise.wanting > 0)
    text +=
        filled_in(" ({:.2g} % of the regions have more than was aimed at)", 100 * noise.wanting);
  return text;
}

std::string summary(int done, double elapsed_s, const std::vector<Output>& outputs) {
  std::size_t complete = 0;
  for (const Output& output : outputs) complete += output.complete;
  const std::string kept = complete == 0 ? "" : filled_in(", {} were complete", complete);
  if (done == 0) return pictures_text(0) + kept;
  const auto last = std::find_if(outputs.rbegin(), outputs.rend(),
                                 [](const Output& output) { return !output.frames.empty(); });
  assert(last != outputs.rend());
  return pictures_text(done) + kept +
         filled_in(", {:.2f} s each, last: {}", elapsed_s / done, last->last);
}

}  // namespace

Result<std::string> write_pictures(RecordingReader& reader, const std::vector<int>& frames,
                                   const std::vector<int>& lost, const Options& options) {
  const auto film = film_of(reader, frames, lost, options);
  if (!film) return tl::unexpected(film.error());
  const auto shots = shots_of(options);
  if (!shots) return tl::unexpected(shots.error());
  const Interrupt interrupt;
  auto outputs =
      open_outputs(reader, options, *film, [&interrupt] { return interrupt.requested(); });
  if (!outputs) return tl::unexpected(outputs.error());
  // Cameras and colours would read every frame.
  if (std::ranges::all_of(*outputs, [](const Output& output) { return output.frames.empty(); })) {
    ProgressLine("picture", 0, options.progress).end();
    return summary(0, 0, *outputs);
  }
  const auto start = std::chrono::steady_clock::now();
  FilmRenderer renderer(reader, options, *shots, *outputs);
  if (auto prepared = renderer.prepare(readable_frames(frames, lost)); !prepared)
    return tl::unexpected(prepared.error());
  for (const PlayedFrame& frame : *film) {
    if (interrupt.requested())
      return passing_failure("", filled_in("interrupted before frame {}", frame.index + 1),
                             "run it again, with --resume where pictures are files");
    if (auto done = renderer.render(frame); !done) return tl::unexpected(done.error());
  }
  if (auto finished = finish(*outputs); !finished) return tl::unexpected(finished.error());
  renderer.end();
  if (renderer.interpolated().moments > 0)
    std::fprintf(stderr, "ribbon-play: %s\n", sentence_on(renderer.interpolated()).c_str());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return summary(renderer.done(), elapsed.count(), *outputs) + noise_text(renderer.noise());
}

LivePictures::LivePictures(RecordingReader& reader, const Options& options)
    : reader_(reader), options_(options) {}

Result<void> LivePictures::begin(const Interrupt& interrupt) {
  const auto names = output_names(options_);
  if (!names) return tl::unexpected(names.error());
  // A film ends by Ctrl-C, and ffmpeg has the time that it needs to complete it.
  const bool is_read = options_.pictures == "-";
  const Stopped stopped =
      is_read ? Stopped([&interrupt] { return interrupt.requested(); }) : Stopped();
  for (const std::string& name : *names) {
    auto output = open_live_output(request_of(reader_, options_, name, stopped));
    if (!output) return tl::unexpected(output.error());
    outputs_.push_back(*std::move(output));
  }
  auto shots = shots_of(options_);
  if (!shots) return tl::unexpected(shots.error());
  shots_ = std::move(*shots);
  auto painter = FramePainter::create(reader_, options_, {});
  if (!painter) return tl::unexpected(painter.error());
  painter_.emplace(*std::move(painter));
  return {};
}

Result<void> LivePictures::show(int index) {
  if (!cameras_) {
    cameras_.emplace(reader_, shots_);
    painter_->set_lowest(cameras_->lowest_m());
  }
  cameras_->follow(reader_);
  waiting_.insert(waiting_.end(), 1 + std::exchange(lost_before_, 0), index);
  last_ = index;
  return render_settled();
}

Result<void> LivePictures::pass_lost() {
  if (is_one_file_each(outputs_.front().format)) return {};
  if (last_)
    waiting_.push_back(*last_);
  else
    ++lost_before_;
  return render_settled();
}

Result<void> LivePictures::render_settled() {
  for (; !waiting_.empty() && cameras_->is_settled(waiting_.front()); waiting_.pop_front())
    if (auto rendered = render(waiting_.front()); !rendered) return rendered;
  return {};
}

Result<void> LivePictures::render(int index) {
  if (auto shown = painter_->show(index); !shown) return shown;
  for (std::size_t shot = 0; shot < shots_.size(); ++shot) {
    const Camera camera = cameras_->camera(shot, {index, 0});
    const PlayedFrame frame{.index = index, .number = index + 1};
    auto picture = rendered(*painter_, camera, options_.size, outputs_[shot].format, frame);
    if (!picture) return tl::unexpected(picture.error());
    if (auto taken = outputs_[shot].sink->put(*std::move(picture)); !taken) return taken;
  }
  return {};
}

Result<void> LivePictures::finish(const Interrupt& interrupt) {
  if (cameras_) cameras_->end();
  for (; !waiting_.empty() && !interrupt.requested(); waiting_.pop_front())
    if (auto rendered = render(waiting_.front()); !rendered) return rendered;
  return ribbon::finish(outputs_);
}

}  // namespace ribbon
