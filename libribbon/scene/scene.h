// What the user asks for: a scene as read from its TOML file. docs/scene.md documents every key.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "result/result.h"
#include "scene/fabric.h"
#include "scene/integration_method.h"
#include "scene/named_file.h"
#include "scene/stage_scene.h"
#include "scene/width_profile.h"

namespace ribbon {

// A world axis. Curves are drawn as seen from its positive end, crossings are pulled apart along
// it.
enum class Axis { x, y, z };

struct DrawnPoints {
  std::vector<Eigen::Vector2d> points;  // at least 2, in drawing units, y down as in SVG

  bool operator==(const DrawnPoints&) const = default;
};

struct DrawnSvg {
  NamedFile file;
  std::string path_id;  // id of the path to use; empty: the only one

  bool operator==(const DrawnSvg&) const = default;
};

// Which strand passes over, passage by passage.
struct CrossingList {
  std::string letters;     // for each passage in the order of the walk: 'O' over or 'U' under, and
                           // where it comes before the object 'F' in front, behind it 'B'
  std::string place = {};  // where the scene says it: "knot.toml:12:8"; empty: nowhere

  // Wherever it stands.
  bool operator==(const CrossingList& other) const { return letters == other.letters; }
};

struct CurveScene {
  std::variant<DrawnSvg, DrawnPoints> drawing;
  double unit_m = 0.001;                             // metres per drawing unit
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  // drawing point that lies on the world origin
  Axis axis = Axis::y;
  bool first_passage_over = true;  // at the first crossing met from the start of the path
  std::optional<CrossingList> crossings = std::nullopt;  // none: over and under alternate
  double clearance_m = 0;  // free space between the bands at a crossing

  bool operator==(const CurveScene&) const = default;
};

struct NamedKnot {
  std::string name;        // "reef knot"
  std::string place = {};  // where the scene says it; empty: nowhere

  // Wherever it stands.
  bool operator==(const NamedKnot& other) const { return name == other.name; }
};

// What the drawing is meant to tie.
struct KnotScene {
  NamedKnot expect;
  std::optional<BandPart> between = std::nullopt;          // whose knot is certified by itself,
  std::optional<NamedKnot> expect_between = std::nullopt;  // and what that is meant to be

  bool operator==(const KnotScene&) const = default;
};

// A closed path whose long axis is the ribbon.
struct OutlineScene {
  NamedFile file;
  std::string path_id;  // id of the path to use; empty: the only one

  bool operator==(const OutlineScene&) const = default;
};

struct RibbonScene {
  double width_m = 0;                                  // mean of all rows
  std::optional<WidthProfile> profile = std::nullopt;  // none: all rows are as wide
  // Instead of a width, which is 0 until with_outline_read() has read it off.
  std::optional<OutlineScene> outline = std::nullopt;
  int along = 0;
  int across = 0;
  double mass_kg = 1;
  double thickness_m = 0;  // at which contact begins; 0: as soon as the mesh needs it

  bool operator==(const RibbonScene&) const = default;
};

// Spring resistances of the paper's section 5.1, in N/m. A resistance of 0 creates no springs.
struct SpringScene {
  double stretch = 0;  // k1
  double shear = 0;    // k2
  double bend = 0;     // k3
  // Internal, of each spring: a fraction of what would just keep two particles on it from swinging.
  // The paper has none.
  double damping = 0.5;

  bool operator==(const SpringScene&) const = default;
};

// Cloth by name: what the fabric tells instead of the scene, which is why the scene's own members
// do not count. They are known when the size of the mesh is (with_fabric()).
struct ClothScene {
  Fabric fabric;
  std::string place = {};  // where the scene says it; empty: nowhere
  bool tells_thickness = false;
  bool tells_mass = false;
  bool tells_stretch = false;
  bool tells_shear = false;
  bool tells_bend = false;

  // Wherever it stands.
  bool operator==(const ClothScene& other) const {
    return fabric == other.fabric && tells_thickness == other.tells_thickness &&
           tells_mass == other.tells_mass && tells_stretch == other.tells_stretch &&
           tells_shear == other.tells_shear && tells_bend == other.tells_bend;
  }
};

struct ObstacleScene {
  NamedFile file;
  double scale = 1;  // metres per unit of the mesh file
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();

