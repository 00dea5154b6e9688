#pragma once

#include "picture/body/mesh.h"

namespace twrench::picture {

/// Darkens the vertices of parts that are given by triangles to the degree that the part itself
/// keeps light away from them: ambient occlusion (Zhukov, Iones and Kronin, "An Ambient Light
/// Illumination Model", 1998), with the light that bright walls of a hollow reflect once more
/// (Jimenez et al., "Practical Real-Time Strategies for Accurate Indirect Occlusion", 2016). Such
/// parts then have vertex colours. Only the outer faces of triangles keep light away, so vertices
/// that are inside the part are as bright as in the open.
void shade_hollows(Mesh& mesh);

}  // namespace twrench::picture
