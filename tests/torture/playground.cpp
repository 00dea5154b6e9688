#include "playground.h"

#include <sys/stat.h>

#include <cerrno>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "program.h"

namespace twrench::torture {
namespace {

namespace fs = std::filesystem;

void put(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void put_fifo(const fs::path& path) {
  if (::mkfifo(path.c_str(), 0666) != 0) {
    throw std::system_error(errno, std::generic_category(), path.string());
  }
}

const std::string sound_scene = R"(title = "Sound"
[[part]]
shape = "box"
size = [1, 2, 3]
density = 2
[motion]
omega = [0.1, 2, 0.3]
duration = 2
[film]
size = [64, 48]
fps = 4
speed = 1
)";

std::string part(const std::string& keys) { return "[[part]]\nshape = \"cylinder\"\n" + keys; }

std::string mesh(const std::string& file, const std::string& keys) {
  return "[[part]]\nshape = \"mesh\"\nfile = \"" + file + "\"\ndensity = 2\n" + keys;
}

void put_meshes(const fs::path& folder) {
  const std::string open = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
  put(folder / "open.obj", open);
  put(folder / "sound.obj", open + "f 2 3 4\n");
  put(folder / "short.stl", std::string(80, 'x') + "\xff\xff\xff\xff");
}

/// A link in the form of a box, as URDF describes it.
std::string link(const std::string& name, const std::string& mass, const std::string& moments) {
  return "<link name=\"" + name + "\"><inertial><mass value=\"" + mass + "\"/><inertia " + moments +
         " ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>" +
         "<visual><geometry><box size=\"1 2 3\"/></geometry></visual></link>\n";
}

void put_robots(const fs::path& folder) {
  const auto robot = [](const std::string& links) {
    return "<robot name=\"r\">" + links + "</robot>";
  };
  const std::string moments = "ixx=\"13\" iyy=\"10\" izz=\"5\"";
  const std::string good = link("base", "12", moments);
  const std::string meshes =
      "<link name=\"tip\"><inertial><mass value=\"1\"/></inertial><visual><geometry>"
      "<mesh filename=\"sound.obj\"/></geometry></visual><collision><geometry>"
      "<mesh filename=\"package://nowhere/../zero.stl\"/></geometry></collision></link>";
  std::string many;
  for (int i = 0; i < 2000; ++i) many += link("l" + std::to_string(i), "12", "ixx=\"1\"");
  const std::vector<std::pair<std::string, std::string>> robots{
      {"robot.urdf", robot(good + link("hand", "1", "ixx=\"1\" iyy=\"1\" izz=\"9\""))},
      {"robot.sdf",
       "<sdf version=\"1.9\"><model name=\"m\"><link name=\"base\"><inertial><mass>2</mass>"
       "</inertial></link></model></sdf>"},
      {"robot.xml",
       "<mujoco><worldbody><body name=\"base\"><geom type=\"box\" size=\"1 2 3\"/></body>"
       "</worldbody></mujoco>"},
      {"meshes.urdf", robot(good + meshes)},
      {"numbers.urdf", robot(link("base", "1e308", moments) + link("nan", "nan", moments) +
                             link("tiny", "1e-320", "ixx=\"-0\" iyy=\"inf\" izz=\"1,5\""))},
      {"names.urdf", robot(link("\x1b[31m", "1", moments) + link("a&#10;b", "1", moments) + good +
                           good + link("", "1", moments))},
      {"many.urdf", robot(many)},
      {"cut.urdf", "<robot name=\"r\">" + good},
      {"macro.urdf", "<robot name=\"r\"><xacro:macro name=\"a\"/></robot>"}};
  for (const auto& [name, text] : robots) put(folder / name, text);
}

/// A glTF file whose nodes repeat a mesh with that many primitives.
std::string repeating_gltf(int nodes, int primitives, int mode) {
  const auto repeated = [](const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += (i == 0 ? "" : ",") + text;
    return all;
  };
  return R"({"asset":{"version":"2.0"},"nodes":[)" + repeated(R"({"mesh":0})", nodes) +
         R"(],"meshes":[{"primitives":[)" +
         repeated(R"({"attributes":{"POSITION":0},"mode":)" + std::to_string(mode) + "}",
                  primitives) +
         R"(]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,)"
         R"("uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

/// Thin tetrahedra all through a ball.
std::string needles(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double a = 2.4 * i, b = 3.9 * i, up = std::sin(1.7 * i);
    const double x = std::cos(a), y = std::sin(a);
    text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(up) + "\nv " +
            std::to_string(x + 1e-4) + " " + std::to_string(y) + " " + std::to_string(up) + "\nv " +
            std::to_string(x) + " " + std::to_string(y + 1e-4) + " " + std::to_string(up) + "\nv " +
            std::to_string(std::cos(b)) + " " + std::to_string(std::sin(b)) + " -2\n";
    text += "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n";
  }
  return text;
}

/// Creates small files that would take much time or memory.
void put_amplifiers(const fs::path& folder) {
  put(folder / "nodes.gltf", repeating_gltf(20000, 20000, 4));
  put(folder / "lines.gltf", repeating_gltf(20000, 20000, 1));
  put(folder / "needles.obj", needles(5000));
  for (const char* name : {"nodes.gltf", "lines.gltf", "needles.obj"}) {
    put(folder / (std::string(name) + ".toml"), mesh(name, "scale = 1\n"));
  }
  std::string sizes, shots;
  for (int i = 0; i < 1000; ++i) {
    sizes += mesh("needles.obj", "scale = " + std::to_string(1 + i) + "\n");
    shots += "[[shot]]\nlength = 1\n";
  }
  put(folder / "mesh_sizes.toml", sizes);
  std::string parts;
  for (int i = 0; i < 1000; ++i) parts += part("radius = 1\nlength = 2\ndensity = 3\n");
  put(folder / "parts_and_shots.toml", parts + shots);
}

void put_scenes(const fs::path& folder) {
  const std::string cylinder = "radius = 1\nlength = 2\ndensity = 3\n";
  const std::string solids =
      "[[part]]\nshape = \"cone\"\nradius = 1\nlength = 2\nmass = 3\nmaterial = \"wood\"\n"
      "[[part]]\nshape = \"torus\"\nradius = 2\ntube_radius = 0.5\ndensity = 3\n"
      "[[part]]\nshape = \"tube\"\nradius = 2\ninner_radius = 1\nlength = 1\ndensity = 3\n"
      "[[part]]\nshape = \"capsule\"\nradius = 1\nlength = 2\ndensity = 3\n";
  const std::vector<std::pair<std::string, std::string>> scenes{
      {"sound.toml", sound_scene},
      {"solids.toml", solids},
      {"mesh.toml", mesh("sound.obj", "unit = \"cm\"\n")},
      {"wall.toml", mesh("open.obj", "unit = \"cm\"\nshell = 0.1\n")},
      {"built_in_mesh.toml", mesh("toutatis.obj", "unit = \"km\"\n")},
      {"no_unit.toml", mesh("sound.obj", "")},
      {"open_mesh.toml", mesh("open.obj", "unit = \"cm\"\n")},
      {"no_mesh.toml", mesh("missing.obj", "unit = \"cm\"\n")},
      {"endless_mesh.toml", mesh("/dev/zero", "unit = \"cm\"\n")},
      {"secret_mesh.toml", mesh("secret.toml", "unit = \"cm\"\n")},
      {"scene_as_mesh.toml", mesh("sound.toml", "unit = \"cm\"\n")},
      {"short_mesh.toml", mesh("short.stl", "unit = \"cm\"\n")},
      {"moments.toml", "[body]\nmoments = [3, 4, 5]\n"},
      {"inertia.toml", "[body]\ninertia = [[3, 0.2, -0.1], [0.2, 4, 0.3], [-0.1, 0.3, 5]]\n"},
      {"with a space.toml", sound_scene},
      {"caf\xc3\xa9.toml", sound_scene},
      {"empty.toml", ""},
      {"syntax.toml", "[motion]\nomega = [1,\n"},
      {"wrong_type.toml", "[motion]\nomega = \"fast\"\n"},
      {"unknown_key.toml", "[motion]\nomega = [1, 2, 3]\nspeeed = 1\n"},
      {"no_number.toml", "[motion]\nomega = [nan, inf, -inf]\n"},
      {"whole.toml", "[motion]\nomega = [1, 2, 9007199254740993]\n"},
      {"dense.toml", part("radius = 1\nlength = 2\ndensity = 9007199254740993\n")},
      {"short_axis.toml", part(cylinder + "axis = [1e-300, 0, 0]\n")},
      {"thin.toml", part("radius = 1e-300\nlength = 2\ndensity = 3\n")},
      {"tiny_moments.toml", "[body]\nmoments = [1e-107, 1e-107, 1e-107]\n"},
      {"uneven_moments.toml", "[body]\nmoments = [1e30, 1e30, 1e-300]\n"},
      {"recorded.toml", "[body]\nmoments = [3, 4, 5]\n[motion]\nfile = \"recording.csv\"\n"},
      {"recorded_itself.toml", "[motion]\nfile = \"recorded_itself.toml\"\n"},
      {"recorded_nowhere.toml", "[motion]\nfile = \"nowhere.csv\"\nto = 1\n"},
      {"recorded_twice.toml", "[motion]\nfile = \"recording.csv\"\nomega = [1, 2, 3]\n"},
      {"principal.toml", "[body]\nmoments = [3, 4, 5]\n[motion]\nomega = [0, 0, 2]\n"},
      {"fast.toml", "[motion]\nomega = [1e6, 5, 3]\n"},
      {"long_film.toml", "[motion]\nduration = 1e9\n[film]\nfps = 0.001\nspeed = 1e6\n"},
      {"latin1.toml", "title = \"caf\xe9\"\n"},
      {"escapes.toml", "title = \"\\u001b[31m red\\u0007\"\n"},
      {"key_escapes.toml", "[motion]\n\"\\u001b[31momega\\n\" = 1\n"},
      {"raw_control.toml", "title = \"\x01\x1b\"\n"},
      {"nul.toml", std::string("title = \"\0\"\n", 12)},
      {"deep.toml", "a = " + std::string(20000, '[') + std::string(20000, ']')},
      {"long_line.toml", "title = \"" + std::string(200'000, 'x') + "\"\n"},
      {"many_parts.toml",
       [&] {
         std::string parts;
         for (int i = 0; i < 1001; ++i) parts += part(cylinder);
         return parts;
       }()},
      {"upper.TOML", sound_scene},
      {"\x1b[31mred.toml", sound_scene},
      {"new\nline.toml", "omega = 1\n"},
      {"caf\xe9.toml", sound_scene},
      {"secret.toml", sound_scene}};
  for (const auto& [name, text] : scenes) put(folder / name, text);
  fs::create_directory(folder / "folder.toml");
  fs::create_symlink("sound.toml", folder / "link.toml");
  fs::create_symlink("loop.toml", folder / "loop.toml");
  fs::create_symlink("nowhere.toml", folder / "dangling.toml");
  fs::create_symlink("/dev/zero", folder / "zero.toml");
}

void put_pictures(const fs::path& folder) {
  fs::copy(fs::path(TWRENCH_FUZZ_CORPUS) / "png", folder / "png", fs::copy_options::recursive);
  fs::copy_file(folder / "frames/frame_000000.png", folder / "a.png");
  fs::copy_file(folder / "frames/frame_000001.png", folder / "b.png");
  fs::copy_file(folder / "a.png", folder / "half.png");
  fs::resize_file(folder / "half.png", fs::file_size(folder / "a.png") / 2);
  fs::permissions(folder / "a.png", fs::perms(0640));
  put(folder / "text.png", "no picture");
  put(folder / "font.ttf", "no font");
  fs::create_symlink("b.png", folder / "link.png");
}

/// Creates folders with manifests that the program would not write.
void put_broken_frames(const fs::path& folder) {
  const std::vector<std::pair<std::string, std::string>> manifests{
      {"m_empty", ""},
      {"m_syntax", R"({"frames": [)" + std::string(30000, '[')},
      {"m_null", R"({"version": null, "frames": null, "fps": 0, "size": [0, 0]})"},
      {"m_other", R"({"name": "a web extension", "manifest_version": 3})"},
      {"m_escapes", "{\"\x1b[31m\": \"\xff\"}"}};
  for (const auto& [name, text] : manifests) {
    fs::create_directory(folder / name);
    put(folder / name / "manifest.json", text);
    fs::copy_file(folder / "a.png", folder / name / "frame_000000.png");
  }
  fs::copy(folder / "frames", folder / "holes");
  fs::remove(folder / "holes/frame_000001.png");
  fs::copy(folder / "frames", folder / "orphans");
  fs::remove(folder / "orphans/manifest.json");
  fs::create_directory(folder / "m_zero");
  fs::create_symlink("/dev/zero", folder / "m_zero/manifest.json");
  fs::create_directory(folder / "m_fifo");
}

/// Runs the program in the folder.
void run_there(const fs::path& folder, std::vector<std::string> command) {
  const Ended ended = run({std::move(command), folder, folder / "said"});
  if (ended.code != 0) throw std::runtime_error("the playground cannot be made: " + ended.err);
  fs::remove(folder / "said.out");
  fs::remove(folder / "said.err");
}

/// Creates a file of another program under each ending of an output, with a link to it, and those
/// that the program itself writes.
void put_old_outputs(const fs::path& folder, const fs::path& twrench) {
  for (const char* ending : {".aem", ".csv",  ".gif", ".glb",  ".htm",  ".html", ".json", ".md",
                             ".mkv", ".mov",  ".mp4", ".npz",  ".pdf",  ".png",  ".py",   ".svg",
                             ".txt", ".urdf", ".vtt", ".webm", ".webp", ".xml"}) {
    const std::string notes = std::string("notes") + ending;
    put(folder / notes, "my notes\n");
    fs::create_symlink(notes, folder / ("to_" + notes));
  }
  put(folder / "recording.csv", "t,wx,wy,wz\n0,0.1,2,0.3\n0.5,0.2,2,0.3\n1,0.3,2,0.2\n");
  for (const Writing& writing : writings()) {
    for (const std::string& ending : writing.endings) {
      std::vector<std::string> command{twrench.string()};
      command.insert(command.end(), writing.words.begin(), writing.words.end());
      command.insert(command.end(), {"-o", "own_" + writing.command() + ending});
      run_there(folder, command);
    }
  }
}

void put_places(const fs::path& folder) {
  fs::create_directory(folder / "folder");
  fs::create_directory(folder / "folder.mp4");
  fs::create_directory(folder / "locked");
  fs::create_directory(folder / "read_only");
  put(folder / "target.mp4", "old\n");
  fs::create_symlink("target.mp4", folder / "link.mp4");
  fs::create_symlink("new.mp4", folder / "dangling.mp4");
  fs::create_symlink("loop", folder / "loop");
}

}  // namespace

const std::vector<Writing>& writings() {
  static const std::vector<Writing> all{
      {{"simulate", "sound.toml"}, {".csv", ".json", ".npz"}},
      {{"inertia", "sound.toml"}, {".txt", ".json"}},
      {{"check", "recording.csv", "--scene", "sound.toml", "--no-fail"}, {".txt", ".json", ".xml"}},
      {{"study", "sound.toml", "--methods", "rk4", "--steps", "0.1"}, {".txt", ".csv", ".json"}},
      {{"cases"}, {".txt", ".csv", ".json"}},
      {{"schema"}, {".json"}},
      {{"export", "sound.toml"}, {".glb", ".py", ".aem"}},
      {{"plot", "sound.toml"}, {".svg", ".pdf", ".png"}}};
  return all;
}

void furnish(const fs::path& folder, const fs::path& twrench) {
  put_scenes(folder);
  put_meshes(folder);
  put_robots(folder);
  put_amplifiers(folder);
  for (const auto& [name, scene] : {std::pair{"frames", "sound.toml"}, {"other", "stable-y"}}) {
    run_there(folder,
              {twrench.string(), "render", scene, "--no-video", "--size", "64x48", "--duration",
               "1", "--fps", "4", "--speed", "1", "--progress", "none", "--frames-dir", name});
  }
  put_old_outputs(folder, twrench);
  put_pictures(folder);
  put_broken_frames(folder);
  put_places(folder);
}

void put_loud_programs(const fs::path& folder) {
  fs::create_directory(folder);
  for (const std::string name : {"ffmpeg", "ffprobe"}) {
    put(folder / name, "#!/bin/sh\necho 'a library: warning: {' >&2\nPATH=\"${PATH#*:}\" exec " +
                           name + " \"$@\"\n");
    fs::permissions(folder / name, fs::perms(0755));
  }
}

void copy_playground(const fs::path& from, const fs::path& to) {
  fs::copy(from, to, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  for (const char* name : {"fifo", "fifo.toml", "m_fifo/manifest.json"}) put_fifo(to / name);
  fs::permissions(to / "secret.toml", fs::perms::none);
  fs::permissions(to / "locked", fs::perms::none);
  fs::permissions(to / "read_only", fs::perms(0555));
}

}  // namespace twrench::torture
