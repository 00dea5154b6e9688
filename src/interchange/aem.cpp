#include "interchange/aem.h"

#include <fmt/format.h>
#include <twrench/motion/propagator.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "motion/reference_motion.h"
#include "scene/shown_recording.h"

namespace twrench::interchange {
namespace {

/// The number of decimals of the times: 9 for nanoseconds, or as many as resolve a thousandth of
/// the mean interval between rows. An epoch can have up to 18.
int decimals(double duration, std::size_t count) {
  constexpr int least = 9, most = 18;
  if (count < 2) return least;
  const double interval = duration / static_cast<double>(count - 1);
  return static_cast<int>(
      std::clamp(3 - std::floor(std::log10(interval)), double{least}, double{most}));
}

/// Replaces the characters of a name that a message does not allow.
std::string in_ascii(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c < ' ' || c > '~'; }, '_');
  return name;
}

// Comments are allowed only at the start of the header, of the metadata and of the data. The
// creation date is obligatory, but the real one would give the same motion different bytes each
// time.
constexpr const char* head =
    "CCSDS_AEM_VERS = 1.0\n"
    "COMMENT Written by {generator}: {source}.\n"
    "COMMENT CREATION_DATE is the epoch of the motion, so that the same motion gives the same "
    "file.\n"
    "CREATION_DATE = {start}\n"
    "ORIGINATOR = TWRENCH\n"
    "\n"
    "META_START\n"
    "COMMENT REF_FRAME_A is the inertial frame {frame}. The\n"
    "COMMENT motion does not depend on where these point in the sky: EME2000 is one choice of "
    "many.\n"
    "COMMENT A quaternion turns the axes of REF_FRAME_A into those of REF_FRAME_B: with the unit "
    "axis e\n"
    "COMMENT and the angle a of that rotation, Q1 Q2 Q3 = e sin(a/2), QC = cos(a/2). The "
    "components of a\n"
    "COMMENT vector v in the two frames are related by v_A = q v_B q*.\n"
    "COMMENT Each row is Q1 Q2 Q3 QC: the scalar is last.\n"
    "COMMENT Consecutive quaternions have a positive dot product, so that they may be "
    "interpolated.\n"
    "OBJECT_NAME = {name}\n"
    "OBJECT_ID = {name}\n"
    "REF_FRAME_A = EME2000\n"
    "REF_FRAME_B = SC_BODY_1\n"
    "ATTITUDE_DIR = A2B\n"
    "TIME_SYSTEM = TAI\n"
    "START_TIME = {start}\n"
    "STOP_TIME = {stop}\n"
    "ATTITUDE_TYPE = QUATERNION\n"
    "QUATERNION_TYPE = LAST\n"
    "META_STOP\n"
    "\n"
    "DATA_START\n";

/// The motion that a message describes.
struct Source {
  std::string what, frame;
  std::function<Eigen::Matrix3d(double t)> attitude;
};

Source source_of(const scene::Scene& scene) {
  if (const auto& recording = scene.motion.recording) {
    return {"the rotation recorded in " +
                in_ascii(std::filesystem::path(recording->file).filename().string()),
            "to which the recorded attitudes refer",
            [recording](double t) { return recording->motion.at(t).X; }};
  }
  const motion::FreeBody body = scene::free_body(scene);
  const motion::Method& method = motion::reference_method(body);
  const std::shared_ptr<motion::Propagator> motion =
      motion::make_propagator(body, method, motion::reference_control(scene.motion.control.stop));
  return {
      body.is_rigid()
          ? "the free rotation of a rigid body, in closed form"
          : fmt::format("the free rotation of a body with a wheel or energy loss, by the method {}",
                        method.name),
      "whose axes are those of the body at START_TIME",
      [motion](double t) { return motion->sample_at(t).X; }};
}

}  // namespace

void write_aem(const scene::Scene& scene, Epoch epoch, const std::string& generator,
               std::size_t count, const std::function<double(std::size_t)>& time,
               const std::function<void(std::string_view)>& write) {
  const Source source = source_of(scene);
  const double end = time(count - 1);
  const int digits = decimals(end - time(0), count);
  const double in_a_second = std::pow(10.0, digits);
  const auto ticks = [&](double t) { return std::llround(in_a_second * t); };
  write(fmt::format(fmt::runtime(head), fmt::arg("generator", generator),
                    fmt::arg("source", source.what), fmt::arg("frame", source.frame),
                    fmt::arg("name", in_ascii(scene.name)),
                    fmt::arg("start", format_epoch(epoch, ticks(time(0)), digits)),
                    fmt::arg("stop", format_epoch(epoch, ticks(end), digits))));
  Eigen::Quaterniond last = Eigen::Quaterniond::Identity();
  std::int64_t written = -1;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t instant = ticks(time(i));
    if (instant == written) continue;
    written = instant;
    Eigen::Quaterniond q(source.attitude(static_cast<double>(instant) / in_a_second));
    if (q.dot(last) < 0) q.coeffs() = -q.coeffs();
    last = q;
    write(fmt::format("{} {:.15f} {:.15f} {:.15f} {:.15f}\n", format_epoch(epoch, instant, digits),
                      q.x(), q.y(), q.z(), q.w()));
  }
  write("DATA_STOP\n");
}

}  // namespace twrench::interchange
