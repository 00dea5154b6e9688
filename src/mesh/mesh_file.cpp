#include "mesh/mesh_file.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <utility>

#include "base/require.h"
#include "base/words.h"
#include "mesh/diagnosis.h"
#include "mesh/formats.h"
#include "mesh/topology.h"
#include "mesh/welding.h"
#include "system/bytes.h"
#include "system/file.h"
#include "system/file_kind.h"

namespace twrench::mesh {
namespace {

constexpr std::string_view glb_mark = "glTF";
constexpr std::string_view zip_mark = "PK\3\4";
constexpr std::size_t most_bytes = std::size_t{1} << 30U;

struct Format {
  const char* ending;
  Content (*read)(const Source&);
};

constexpr std::array formats{Format{".obj", read_obj},  Format{".stl", read_stl},
                             Format{".ply", read_ply},  Format{".gltf", read_gltf},
                             Format{".glb", read_gltf}, Format{".dae", read_collada},
                             Format{".3mf", read_3mf}};

struct Unit {
  const char* name;
  double length;  ///< cm
};

constexpr std::array units{Unit{"mm", 0.1}, Unit{"cm", 1.0}, Unit{"m", 100.0}, Unit{"inch", 2.54},
                           Unit{"km", 1e5}};

/// Returns the extension of the name in lower case.
std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

const Format* format_of(const std::filesystem::path& file) {
  const auto* found = std::ranges::find(formats, ending_of(file), &Format::ending);
  return found == formats.end() ? nullptr : found;
}

bool is_collada(const Source& source) {
  const Format* format = format_of(source.name);
  return format && format->read == read_collada && source.bytes.starts_with('<');
}

Content read_content(Source source) {
  const std::string what = "cannot read " + source.name;
  if (source.bytes.size() > most_bytes) {
    throw system::FileError(what, fmt::format("it is longer than {} bytes", most_bytes));
  }
  // The header of a binary STL may contain any bytes.
  if (!is_binary_stl(source.bytes)) {
    source.bytes = system::without_byte_order_mark(source.bytes);
    const auto kind = system::recognized_file_kind(source.bytes);
    if (kind && !source.bytes.starts_with(glb_mark) && !source.bytes.starts_with(zip_mark) &&
        !is_collada(source)) {
      throw system::FileError(what, fmt::format("it is {}", *kind),
                              "save it in OBJ, STL, PLY, glTF, COLLADA or 3MF, with text in UTF-8");
    }
  }
  // Three formats are identified by their first bytes, whatever the name.
  if (source.bytes.starts_with(glb_mark)) return read_gltf(source);
  if (source.bytes.starts_with(zip_mark)) return read_3mf(source);
  if (source.bytes.starts_with("ply\n") || source.bytes.starts_with("ply\r"))
    return read_ply(source);
  if (const Format* format = format_of(source.name)) return format->read(source);
  throw InvalidArgument(
      source.name, "its extension is not that of a mesh file",
      "use a file in OBJ, STL, PLY, glTF, COLLADA or 3MF: .obj .stl .ply .gltf .glb .dae .3mf");
}

double scale_of(const std::string& name, const Content& content, const ReadOptions& options) {
  if (options.scale) return *options.scale * options.factor;
  if (content.scale) return *content.scale * options.factor;
  if (options.default_scale) return *options.default_scale * options.factor;
  throw MeshError(MeshError::Reason::no_scale, name, "its unit is not known: the format has none",
                  "say unit = \"mm\", \"cm\", \"m\", \"inch\" or \"km\", or scale = CM_PER_UNIT");
}

void check(const ReadOptions& options) {
  if (options.scale) require_positive("scale", *options.scale);
  require_positive("factor", options.factor);
  if (options.weld != 0.0) require_positive("weld", options.weld);
  if (options.shell != 0.0) require_positive("shell", options.shell);
}

/// Converts integrals in the file's unit to cm and grams.
body::SolidIntegrals scaled(const std::string& name, const body::SolidIntegrals& integrals,
                            double scale) {
  const double cube = scale * scale * scale;
  const body::SolidIntegrals result{integrals.volume * cube, integrals.centroid * scale,
                                    integrals.inertia * (cube * scale * scale)};
  const bool is_finite =
      std::isfinite(result.volume) && result.centroid.allFinite() && result.inertia.allFinite();
  if (is_finite && result.inertia.trace() > 0.0) return result;
  throw InvalidArgument(name, "its inertia in g cm^2 exceeds the range of a double",
                        "check its unit");
}

/// Returns the integrals of a solid or a wall. Errors name the file.
body::SolidIntegrals integrals_of(const std::string& name, const body::TriangleMesh& mesh,
                                  double shell) try {
  return shell == 0.0 ? body::solid_integrals(mesh) : body::shell_integrals(mesh, shell);
} catch (const InvalidArgument& error) {
  const std::string_view why = error.what();
  throw InvalidArgument(name, std::string(why.substr(error.quantity().size() + 2)), error.remedy());
}

void add_notes_of(const Welded& welded, double tolerance, std::vector<std::string>& notes) {
  if (welded.joined_vertices > 0) {
    notes.push_back(fmt::format("{} vertices were joined to others within {} cm",
                                welded.joined_vertices, tolerance));
  }
  if (welded.removed_triangles > 0) {
    notes.push_back(
        fmt::format("{} triangles have no area, two of their corners being one point, "
                    "and are left out",
                    welded.removed_triangles));
  }
}

/// Joins vertices. Throws OutOfRange if the tolerance is not small compared with the mesh.
Welded weld_within(body::TriangleMesh& mesh, double tolerance, double scale) {
  Welded welded = weld(mesh, 0.0);
  if (tolerance == 0.0) return welded;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  const double most = 0.01 * scale * box.diagonal().norm();
  if (tolerance > most) {
    throw OutOfRange("weld",
                     fmt::format("is {} cm, but may be at most {:.3g}, a hundredth of the size of "
                                 "the mesh",
                                 tolerance, most),
                     {tolerance, 0.0, most});
  }
  const std::size_t removed = welded.removed_triangles;
  welded = weld(mesh, tolerance / scale);
  welded.removed_triangles += removed;
  return welded;
}

/// Checks the content of a file and converts it to a body in cm.
MeshFile finish(const std::string& name, Content content, const ReadOptions& options) {
  const double scale = scale_of(name, content, options);
  body::TriangleMesh& mesh = content.mesh;
  MeshFile file;
  file.notes = std::move(content.notes);
  for (OtherFile& other : content.others) file.others.push_back(std::move(other.path));
  add_notes_of(weld_within(mesh, options.weld, scale), options.weld, file.notes);
  if (mesh.triangles.empty()) throw InvalidArgument(name, "it has no triangles");
  const Topology edges = topology(mesh);
  file.open_edges = edges.unbalanced;
  file.components = edges.components;
  if (options.shell == 0.0) {
    require_solid(name, mesh, edges, scale, options.search, file.notes);
  }
  const body::SolidIntegrals integrals = integrals_of(name, mesh, options.shell / scale);
  file.area = body::surface_area(mesh) * scale * scale;
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex *= scale;
  file.shape = {std::make_shared<const body::TriangleMesh>(std::move(mesh)), options.shell,
                scaled(name, integrals, scale)};
  return file;
}

/// Returns the digest of a file or, if others belong to it, the digest of all their digests.
std::string digest_of(std::string_view bytes, const std::vector<OtherFile>& others) {
  const auto digest = [](std::string_view text) {
    return system::sha256_hex(
        std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  };
  std::string all = digest(bytes);
  if (others.empty()) return all;
  for (const OtherFile& other : others) all += other.sha256;
  return digest(all);
}

MeshFile read(const std::string& name, Content content, std::string digest,
              const ReadOptions& options) {
  MeshFile file = finish(name, std::move(content), options);
  file.sha256 = std::move(digest);
  return file;
}

/// Throws unless coordinates are finite and indices are in range, as they are after reading a file.
void require_content(const std::string& name, const body::TriangleMesh& mesh) {
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    if (!vertex.allFinite()) throw InvalidArgument(name, "a coordinate is not finite");
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner < mesh.vertices.size()) continue;
      throw InvalidArgument(name, fmt::format("a triangle has the vertex {}, but there are {}",
                                              corner, mesh.vertices.size()));
    }
  }
}

}  // namespace

