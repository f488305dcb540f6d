// Writes what blender_import.py and motion_files_test.py compare: sample recordings, what they hold
// as JSON, and spoiled exports that their comparisons must refuse.
//
//   blender_samples FOLDER
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <iomanip>
#include <limits>

#include "converter/export/fbx_writer.h"
#include "converter/motion_format.h"
#include "files/files.h"
#include "model/obj_text.h"
#include "model/picture_file.h"
#include "model/sample_knot.h"
#include "model/sample_picture.h"
#include "model/textured_settings.h"
#include "playback/recording_reader.h"
#include "recording/writer/recording_writer.h"
#include "result/demanded.h"

namespace {

using ribbon::Model;
using Folder = std::filesystem::path;

void require(bool good, const char* what) {
  if (good) return;
  std::fprintf(stderr, "blender_samples: %s\n", what);
  std::exit(1);
}

template <class Columns>
void write_columns(std::ostream& json, const Columns& columns) {
  json << '[';
  for (Eigen::Index column = 0; column < columns.cols(); ++column) {
    json << (column > 0 ? ",[" : "[");
    for (Eigen::Index row = 0; row < columns.rows(); ++row)
      json << (row > 0 ? "," : "") << columns(row, column);
    json << ']';
  }
  json << ']';
}

void write_recording(const Folder& file, const ribbon::SampleKnot& knot) {
  auto writer = demanded(ribbon::RecordingWriter::create(file, knot.header));
  for (std::size_t frame = 0; frame < knot.frames.size(); ++frame)
    demanded(writer.append({.time_s = 0.02 * static_cast<double>(frame)}, knot.frames[frame]));
  demanded(writer.finish());
}

// Everything that an export of the recording must show, in the recording's own axes and units.
void write_reference(const Folder& recording, const Folder& file) {
  auto reader = demanded(ribbon::RecordingReader::open(recording));
  const ribbon::RecordingHeader& header = reader.header();
  std::ofstream json(file);
  json << std::setprecision(std::numeric_limits<double>::max_digits10);
  json << R"({"ribbon": ")" << header.scene_name << R"(", "obstacle": ")" << header.obstacle->name
       << R"(", "length": )" << header.ribbon_length_m << R"(, "frames_per_second": )"
       << header.frames_per_second << R"(, "uv": )";
  write_columns(json, header.uv);
  json << R"(, "quads": )" << header.grid.quad_count() << R"(, "obstacle_vertices": )";
  write_columns(json, header.obstacle->vertices);
  json << R"(, "obstacle_triangles": )" << header.obstacle->triangles.cols() << R"(, "frames": [)";
  for (int frame = 0; frame < reader.frame_count(); ++frame) {
    Eigen::Matrix3Xf positions;
    demanded(reader.read(frame, positions));
    json << (frame > 0 ? "," : "");
    write_columns(json, positions);
  }
  json << "]}\n";
  json.close();
  require(json.good(), "cannot write the reference");
}

Model model_of(const ribbon::SampleKnot& knot, const Eigen::Matrix3Xd& ribbon_positions) {
  Model model = ribbon::model_of_recording(knot.header, {}).value();
  model.objects[0].positions = ribbon_positions.cast<float>();
  return model;
}

// Frame 3 of the sample, in which vertices coincide.
constexpr std::size_t spoiled_frame = 2;

void write_spoiled(const Folder& folder, const ribbon::SampleKnot& knot, const std::string& fault,
                   const std::function<void(Model&)>& spoil) {
  Model model = model_of(knot, knot.frames[spoiled_frame]);
  spoil(model);
  demanded(ribbon::write_file(folder / (fault + ".obj"), ribbon::obj_text(model, "spoiled.mtl")));
  demanded(ribbon::write_file(folder / (fault + ".fbx"), ribbon::fbx_bytes(model).value()));
}

void swap_y_and_z(Model& model) {
  for (auto& object : model.objects) object.positions.row(1).swap(object.positions.row(2));
}

// The file says that its unit is the centimetre, though the numbers are metres.
std::string with_wrong_unit(std::string fbx) {
  const std::string key = "UnitScaleFactor";
  const double centimetre = 1;
  std::size_t found = fbx.find(key);
  require(found != std::string::npos, "no unit in the FBX");
  found = fbx.find('D', found + key.size() + sizeof "SdoubleSNumberS");
  std::memcpy(fbx.data() + found + 1, &centimetre, sizeof centimetre);
  return fbx;
}

using Motion = std::vector<Eigen::Matrix3Xf>;

