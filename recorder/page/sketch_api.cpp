// What tying_worker.js asks of libribbon: C functions. A number below 0 says that it did not work;
// sketch_text() then says why.
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "recorder/page/drawn_diagram.h"
#include "recorder/page/sketched_scene.h"
#include "recorder/page/taken_away.h"
#include "recorder/page/tying.h"
#include "scene/scene.h"

namespace {

using ribbon::Result;

std::string text;
std::optional<ribbon::TriangleMesh> object;
std::vector<float> outline;
std::unique_ptr<ribbon::Tying> tying;

int refused(const ribbon::Error& error) {
  text = error.sentence();
  return -1;
}

int done(const Result<void>& answer) {
  return answer ? 0 : refused(answer.error());
}

int told(Result<std::string> answer) {
  if (!answer) return refused(answer.error());
  text = *std::move(answer);
  return 0;
}

ribbon::TriangleMesh mesh_of(const char* name, const float* vertices, int vertex_count,
                             const int* triangles, int triangle_count) {
  return {name, Eigen::Map<const Eigen::Matrix3Xf>(vertices, 3, vertex_count),
          Eigen::Map<const Eigen::Matrix3Xi>(triangles, 3, triangle_count)};
}

std::vector<std::string> lines_of(const char* settings) {
  std::vector<std::string> lines;
  std::istringstream all(settings);
  for (std::string line; std::getline(all, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace

extern "C" {

const char* sketch_text() {
  return text.c_str();
}

// What the ribbon is tied round: metres, three a vertex; no vertices: nothing.
void sketch_object(const char* name, const float* vertices, int vertex_count, const int* triangles,
                   int triangle_count) {
  object.reset();
  if (vertex_count == 0) return;
  object = mesh_of(name, vertices, vertex_count, triangles, triangle_count);
}

// The text is then that of the scene (sketched_scene()); settings: one a line.
int sketch_scene(const char* file, const char* scene, const char* letters, const char* settings) {
  return told(ribbon::sketched_scene(file, scene, letters, lines_of(settings)));
}

// The text is then that of diagram_json().
int sketch_diagram(const char* file) {
  return told(ribbon::read_scene(file).and_then(
      [](const ribbon::Scene& scene) { return ribbon::diagram_json(scene, object); }));
}

// How many numbers the outline of the object has: silhouette().
int sketch_outline_length(const char* file) {
  const auto scene = ribbon::read_scene(file);
  if (!scene) return refused(scene.error());
  outline = object ? ribbon::silhouette(*object, scene->curve) : std::vector<float>();
  return static_cast<int>(outline.size());
}
const float* sketch_outline() {
  return outline.data();
}

// How many frames the run lasts at most. It takes the place of an earlier one.
int sketch_tie(const char* file, const char* recording) {
  tying.reset();
  auto begun = ribbon::Tying::begin(file, object, recording, "ribbon-record " RIBBON_VERSION);
  if (!begun) return refused(begun.error());
  tying = std::make_unique<ribbon::Tying>(*std::move(begun));
  return tying->most_frames();
}

// One frame more. 1: there is another one to come; 0: that was the last, and the text tells how it
// came out.
int sketch_next() {
  const auto goes_on = tying->next();
  if (!goes_on) return refused(goes_on.error());
  if (*goes_on) return 1;
  text = tying->summary();
  return 0;
}

// Ends it early; the text tells how far it came.
int sketch_stop() {
  if (auto stopped = tying->stop(); !stopped) return refused(stopped.error());
  text = tying->summary();
  return 0;
}

// Files to take away: taken_away.h.
int sketch_write_shape(const char* recording, int frame, const char* file) {
  return done(ribbon::write_shape(recording, frame, file));
}
int sketch_write_motion(const char* recording, const char* file) {
  return done(ribbon::write_motion(recording, file));
}
int sketch_write_object(const char* file, const char* name, const float* vertices, int vertex_count,
                        const int* triangles, int triangle_count) {
  return done(
      ribbon::write_object(mesh_of(name, vertices, vertex_count, triangles, triangle_count), file));
}
}
