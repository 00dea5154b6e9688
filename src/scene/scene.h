#pragma once

#include <twrench/body/mass_properties.h>
#include <twrench/body/shape.h>
#include <twrench/motion/trajectory.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/color.h"
#include "scene/speed_curve.h"
#include "system/error.h"

namespace twrench::scene {

struct RecordingFile;
struct ShownRecording;

/// How a part looks. Unset values are those of the scene's look.
struct PartLook {
  /// Colour of the part; vertex colours of a mesh take precedence.
  std::optional<Color> color;
  /// Metalness, 0 (paint) to 1 (metal).
  std::optional<double> metallic;
  /// Roughness, 0.05 (mirror) to 1 (chalk).
  std::optional<double> roughness;
  /// For a mesh, the largest angle in rad between adjacent triangles that are drawn as one smooth
  /// surface; 0 draws flat facets.
  double crease_angle = 35.0 / 180.0 * std::numbers::pi;
};

/// The file of a part that is a mesh.
struct MeshSource {
  /// The file as it was given, or the name of a built-in mesh.
  std::string file;
  /// The path from which it was read; empty for a built-in mesh.
  std::filesystem::path path;
  /// The other files of which it consists: the buffers of a glTF file that are not in it.
  std::vector<std::filesystem::path> others = {};
  /// Centimetres per unit of the file; nothing if its format determines it.
  std::optional<double> scale;
  /// Distance in cm within which vertices are joined; 0 joins only those that coincide.
  double weld = 0.0;
  /// SHA-256 of the file's bytes, in hexadecimal digits.
  std::string sha256;
};

/// The description of a part, except its shape, mass and placement.
struct PartDescription {
  /// Its name; may be empty.
  std::string name;
  /// Its look.
  PartLook look;
  /// Its file, for a mesh that was read from one.
  std::optional<MeshSource> mesh;
  /// Notes on repairs to its mesh and on omitted data, one line each.
  std::vector<std::string> notes = {};
};

/// The solid that is drawn for a body given by its inertia alone. It has that inertia, so it lies
/// along the principal axes.
enum class Equimomental {
  box,        ///< A homogeneous box.
  ellipsoid,  ///< A homogeneous ellipsoid.
  cross,      ///< A cross with two heavy and two light discs.
};

/// The body, given by its parts, by its inertia alone, or by its inertia with parts that are only
/// drawn.
struct Body {
  /// The parts. If `inertia` is set, they are drawn about the centre of mass, which is the origin
  /// then, and their densities state only the mass.
  std::vector<body::Part> parts;
  /// Inertia matrix about the centre of mass in body axes, in g cm^2; symmetric. A diagonal one is
  /// given and written as three principal moments.
  std::optional<Eigen::Matrix3d> inertia;
  /// The descriptions of the parts, in order; there may be fewer than parts. See description().
  std::vector<PartDescription> descriptions = {};
  /// The solid that is drawn if `inertia` is set, and there are no parts.
  Equimomental drawn_as = Equimomental::box;
};

/// The initial condition and how the motion is computed.
struct Motion {
  /// Angular velocity at t = 0 in body axes, in rad/s.
  Eigen::Vector3d omega{1.0, 0.05, 0.0};
  /// X(0), space_from_body, of unit length; nothing for the identity, as in the specification.
  std::optional<Eigen::Quaterniond> attitude;
  /// Angular momentum of a wheel relative to the body, in body axes, in g cm^2/s; nothing for none.
  std::optional<Eigen::Vector3d> wheel;
  /// Time constant of the energy loss in s, as in motion::Interior; nothing if no energy is lost.
  std::optional<double> energy_loss_time;
  /// Name of the integration method.
  std::string method = "rkmk45";
  /// Step size and tolerance.
  motion::StepControl control;
  /// Duration of the motion in s.
  double duration = 96.0;
  /// The file of the recorded motion that the scene file names; null for none. It is not read
  /// before the motion is shown.
  std::shared_ptr<const RecordingFile> recording_file = nullptr;
  /// The recorded motion that is shown instead of a computed one; null for none. The members above
  /// then describe a free motion to compare it with.
  std::shared_ptr<const ShownRecording> recording = nullptr;

  /// Returns whether nothing moves within the body.
  bool is_rigid() const { return !wheel && !energy_loss_time; }
};

/// A sound file.
struct SoundFile {
  /// The file as it was given; empty for none.
  std::string file;
  /// The path from which it is read.
  std::filesystem::path path;