void write_motion(const Folder& file, const ribbon::MotionFormat& format, Model model,
                  const Motion& motion) {
  model.objects.front().positions = motion.front();
  const auto writer = demanded(format.new_writer(file, model, static_cast<int>(motion.size())));
  for (const auto& positions : motion) {
    model.objects.front().positions = positions;
    demanded(writer->append(model));
  }
  demanded(writer->finish());
}

// A recording as it is decoded.
struct Recorded {
  Model model;  // in the pose of the first frame
  Motion motion;
};

Recorded recorded(const Folder& recording) {
  auto reader = demanded(ribbon::RecordingReader::open(recording));
  Recorded recorded{ribbon::model_of_recording(reader.header(), {}).value(),
                    Motion(static_cast<std::size_t>(reader.frame_count()))};
  for (int frame = 0; frame < reader.frame_count(); ++frame)
    demanded(reader.read(frame, recorded.motion[static_cast<std::size_t>(frame)]));
  return recorded;
}

// In every format that holds a whole motion.
void write_spoiled_motion(const Folder& folder, Recorded recorded, const std::string& fault,
                          const std::function<void(Recorded&)>& spoil) {
  spoil(recorded);
  for (const ribbon::MotionFormat& format : ribbon::motion_formats())
    write_motion(folder / (fault + std::string(format.extension)), format, recorded.model,
                 recorded.motion);
}

void write_all_spoiled_motions(const Folder& folder, const Folder& recording) {
  const Recorded right = recorded(recording);
  const float visible = 1e-4F * right.motion.front().row(0).maxCoeff();
  const auto write = [&](const std::string& fault, const std::function<void(Recorded&)>& spoil) {
    write_spoiled_motion(folder, right, fault, spoil);
  };
  write("right", [](auto&) {});
  write("moved_vertex", [&](Recorded& r) { r.motion[1](1, 17) += visible; });
  write("swapped_frames", [](Recorded& r) { r.motion[1].swap(r.motion[2]); });
  write("frozen", [](Recorded& r) { r.motion[1] = r.motion[2] = r.motion[4] = r.motion[0]; });
  write("wrong_rate", [](Recorded& r) { r.model.frames_per_second = 49; });
  write("moved_obstacle", [&](Recorded& r) { r.model.objects[1].positions(1, 3) += visible; });
  write("swapped_uv", [](Recorded& r) {
    auto& uv = r.model.objects[0].uv;
    uv.row(0).swap(uv.row(1));
  });
  write("inside_out", [](Recorded& r) {
    auto& faces = r.model.objects[0].faces;
    faces = faces.colwise().reverse().eval();
  });
  write("other_name", [](Recorded& r) { r.model.objects[0].name = "Mesh"; });
}

void enlarge(Model& model) {
  for (auto& object : model.objects) object.positions *= 100;
}

// Faults of more than positions, in the formats that hold the mesh and its motion.
void write_spoiled_scenes(const Folder& folder, const Folder& recording) {
  const auto write = [&](const std::string& fault, Recorded scene,
                         const std::function<void(Model&)>& spoil) {
    for (auto& positions : scene.motion) {
      Model posed = scene.model;
      posed.objects.front().positions = positions;
      spoil(posed);
      positions = posed.objects.front().positions;
    }
    spoil(scene.model);
    for (const Folder& file : {folder / (fault + ".glb"), folder / (fault + ".fbx")})
      write_motion(file, *ribbon::motion_format(file), scene.model, scene.motion);
  };
  const Recorded right = recorded(recording);
  write("right", right, [](auto&) {});
  write("one_frame", {right.model, {right.motion.front()}}, [](auto&) {});
  write("wrong_axes", right, swap_y_and_z);
  write("hundredfold", right, enlarge);
  const std::string fbx = demanded(ribbon::read_file(folder / "right.fbx"));
  demanded(ribbon::write_file(folder / "wrong_unit.fbx", with_wrong_unit(fbx)));
}

// With a picture on the ribbon, the picture itself, and normals.
void write_textured(const Folder& folder, const Folder& recording) {
  const Folder file = folder / "textured.png";
  demanded(ribbon::write_file(file, ribbon::sample_png()));
  auto picture = demanded(ribbon::read_picture_file(file));
  picture.name = file.filename();
  const ribbon::ModelSettings settings{
      .with_normals = true,
      .picture = std::make_shared<const ribbon::PictureFile>(std::move(picture))};
  auto [model, motion] = recorded(recording);
  model = ribbon::model_of_recording(ribbon::RecordingReader::open(recording).value().header(),
                                     settings)
              .value();
  const Folder glb = folder / "textured.glb";
  write_motion(glb, *ribbon::motion_format(glb), model, motion);
}