  bool operator==(const ObstacleScene&) const = default;
};

// How contact is dealt with: `gate` keeps every pair of features apart; `paper` is the published
// method with its recovery schemes A, B and C.
enum class ContactMethod { gate, paper };

// Where the ribbon is pulled: everywhere as in the paper, or at its two ends alone.
enum class FasteningPull { distributed, ends };

// The pre-step fastening force of the paper's section 5.2, and the feedback of 3.3: hands feel how
// the ribbon resists.
struct FasteningScene {
  double speed_m_s = 0;  // distributed: at which the force alone would carry a free particle that
                         // is at mean distance from the axis; ends: at which each end would draw a
                         // free half of the ribbon; both against the air resistance
  FasteningPull pull = FasteningPull::distributed;
  std::optional<double> max_speed_m_s =
      std::nullopt;            // to which the force accelerates particles at most; none: to any
  double yield_strain = 0.05;  // stretch along at which the hands give way; or `unyielding`
  Eigen::Vector3d axis_point_m = Eigen::Vector3d::Zero();     // a point on the centre axis
  Eigen::Vector3d axis_direction = Eigen::Vector3d::UnitY();  // unit length

  bool operator==(const FasteningScene&) const = default;
};

// What ends a run: its duration alone, or a knot that is tight before.
enum class RunsUntil { duration, tight };

struct TimeScene {
  double step_s = 0.01;   // divides the time between two frames, in scenes that were read
  double duration_s = 0;  // at most
  RunsUntil until = RunsUntil::duration;
  std::optional<IntegrationMethod> integrator =
      std::nullopt;  // none: the usual one, or the implicit one where springs are too stiff for it
  IntegrationMethod usual_integrator = IntegrationMethod::symplectic_euler;  // of the accuracy
  double tolerance = 0.1;  // of IntegrationMethod::implicit, of the change of the velocities

  bool operator==(const TimeScene&) const = default;
};

// How edges are kept near their rest length where contact is in the way.
struct StrainCorrectionScene {
  double strain = 0.08;  // that is aimed at, of the rest length
  int most_rounds = 20;  // of sweeps, each followed by the gate
  int most_sweeps = 60;  // over all contacts and edges, in each of them

  bool operator==(const StrainCorrectionScene&) const = default;
};

// The least max_position_error that a scene may name, but for 0, and the most.
inline constexpr double least_position_error = 1e-7;
inline constexpr double most_position_error = 0.01;

struct RecordingScene {
  double frames_per_second = 50;
  std::optional<double> max_position_error =
      std::nullopt;  // of the ribbon's length, per coordinate; 0: positions are recorded in single
                     // precision as they are; none: what suits the ribbon's edges
  double checkpoint_every_s = 200;  // simulated time; 0: none but at the start and the end

  bool operator==(const RecordingScene&) const = default;
};

struct Scene {
  std::string name;
  std::filesystem::path file;  // where it stands
  std::string text;            // the file as read
  CurveScene curve;
  std::optional<KnotScene> knot;
  RibbonScene ribbon;
  std::optional<ClothScene> cloth;
  SpringScene springs;
  double air_resistance_per_s = 0;  // deceleration per speed
  // Not zero: a scene without gravity has none.
  std::optional<Eigen::Vector3d> gravity_m_s2 = std::nullopt;
  double friction = 0;  // Coulomb's coefficient, of ribbon on ribbon and on obstacle
  ContactMethod contact = ContactMethod::gate;
  std::optional<ObstacleScene> obstacle;
  std::optional<FasteningScene> fastening;
  std::vector<StageScene> stages;  // none: the ribbon is fastened as a whole
  TimeScene time;
  StrainCorrectionScene strain_correction;
  RecordingScene recording;

  bool operator==(const Scene&) const = default;
};

// The scene's own file and those that it names.
std::vector<std::filesystem::path> files_of(const Scene& scene);

// Reads and checks a scene file in which settings have been changed, one after the other
// (with_setting()). Relative file names in it are taken from its own folder. Fails with file, line
// and column, or the setting that spoils it, when a key is unknown, has the wrong type or an
// impossible value.
Result<Scene> read_scene(const std::filesystem::path& file,
                         const std::vector<std::string>& settings = {});

// Likewise, of the text of a scene; `file` says where it stands and in which folder to look. Where
// the text does not name the scene, it is called `name` or, where that is empty, after the file.
Result<Scene> read_scene(const std::filesystem::path& file, std::string text,
                         const std::vector<std::string>& settings = {},
                         const std::string& name = "");

}  // namespace ribbon
