// What a recording holds; FORMAT.md says how it lies in the file.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/centre_axis.h"
#include "geometry/limited_edges.h"
#include "geometry/rest_size.h"
#include "geometry/ribbon_grid.h"
#include "geometry/triangle_mesh.h"
#include "recording/codec/codec_parameters.h"

namespace ribbon {

// Where a recording branched off another one.
struct Origin {
  std::uint32_t recording_id = 0;
  std::string scene_name;
  std::uint32_t frame = 0;       // of that recording, from 0; its checkpoint was the beginning
  std::string changed_settings;  // "key = value", one a line

  bool operator==(const Origin&) const = default;
};

inline constexpr std::size_t most_recorded_marks = 255;
inline constexpr std::size_t most_recorded_stages = 255;

// A circle in the drawing that has a name, and where on the band it lies.
struct RecordedMark {
  std::string name;
  double share = 0;  // of the ribbon's length, from its first row

  bool operator==(const RecordedMark&) const = default;
};

// The part of the ribbon whose knot is to be certified by itself.
struct KnotBetween {
  std::array<double, 2> shares{};  // of the ribbon's length, in either order
  std::string expected;            // the name of a closed type: "reef knot"; empty: any

  bool operator==(const KnotBetween&) const = default;
};

// Everything about a recording that does not change from frame to frame.
struct RecordingHeader {
  std::string scene_name;  // never empty
  std::string scene_text;  // the scene's TOML
  std::string writer;      // program and version that wrote it
  RibbonGrid grid;
  Eigen::Matrix2Xf uv;  // 2 x particles, u along and v across, both from 0 to 1
  double ribbon_length_m = 0;
  double ribbon_width_m = 0;  // mean of all rows
  // One a row, each as single precision has it; empty: all are ribbon_width_m wide.
  std::vector<double> row_widths_m;
  double frames_per_second = 0;
  // Bound on every recorded coordinate; 0: each is the truth rounded to single precision.
  double max_position_error_m = 0;
  double quantisation_step_m = 0;  // see CodecParameters, and quantisation_step_m()
  std::optional<TriangleMesh> obstacle;
  // The writer guarantees that features that share no vertex (ribbon and ribbon, ribbon and
  // obstacle) are nowhere nearer to each other, in frames as they are decoded. 0: nothing is
  // stated.
  double stated_gap_m = 0;
  std::optional<CentreAxis> centre_axis;  // what the ribbon was fastened towards
  std::optional<Origin> origin;           // of a branch
  LimitedEdges limited_edges;             // whose strain is corrected
  // The writer guarantees that |length / rest length - 1| of none of them is larger, in frames as
  // they are decoded. 0: nothing is stated.
  double strain_limit = 0;
  // Names of those that it is fastened in, at most most_recorded_stages.
  std::vector<std::string> stages;
  std::vector<RecordedMark> marks;  // at most most_recorded_marks
  std::optional<KnotBetween> knot_between;
  // 3 x points, metres: the drawing, pulled apart where it crosses itself, that the ribbon was put
  // on. Empty: not told; else at least 2.
  Eigen::Matrix3Xf input_curve;
};

inline RestSize rest_size(const RecordingHeader& header) {
  return {header.grid, header.ribbon_length_m, header.ribbon_width_m, header.row_widths_m};
}

inline CodecParameters codec_parameters(const RecordingHeader& header) {
  return {header.grid, static_cast<float>(header.quantisation_step_m)};
}

// How tight a ribbon is that is being fastened.
struct TightnessNumbers {
  float progress = 0;  // way of the last two seconds along the pull over the way commanded: 1 free,
                       // 0 locked, below 0 drawn back
  float truncated = 0;    // fraction of the particles whose displacement the gate cut short,
                          // mean of the steps since the last frame
  float pull = 0;         // share of the fastening force that was applied, mean of the same steps
  float contact = 0;      // share of the rows that touch another part of the ribbon or the obstacle
  float rope_length = 0;  // rest length from the first to the last row that touches another part of
                          // the ribbon, over the ribbon's width

  bool operator==(const TightnessNumbers&) const = default;
};

// In the order in which they are written; the names are those of info and JSON.
struct TightnessColumn {
  const char* name;
  float TightnessNumbers::*value;
};
inline constexpr std::array<TightnessColumn, 5> tightness_columns = {
    {{"progress", &TightnessNumbers::progress},
     {"truncated", &TightnessNumbers::truncated},
     {"pull", &TightnessNumbers::pull},
     {"contact", &TightnessNumbers::contact},
     {"rope_length", &TightnessNumbers::rope_length}}};

// What ended the run; the numbers are those of the file.
enum class RunEnding : std::uint8_t {
  unknown = 0,
  duration = 1,
  tight = 2,
  stopped = 3,
  stages_over = 4,
  first_end_slips = 5,
  second_end_slips = 6,
  limit = 7
};

// "unknown", "duration", "tight", "stopped", ...
inline std::string_view word_for(RunEnding ending) {
  constexpr std::array<std::string_view, 8> words = {
      "unknown",         "duration",         "tight", "stopped", "stages over",
      "first end slips", "second end slips", "limit"};
  return words[static_cast<std::size_t>(ending)];
}

// Why a run was taken up; the numbers are those of the file. A run that is begun as its scene says
// needs no session.
enum class SessionReason : std::uint8_t { unknown = 0, resumed = 1, extended = 2, begun = 3 };

// "unknown", "resumed", "extended", "begun".
inline std::string_view word_for(SessionReason reason) {
  constexpr std::array<std::string_view, 4> words = {"unknown", "resumed", "extended", "begun"};
  return words[static_cast<std::size_t>(reason)];
}

// What is noted where a run is taken up.
struct SessionNote {
  SessionReason reason =
      SessionReason::unknown;    // resumed: it had not come to its end; begun: with
                                 // changed settings, which the scene's text has
  std::string program;           // and version
  std::string changed_settings;  // "key = value", one a line; empty: none

  bool operator==(const SessionNote&) const = default;
};

struct Session {
  std::uint32_t first_frame = 0;  // from 0: the first that it recorded
  SessionNote note;

  bool operator==(const Session&) const = default;
};

// The simulation's whole state, just after a frame was recorded.
struct Checkpoint {
  std::uint32_t frame = 0;  // from 0
  std::uint64_t steps = 0;  // simulation steps done
  std::string state;        // only the simulation knows what it says

  bool operator==(const Checkpoint&) const = default;
};

// The numbers of one frame, readable without its geometry.
struct FrameNumbers {
  double time_s = 0;
  double worst_strain = 0;  // largest |length / rest length - 1| of stretch and shear springs
  std::uint32_t penetrating_edges = 0;    // left over in this frame
  std::uint32_t recovery_iterations = 0;  // of Figure 15, summed over the steps since the last
                                          // frame
  std::optional<TightnessNumbers> tightness = std::nullopt;  // where something fastens the ribbon
  std::uint8_t stage = 0;  // from 1, of the header's, in which the last step was made; 0: none

  bool operator==(const FrameNumbers&) const = default;
};

// Of the stage that the frame lies in; empty where there is none, or none that the header names.
inline std::string_view stage_name(const RecordingHeader& header, const FrameNumbers& numbers) {
  return numbers.stage > 0 && numbers.stage <= header.stages.size()
             ? std::string_view(header.stages[numbers.stage - 1])
             : std::string_view();
}

}  // namespace ribbon
