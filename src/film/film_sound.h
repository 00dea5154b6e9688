#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "system/child_process.h"
#include "video/codec.h"
#include "video/sound_track.h"

namespace twrench::film {

/// Returns whether the film has a sound file, narration, or the sound of its motion.
bool has_sound(const scene::Scene& film);

/// Throws InvalidArgument if the film has a sound file or the sound of its motion and the container
/// has no sound.
void require_sound_container(const scene::Scene& film, video::Container container);

/// Returns a warning for each narration that is longer than its shot. Throws InvalidArgument if one
/// would end after the film, and as video::sound_length() does.
std::vector<std::string> check_narration(const scene::Scene& film);

/// Returns the encoded sound of the frames of a film; null if it has none, or an animated image
/// would only have narration. Throws InvalidArgument if the frames are not consecutive, and as
/// video::SoundTrack and sound::MotionTrack do.
std::shared_ptr<const video::SoundTrack> sound_track(const scene::Scene& film,
                                                     const std::vector<int>& frames,
                                                     video::Container container,
                                                     system::Patience patience);

}  // namespace twrench::film