// Normals that nobody renews when the mesh moves.
void write_stale_normals(const Folder& folder, const Folder& recording) {
  auto [model, motion] = recorded(recording);
  model = ribbon::model_of_recording(ribbon::RecordingReader::open(recording).value().header(),
                                     {.with_normals = true})
              .value();
  for (const Folder& file : {folder / "motion.abc", folder / "motion.usda"})
    write_motion(file, *ribbon::motion_format(file), model, motion);
}

// As a solid, with a picture on each side.
void write_textured_on_both_sides(const Folder& folder, const Folder& recording) {
  ribbon::ModelSettings settings = ribbon::textured_on_both_sides();
  auto [model, motion] = recorded(recording);
  model = ribbon::model_of_recording(ribbon::RecordingReader::open(recording).value().header(),
                                     settings)
              .value();
  for (auto& positions : motion) {
    require(demanded(ribbon::pose_ribbon(model, positions, 1)), "no solid");
    positions = model.objects.front().positions;
  }
  const Folder glb = folder / "both_sides.glb";
  write_motion(glb, *ribbon::motion_format(glb), model, motion);
}

void write_all_spoiled(const Folder& folder, const ribbon::SampleKnot& knot) {
  const double visible = 1e-4 * knot.header.ribbon_length_m;
  write_spoiled(folder, knot, "right", [](Model&) {});
  write_spoiled(folder, knot, "moved_vertex",
                [&](Model& m) { m.objects[0].positions(1, 17) += static_cast<float>(visible); });
  write_spoiled(folder, knot, "moved_obstacle",
                [&](Model& m) { m.objects[1].positions(1, 3) += static_cast<float>(visible); });
  write_spoiled(folder, knot, "wrong_axes", swap_y_and_z);
  write_spoiled(folder, knot, "hundredfold", enlarge);
  write_spoiled(folder, knot, "swapped_uv",
                [](Model& m) { m.objects[0].uv.row(0).swap(m.objects[0].uv.row(1)); });
  write_spoiled(folder, knot, "wrong_name", [](Model& m) { m.objects[0].name = "Mesh"; });
  write_spoiled(folder, knot, "swapped_vertices", [](Model& m) {
    m.objects[0].positions.col(3).swap(m.objects[0].positions.col(4));
  });
  const Model right = model_of(knot, knot.frames[spoiled_frame]);
  demanded(ribbon::write_file(folder / "wrong_unit.fbx",
                              with_wrong_unit(ribbon::fbx_bytes(right).value())));
}

// The narrowest ribbon, for more frames than a byte can count, at the rate of American television.
ribbon::SampleKnot long_knot() {
  ribbon::SampleKnot knot = ribbon::sample_knot({.along = 12, .across = 2});
  knot.header.frames_per_second = 30000.0 / 1001;
  while (knot.frames.size() < 300)
    knot.frames.push_back(
        ribbon::sample_wave(knot.header.grid, 0.01 * static_cast<double>(knot.frames.size())));
  return knot;
}

// Lies in the plane y = 0.3, along x and across z, far above the obstacle.
ribbon::SampleKnot flat_knot() {
  ribbon::SampleKnot knot = ribbon::sample_knot();
  for (auto& positions : knot.frames) {
    positions = knot.frames.front();
    positions.row(1).setConstant(0.3);
  }
  knot.header.obstacle->vertices.row(1).array() -= 1;
  return knot;
}

void write_sample(const Folder& folder, const std::string& name, const ribbon::SampleKnot& knot) {
  write_recording(folder / (name + ".rbn"), knot);
  write_reference(folder / (name + ".rbn"), folder / (name + ".json"));
}

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: blender_samples FOLDER");
  const Folder folder = argv[1];
  const ribbon::RibbonGrid grid{.along = 12, .across = 4};
  write_sample(folder, "near", ribbon::sample_knot(grid));
  write_sample(folder, "far", ribbon::sample_knot(grid, {1000, 2000, -3000}));
  write_sample(folder, "long", long_knot());
  write_sample(folder, "flat", flat_knot());
  write_all_spoiled(folder / "spoiled", ribbon::sample_knot(grid));
  write_all_spoiled_motions(folder / "spoiled_motions", folder / "near.rbn");
  write_spoiled_scenes(folder / "spoiled_scenes", folder / "near.rbn");
  write_stale_normals(folder / "stale_normals", folder / "near.rbn");
  write_textured(folder / "textured", folder / "near.rbn");
  write_textured_on_both_sides(folder / "textured", folder / "flat.rbn");
}