  bool is_given() const { return !file.empty(); }
};

/// Sound that is synthesised.
enum class Sound {
  none,    ///< None.
  motion,  ///< That of the motion: a whoosh that follows the speed, and an accent at each flip.
};

/// The frames of the video, and its sound.
struct Film {
  /// Size in pixels.
  int width = 1920, height = 1080;
  /// Frames per second of video.
  double fps = 60.0;
  /// Seconds of motion per second of video.
  double speed = 6.0;
  /// The sound file under the video.
  SoundFile audio = {};
  /// The sound that is synthesised.
  Sound sound = Sound::none;
  /// Seconds of video before the end of a shot in which its text fades out; nothing if it stays.
  std::optional<double> text_fade = {};

  /// Returns the time of the motion in s for a frame: frame * speed / fps, never accumulated.
  double time_of(int frame) const { return frame * speed / fps; }
};

/// A language of the words in the picture, by its ISO 639-1 code: English or Norwegian (bokmål).
enum class Language { en, nb };

/// The finish of the picture: material, lights, background and overlay colours.
enum class Theme { studio, paper, space };

/// The look of the picture. Unset values are the theme's.
struct Look {
  /// The theme.
  Theme theme = Theme::studio;
  /// MSAA samples per pixel; 1 = analytic edge antialiasing.
  int samples = 1;
  /// Poses averaged per frame, or more if the speed needs them; 1 = no motion blur.
  int motion_blur = 1;
  /// Whether the background is transparent; alpha is then the coverage of the drawing.
  bool transparent = false;
  /// A flat background colour.
  std::optional<Color> background;
  /// Colour of the body.
  std::optional<Color> color;
  /// Metalness of the body, 0 (paint) to 1 (metal).
  std::optional<double> metallic;
  /// Surface roughness of the body, 0.05 (mirror) to 1 (chalk).
  std::optional<double> roughness;
};

/// The frame of reference in which the camera stands. It coincides with space at t = 0.
enum class Frame {
  space,     ///< An inertial frame.
  body,      ///< Fixed in the body, so that the body is at rest.
  rotating,  ///< Turns about L as the body would in a steady rotation: see motion::steady_frame.
};

/// A camera that looks at the centre of mass.
struct CameraPath {
  /// Azimuth from the space z axis towards x, in rad.
  double azimuth = 0.0;
  /// Elevation above the xz plane, in rad.
  double elevation = 0.245;
  /// Distance, in units of the distance at which the body just fits its pane in every pose.
  double distance = 1.0;
  /// Angular speed about the space y axis in rad per second of video.
  double orbit = 0.0;
  /// Field of view along the shorter side of the picture, in rad.
  double field_of_view = 0.55;
  /// The frame in which the camera stands and forces are shown.
  Frame frame = Frame::space;
};

/// An element of the picture besides the body.
enum class Feature {
  floor,       ///< The floor with the body's shadow and reflection.
  shadow,      ///< The body's shadow alone, on a floor that is not seen.
  axes,        ///< The body's axes.
  momentum,    ///< The angular momentum L as an arrow.
  omega,       ///< The angular velocity as an arrow.
  trail,       ///< The trail of a point of the body, of the momentum, or of omega.
  plane,       ///< The invariable plane.
  labels,      ///< The names of arrows and axes.
  hud,         ///< Title, time, flips, and a remark on the motion.
  components,  ///< The nine components of X against time.
  sphere,      ///< The momentum sphere as an inset.
  poinsot,     ///< Poinsot's construction as an inset.
  phase,       ///< The area on the momentum sphere that is the geometric phase.
  curve,       ///< A large plot of one component of X, x11: the direction of the leg.
  method,      ///< The method, below the title.
  drift,       ///< The energy drift, beside the time.
  forces,      ///< The forces on the parts in the camera's frame, as arrows.
  torques,     ///< The torques of these forces that tilt the body further, and back.
  tip,         ///< The tip of the axis of the rotation, its path, and the forces on it.
  tilt,        ///< The tilt against L on a log scale, instead of the components.
  moments,     ///< The principal moments as bars.
  inertia,     ///< The homogeneous ellipsoid that has the body's mass and inertia.
};

/// A force by which an observer in a frame of reference explains the motion.
enum class Force {
  centrifugal,  ///< Away from the axis about which the frame turns.
  coriolis,     ///< On what moves in a frame that turns.
  euler,        ///< In a frame that turns at a changing rate.
  constraint,   ///< What holds a part at its place in the body.
  sum,          ///< The sum of the forces on the tip of an axis.
};

/// The main content of the picture: the body, the momentum sphere, Poinsot's construction, or all
/// three with the components.
enum class View { wrench, momentum, poinsot, quad };

/// A view without the body, and the feature that shows this view as an inset beside the body.
struct Inset {
  View view;
  Feature feature;
};

/// The insets in the order in which they are placed. If there is no room for all, the last is left
/// out first.
inline constexpr std::array insets{Inset{View::momentum, Feature::sphere},
                                   Inset{View::poinsot, Feature::poinsot}};

/// Returns the index of a view in `insets`, or their number if the view shows the body.
constexpr std::size_t inset_index(View view) {
  const auto found = std::ranges::find(insets, view, &Inset::view);
  return static_cast<std::size_t>(found - insets.begin());
}

/// The view and its overlays.
struct Overlay {
  /// The view.
  View view = View::wrench;
  /// The features to show.
  std::set<Feature> show{Feature::floor,  Feature::momentum, Feature::omega,  Feature::trail,
                         Feature::labels, Feature::hud,      Feature::sphere, Feature::curve};
  /// The features to stress, by dimming everything else; empty stresses nothing.
  std::set<Feature> stress;
  /// The forces that Feature::forces and Feature::tip draw, if their frame has them.
  std::set<Force> forces{Force::centrifugal, Force::coriolis, Force::euler, Force::constraint,
                         Force::sum};
  /// Names of the methods shown side by side; empty shows only Motion::method.
  std::vector<std::string> compare;
  /// Initial angular velocities in body axes, in rad/s, of the motions shown side by side; empty
  /// shows only Motion::omega.
  std::vector<Eigen::Vector3d> compare_omega;
  /// Angular momenta of the wheels in body axes, in g cm^2/s, of the motions shown side by side;
  /// empty shows only Motion::wheel.
  std::vector<Eigen::Vector3d> compare_wheel;
  /// The point of the body that draws the trail, in the axes of the parts, in cm; by default see
  /// trail_point().
  std::optional<Eigen::Vector3d> trail_point;
  /// Length of the trail in s of motion; by default the time of a 12 rad rotation.
  std::optional<double> trail_length;
  /// Seconds of video that the streaks of stars cover in a camera that turns; by default the time
  /// for which the shutter is open, half of the frame interval.
  std::optional<double> star_trail;
  /// Name of a built-in font, or a font file.
  std::string font = "sans";

