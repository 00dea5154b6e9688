#pragma once

#include "picture/body/mesh.h"

namespace twrench::picture {

/// Removes the vertices of a mesh of one part that do not visibly contribute to it, so that
/// triangles become as large as `tolerance` cm allows: small ones rasterise poorly, and silhouettes
/// of edges shorter than a pixel are ragged. A vertex is moved into one of its neighbours if the
/// new triangles pass it within the tolerance and with no visible change of normal and colour.
/// Deviations add up (Ciampalini, Cignoni, Montani and Scopigno, "Multiresolution Decimation Based
/// on Global Error", The Visual Computer 13 (1997)). Vertices at creases and at borders stay. The
/// order of triangles is preserved.
void decimate(Mesh& mesh, double tolerance);

}  // namespace twrench::picture
