#pragma once

#include <array>
#include <utility>

#include "motion.h"
#include "picture/views/body_view.h"
#include "picture/views/momentum_view.h"

namespace twrench::page {

/// The properties of a picture that the page chooses, in addition to the motion and the viewpoint.
struct Settings {
  double width = 1, height = 1;                  ///< Size of the pane in pixels.
  double thinnest = 1;                           ///< Width in pixels of the thinnest line.
  double theme = 0, frame = 0;                   ///< Indices of enumerators.
  double show = 0, stress = 0;                   ///< A bit for each feature.
  double azimuth = 0, elevation = 0;             ///< The home of the camera, rad.
  double distance = 1;                           ///< 1 is the one at which everything just fits.
  double field_of_view = 0.5;                    ///< That of the body's camera, rad.
  double interval = 0;                           ///< Seconds of motion in the time of one frame.
  double radius = 1;                             ///< Bounding radius of the body, cm.
  double trail_length = 1;                       ///< s
  double trail_x = 0, trail_y = 0, trail_z = 0;  ///< Trail point in body axes, cm.
  double curve_begin = 0, curve_end = 1;         ///< Times of the herpolhode that is drawn, s.

  bool operator==(const Settings&) const = default;
};

/// The settings by their names in JavaScript.
inline constexpr std::array<std::pair<const char*, double Settings::*>, 19> fields{
    {{"width", &Settings::width},
     {"height", &Settings::height},
     {"thinnest", &Settings::thinnest},
     {"theme", &Settings::theme},
     {"frame", &Settings::frame},
     {"show", &Settings::show},
     {"stress", &Settings::stress},
     {"azimuth", &Settings::azimuth},
     {"elevation", &Settings::elevation},
     {"distance", &Settings::distance},
     {"fieldOfView", &Settings::field_of_view},
     {"interval", &Settings::interval},
     {"radius", &Settings::radius},
     {"trailLength", &Settings::trail_length},
     {"trailX", &Settings::trail_x},
     {"trailY", &Settings::trail_y},
     {"trailZ", &Settings::trail_z},
     {"curveBegin", &Settings::curve_begin},
     {"curveEnd", &Settings::curve_end}}};

// The views. A view is kept until the motion or a setting changes.

picture::BodyView& body_view(const Motion& motion, const Settings& settings);
/// Returns the view of scene::insets[inset], framed for the azimuth and elevation in the settings.
picture::SolutionView& inset_view(const Motion& motion, const Settings& settings,
                                  std::size_t inset);
picture::MomentumView& sphere_view(const Motion& motion, const Settings& settings);

/// Returns the direction from which an inset shows a motion best.
picture::Viewpoint inset_home(const Motion& motion, const Settings& settings, std::size_t inset);

// The contents of the views. Each call replaces those of the previous call.

const picture::ViewContents& body_contents(const Motion& motion, const Settings& settings,
                                           const picture::Viewpoint& from,
                                           const timeline::FrameState& state);
/// The momentum sphere has a handle where the motion starts.
const picture::ViewContents& inset_contents(const Motion& motion, const Settings& settings,
                                            std::size_t inset, const picture::Viewpoint& from,
                                            const timeline::FrameState& state);

/// Returns where the motion starts on the sphere, in the picture's coordinates.
Eigen::Vector3d start_of(const Motion& motion, const picture::MomentumView& view);

}  // namespace twrench::page
