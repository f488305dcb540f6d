// A small recording for the tests of whatever reads recordings.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "files/temporary_folder.h"
#include "recording/writer/recording_writer.h"

namespace ribbon {

// A ribbon of 40 x 6 particles, 1 m long and 0.1 m wide, that begins to twist about its own axis,
// with an octahedron named "stone" as obstacle. A gap of 0.1 mm is stated; the centre axis goes
// through (0, 0.5, 0) along (0, 0.6, 0.8).
RecordingHeader sample_header();

// The same without obstacle and of another grid, small enough for files of a few hundred bytes.
RecordingHeader sample_header(const RibbonGrid& grid);

// Where its particles truly are in a frame (from 0): 3 x 240, metres. The middle of the ribbon
// stays within the box from -0.6 to 0.6.
Eigen::Matrix3Xd sample_positions(int frame);

// Time frame / 50 s; strain 0.001 * frame; frame % 3 penetrating edges; 2 * frame iterations.
FrameNumbers sample_numbers(int frame);

// Appends the frames from `begin` to before `end`. Fails the running test when that does not work.
void append_sample_frames(RecordingWriter& writer, int begin, int end);

enum class Ending { finished, killed };

// Records the first `frames` frames to `path`; killed: without index and footer. Fails the running
// test when that does not work.
void write_sample_recording(const std::filesystem::path& path, int frames,
                            Ending ending = Ending::finished);

// Records positions (3 x particles each) at 50 frames a second, with the numbers of the sample's
// frames. Fails the running test when that does not work.
void write_recording(const std::filesystem::path& path, const RecordingHeader& header,
                     const std::vector<Eigen::Matrix3Xd>& frames, Ending ending = Ending::finished);

}  // namespace ribbon