  /// Returns whether a feature is shown.
  bool shows(Feature feature) const { return show.contains(feature); }
  /// Returns how many motions are shown side by side, at least 1.
  std::size_t motion_count() const;
};

/// The name of the transparent background.
inline constexpr const char* transparent_name = "transparent";

/// Sets the background to transparent_name or a colour. Throws InvalidArgument about `what`.
void set_background(Look& look, const std::string& text, const std::string& what);

/// The origin of a value that otherwise follows from the motion or the body.
enum class Origin {
  none,   ///< Not given: the value is natural.
  scene,  ///< Given by the scene for its own body.
  user,   ///< Given by the user: it stays when the body is replaced.
};

/// The origins of the values that have natural ones.
struct Origins {
  Origin title = Origin::none, step = Origin::none, duration = Origin::none, fps = Origin::none,
         speed = Origin::none;
};

/// All members of Origins.
inline constexpr std::array all_origins{&Origins::title, &Origins::step, &Origins::duration,
                                        &Origins::fps, &Origins::speed};

struct Shot;

/// Everything that determines a video. A scene file or the command line overrides the defaults.
struct Scene {
  /// Name of the scene: letters, digits, '-' and '_'. Default names of outputs are derived from it.
  std::string name;
  /// Title shown in the picture; may be empty.
  std::string title;
  /// Tag (BCP 47) of the language of the words that the scene gives, such as captions.
  std::string language_tag = "en";
  /// Language of the other words in the picture.
  Language language = Language::en;
  /// The rigid body.
  Body body;
  /// Its motion.
  Motion motion;
  /// Frame size and rate.
  Film film;
  /// Theme, material and quality.
  Look look;
  /// Camera.
  CameraPath camera;
  /// View and overlays.
  Overlay overlay;
  /// Origins of the values that have natural defaults.
  Origins origins;
  /// The shots of a film that tells a story, in order. Size, frame rate and font are the same in
  /// all of them, and so is whether the background is transparent. Empty for a film of one motion.
  std::vector<Shot> shots;

  /// The caption of a shot. It is empty if only other shots of the film have captions; the space
  /// for it then stays free. Nothing in a film without captions.
  std::optional<std::string> caption;
  /// The length of a shot in s of video; nothing outside of shots.
  std::optional<double> length;

  /// Returns the title, or the name if there is none.
  const std::string& shown_title() const { return title.empty() ? name : title; }

  /// Returns the number of frames: round(duration * fps / speed), or that of all shots. Throws
  /// InvalidArgument unless it is 1 to 10^7.
  int frame_count() const;

