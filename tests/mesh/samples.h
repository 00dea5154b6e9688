#pragma once

#include <twrench/body/triangle_mesh.h>

#include <bit>
#include <cstdint>
#include <string>

#include "mesh/obj.h"

namespace twrench::mesh {

/// The cube from 0 to 1 as six quadrilaterals.
inline std::string cube_obj() {
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
         "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

/// Appends a number, the least significant byte first.
template <typename Number>
void append(std::string& bytes, Number number) {
  std::array<char, sizeof(Number)> own = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (std::endian::native != std::endian::little) std::reverse(own.begin(), own.end());
  bytes.append(own.data(), own.size());
}

/// The triangles of an OBJ file as binary STL.
inline std::string binary_stl(const std::string& obj, std::string header = "made by a test") {
  const body::TriangleMesh mesh = read_obj({"input.obj", obj, {}}).mesh;
  header.resize(80, ' ');
  append(header, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(header, 0.0F);
    for (const std::uint32_t corner : triangle) {
      for (const double x : mesh.vertices[corner]) append(header, static_cast<float>(x));
    }
    append(header, std::uint16_t{0});
  }
  return header;
}

}  // namespace twrench::mesh