InvalidArgument MeshError::with_remedy(const std::string& remedy) const {
  const std::string_view message = what();
  const std::size_t named = quantity().size() + std::string_view(": ").size();
  return {quantity(), std::string(message.substr(named)), remedy};
}

bool is_mesh_name(const std::filesystem::path& file) { return format_of(file) != nullptr; }

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  for (const Unit& unit : units) names.emplace_back(unit.name);
  return names;
}

double unit_length(const std::string& what, std::string_view unit) {
  const auto* found = std::ranges::find(units, unit, &Unit::name);
  if (found == units.end()) throw unknown_name(what, unit, unit_names());
  return found->length;
}

MeshFile read_mesh(const std::filesystem::path& file, const ReadOptions& options) {
  check(options);
  Content content;
  std::string digest;
  {
    const std::vector<std::uint8_t> bytes = system::read_regular_file(file, most_bytes);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    content = read_content({file.string(), text, file.parent_path()});
    digest = digest_of(text, content.others);
  }  // Frees the bytes, because the checks need the memory.
  return read(file.string(), std::move(content), std::move(digest), options);
}

MeshFile checked_mesh(const std::string& name, body::TriangleMesh mesh,
                      const ReadOptions& options) {
  check(options);
  require_content(name, mesh);
  Content content;
  content.mesh = std::move(mesh);
  content.scale = 1.0;
  return finish(name, std::move(content), options);
}

MeshFile read_mesh(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  check(options);
  Content content = read_content({name, bytes, {}});
  std::string digest = digest_of(bytes, content.others);
  return read(name, std::move(content), std::move(digest), options);
}

}  // namespace twrench::mesh
