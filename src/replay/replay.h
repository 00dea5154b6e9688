#pragma once

#include "recording/conventions/convention.h"
#include "recording/motion_of_rows.h"
#include "recording/recording.h"
#include "scene/scene.h"

namespace twrench::replay {

/// Whether the body whose motion was recorded is that of the scene, or not known.
enum class Body { known, unknown };

/// Lets the scene show a recorded motion of its body: sets Motion::recording, the initial condition
/// of the free motion that fits it, and the title. With Overlay::compare, the recorded motion comes
/// first. The recording replaces Motion::recording_file, and the times that the author chose for
/// another motion no longer apply. Overlays that need a
/// free motion are left out, with a note, if the recording does not follow one. If the body is not
/// known, the scene gets a box and the name of the recording, and no free motion is fitted.
///
/// `given` is how the recording is to be read, as far as that is known. A recording without
/// attitudes starts in that of the scene. The comparison with the free motion is of the rows, even
/// if what is shown is smoother. Throws as check::choose_convention and
/// recording::motion_of_rows do, and InvalidArgument about the recording if the scene has shots or
/// shows motions that differ in their start.
void show_recording(scene::Scene& scene, const recording::Recording& recording,
                    const recording::Convention& given, Body body = Body::known,
                    recording::Smoothing smoothing = recording::Smoothing::none);

/// Lets the scene show Motion::recording_file. The title and the times of the scene stay, because
/// its author chose them for this recording. Throws as show_recording() and recording::Recording
/// do.
void show_own_recording(scene::Scene& scene);

}  // namespace twrench::replay