  /// Returns the length of the video in s: of the shot, of all shots, or duration / speed.
  double video_length() const;
};

/// A shot: a part of a film with its own motion, camera and overlays.
struct Shot {
  /// The scene of the shot: the film's scene with the shot's own values, and without shots. The
  /// curves in the picture cover the duration of its motion.
  Scene scene;
  /// Seconds of video for which the previous shot fades into this one, at its start.
  double fade = 0.0;
  /// Seconds of video in which the camera moves from the previous shot's to this one's.
  double move = 0.0;
  /// Time of the motion at the start of the shot, in s.
  double start = 0.0;
  /// Whether it continues the motion of the previous shot from where that ended.
  bool continues = false;
  /// Seconds of motion per second of video, against the time since the start of the shot.
  SpeedCurve speed;
  /// The sound file that starts with the shot.
  SoundFile narration = {};
  /// Its location in the file, for messages: "FILE:LINE: shot[2]".
  std::string place;

  /// Returns the time of the motion in s that many seconds of video after the shot's start.
  double time_of(double seconds) const { return start + speed.integral(seconds); }
};

/// Returns the index of each shot's first frame, followed by the total number of frames. Shots
/// begin at whole frames.
std::vector<int> first_frames(const Scene& film);

/// Returns the mass properties of the scene's body. If it is given by its inertia, the centre of
/// mass is 0, and without parts the mass is NaN.
body::MassProperties mass_properties(const Body& body);

/// Returns the scene's body with the initial condition of its motion.
motion::FreeBody free_body(const Scene& scene);

/// Returns the bodies of the motions shown side by side that differ in their angular velocity or
/// their wheel; otherwise that of the scene's motion.
std::vector<motion::FreeBody> shown_bodies(const Scene& scene);

/// Returns an upper bound of |omega| in rad/s at all times t >= 0: the energy never increases, so
/// that |w| is at most sqrt(2 E / I1).
double fastest_rate(const motion::FreeBody& body);

/// Returns the parts to draw, relative to the centre of mass: the body's own, or equimomental ones.
std::vector<body::Part> visible_parts(const Body& body);

/// Returns parts that have the body's inertia, relative to the centre of mass: the visible ones, or
/// equimomental ones if those are only drawn.
std::vector<body::Part> massive_parts(const Body& body);

/// Returns the homogeneous ellipsoid with the body's mass and inertia; for an unknown mass, that of
/// density 1 g/cm^3.
body::Part equal_ellipsoid(const Body& body);

/// Returns the description of a visible part, with default values if the body has none for it.
PartDescription description(const Body& body, std::size_t part);

/// Parts of a body with the same name.
struct PartGroup {
  /// Their name; "part 3" for one without.
  std::string name;
  /// Their indices in massive_parts().
  std::vector<std::size_t> parts;
};

/// Returns the parts of a body by their names, in the order in which these first appear. `language`
/// is that of names that the body does not give.
std::vector<PartGroup> part_groups(const Body& body, Language language = Language::en);

/// Returns the notes on the meshes of a scene and its shots, each once and with the name of its
/// file.
std::vector<std::string> mesh_notes(const Scene& scene);

/// Returns the notes on the meshes of a body.
std::vector<std::string> mesh_notes(const Body& body);

/// Returns a warning about an inertia matrix in g cm^2 that no real body has; nothing about others.
/// A principal moment is at most the sum of the other two: Ixx + Iyy - Izz is twice the integral of
/// z^2 dm. The warning begins with `of`, the source of the matrix.
std::optional<std::string> unreal_moments_note(const std::string& of,
                                               const Eigen::Matrix3d& inertia);

/// Returns the files that a scene uses besides its own file: meshes, a font and sounds, including
/// those of its shots.
std::vector<std::filesystem::path> input_files(const Scene& scene);

/// Returns the names of the built-in scenes.
std::vector<std::string> builtin_scene_names();

/// Returns whether the text is a path instead of the name of a built-in scene: it has the extension
/// ".toml" or that of a mesh (in upper or lower case), contains a folder, or is an existing file
/// but no built-in name.
bool is_scene_file(const std::string& name_or_path);

/// Loads a scene from a scene file or a mesh, or a built-in one. A mesh has the unit of its file
/// and a density of 1 g/cm^3; see mesh_scene(). Throws InvalidArgument for an unknown name
/// (suggesting the nearest) or an invalid scene (with file, line and key), FileError if the file or
/// a mesh that it names cannot be read.
Scene load_scene(const std::string& name_or_path);

/// Parses a scene from TOML text; `source` names it in errors, and paths of meshes start from its
/// folder. Throws InvalidArgument, and FileError if a mesh cannot be read.
Scene parse_scene(std::string_view text, const std::string& source);

}  // namespace twrench::scene
