#pragma once

#include "picture/body/mesh.h"

namespace twrench::picture {

/// Leaves out vertices of a mesh of one part that nobody would miss, so that triangles become as
/// large as `tolerance` cm allows: small ones rasterise poorly, and silhouettes of edges shorter
/// than a pixel are ragged. A vertex is moved into one of its neighbours if the new triangles pass
/// it within the tolerance, with the same normal, and colour, as far as one sees; deviations add up
/// (Ciampalini, Cignoni, Montani and Scopigno, "Multiresolution Decimation Based on Global Error",
/// The Visual Computer 13 (1997)). Vertices at creases and at borders stay. Keeps the order of
/// triangles.
void decimate(Mesh& mesh, double tolerance);

}  // namespace twrench::picture
