#include "option_values.h"

#include <initializer_list>
#include <map>

#include "base/enumeration.h"
#include "playground.h"
#include "scene/materials.h"
#include "scene/scene.h"
#include "system/output.h"
#include "video/codec.h"

namespace twrench::torture {
namespace {

using Words = std::vector<std::string>;

std::vector<Value> values(const Words& words, bool may_last = false) {
  std::vector<Value> made;
  for (const std::string& word : words) made.push_back({word, may_last});
  return made;
}

std::vector<Value> joined(std::initializer_list<std::vector<Value>> parts) {
  std::vector<Value> whole;
  for (const auto& part : parts) whole.insert(whole.end(), part.begin(), part.end());
  return whole;
}

/// Values that no option expects.
const std::vector<Value>& odd_words() {
  static const std::vector<Value> words =
      values({"", " ", "-", "--", "\xff\xfe", "\x1b[31mred", "a\nb", "\t", "%s%n", "caf\xc3\xa9",
              "\u202e abc", std::string(5000, 'a'), "'\"\\", "@file", "..", "#", "\x7f\xc2\x85"});
  return words;
}

Values numbers(const Words& sensible, const Words& edges) {
  return {values(sensible), joined({values(edges, true),
                                    values({"0",
                                            "-0",
                                            "-1",
                                            "nan",
                                            "-nan",
                                            "inf",
                                            "-inf",
                                            "1e400",
                                            "1e-400",
                                            "5e-324",
                                            "1e-300",
                                            "1e300",
                                            "1.7976931348623157e308",
                                            "9007199254740993",
                                            "0x10",
                                            "1,5",
                                            "1e",
                                            "abc",
                                            "+1",
                                            "1_000",
                                            "1 ",
                                            "\xd9\xa3",
                                            "1e5",
                                            "1e-5",
                                            "0.1",
                                            "2147483648",
                                            "-2147483649",
                                            "1.5",
                                            std::string(400, '9')},
                                           true),
                                    odd_words()})};
}

/// Numbers separated by commas.
Values lists(const Words& sensible, const Words& edges) {
  return {values(sensible),
          joined({values(edges, true),
                  values({"1,2", "1,2,3,4", "nan,1,1", "1,inf,1", "0,0,0", "1e12,1,1", "1e-300,1,1",
                          "1e300,1e300,1e300", "1,,2", ",", "1,2,", "1;2;3", "1,2,3 ", "a,b,c",
                          "-1,-1,-1", "1e-154,1e-154,1e-154"},
                         true),
                  odd_words()})};
}

Values words(const Words& sensible) {
  return {values(sensible), joined({values({"Auto", "none,", "nobody"}), odd_words()})};
}

/// Each name alone, and each pair of consecutive names.
template <typename Enumeration>
Words names_and_lists() {
  const Words names = enumerator_names<Enumeration>();
  Words lists = names;
  for (std::size_t i = 1; i < names.size(); ++i) lists.push_back(names[i - 1] + ',' + names[i]);
  return lists;
}

Values texts() {
  return {values({"A title", "caf\xc3\xa9", "\xe6\x97\xa5\xe6\x9c\xac", "\xf0\x9f\x98\x80"}),
          joined({values({std::string(100'000, 'x'), std::string(300, '\n')}, true), odd_words()})};
}

Values scenes() {
  return {values({"dzhanibekov",
                  "stable-y",
                  "stable-z",
                  "sphere",
                  "tao-disk",
                  "t-handle",
                  "wing-nut",
                  "tennis-racket",
                  "phone",
                  "book",
                  "hammer",
                  "toutatis",
                  "explorer-1",
                  "dual-spin",
                  "t-handle-wheel",
                  "sound.toml",
                  "moments.toml",
                  "inertia.toml",
                  "solids.toml",
                  "mesh.toml",
                  "wall.toml",
                  "built_in_mesh.toml",
                  "sound.obj",
                  "recorded.toml",
                  "robot.urdf",
                  "robot.sdf",
                  "robot.xml",
                  "meshes.urdf",
                  "with a space.toml",
                  "caf\xc3\xa9.toml",
                  "link.toml",
                  "./sound.toml"}),
          joined({values({"empty.toml",
                          "open.obj",
                          "short.stl",
                          "missing.glb",
                          "syntax.toml",
                          "wrong_type.toml",
                          "no_unit.toml",
                          "open_mesh.toml",
                          "no_mesh.toml",
                          "endless_mesh.toml",
                          "secret_mesh.toml",
                          "scene_as_mesh.toml",
                          "short_mesh.toml",
                          "recorded_itself.toml",
                          "recorded_nowhere.toml",
                          "recorded_twice.toml",
                          "numbers.urdf",
                          "names.urdf",
                          "many.urdf",
                          "cut.urdf",
                          "macro.urdf",
                          "notes.urdf",
                          "unknown_key.toml",
                          "no_number.toml",
                          "whole.toml",
                          "dense.toml",
                          "short_axis.toml",
                          "thin.toml",
                          "tiny_moments.toml",
                          "uneven_moments.toml",
                          "latin1.toml",
                          "escapes.toml",
                          "key_escapes.toml",
                          "raw_control.toml",
                          "nul.toml",
                          "deep.toml",
                          "long_line.toml",
                          "many_parts.toml",
                          "nodes.gltf.toml",
                          "lines.gltf.toml",
                          "needles.obj.toml",
                          "mesh_sizes.toml",
                          "parts_and_shots.toml",
                          "upper.TOML",
                          "\x1b[31mred.toml",
                          "new\nline.toml",
                          "caf\xe9.toml",
                          "secret.toml",
                          "folder.toml",
                          "loop.toml",
                          "dangling.toml",
                          "zero.toml",
                          "missing.toml",
                          "missing/missing.toml",
                          "locked/a.toml",
                          "dzanibekov",
                          "a.png",
                          "folder",
                          "/dev/null",
                          "/dev/zero",
                          std::string(251, 'a') + ".toml",
                          std::string(5000, 'a') + ".toml"}),
                  values({"fifo.toml", "fast.toml", "long_film.toml", "principal.toml"}, true),
                  odd_words()})};
}

Values pictures() {
  return {values({"a.png", "b.png", "link.png", "png/rgb.png", "png/rgba.png", "png/gray16.png",
                  "png/palette.png", "png/one_bit.png"}),
          joined({values({"half.png", "text.png", "png/chunk_beyond_the_end.png",
                          "png/empty_data_chunk.png", "png/ends_within_a_chunk.png",
                          "png/larger_than_it_can_be.png", "frames", "missing.png", "/dev/null",
                          "/dev/zero", "loop", "sound.toml", "secret.toml", "locked/a.png"}),
                  values({"fifo"}, true), odd_words()})};
}

Values folders_of_frames() {
  return {values({"frames", "other", "frames/", "./frames"}),
          joined({values({"holes", "orphans", "folder", "m_empty", "m_syntax", "m_null", "m_other",
                          "m_escapes", "m_zero", "missing", "a.png", "locked", "/dev/null"}),
                  values({"m_fifo", "fifo"}, true), odd_words()})};
}

/// Names of files to be written, with these extensions. "own_COMMAND" is a file that the command
/// wrote, "notes" one of another program.
Values outputs(const Words& endings) {
  Words sensible;
  Words hostile{"-",           "missing/x",
                "folder",      "folder/",
                "/dev/full",   "/dev/stdout",
                "/dev/null",   "/",
                ".",           "loop",
                "x",           "x.txt",
                "x.MOV",       "sound.toml",
                "sound.obj",   "a.png",
                "new\nline.x", "\xff.x",
                "\x1b[2J.x",   "secret.toml",
                "font.ttf",    "link.toml",
                "b.png",       "recording.csv",
                "-x",          "frames/manifest.json",
                "\x7f",        "frames/frame_000001.png"};
  for (const std::string& ending : endings) {
    for (const char* name : {"new", "missing/new", "with a space", "caf\xc3\xa9"}) {
      sensible.push_back(name + ending);
    }
    for (const Writing& writing : writings()) {
      hostile.push_back("own_" + writing.command() + ending);
    }
    for (const char* name : {"notes", "to_notes", "folder", "link", "dangling", "locked/new",
                             "read_only/new", "a.png/new", "file:new", "pipe:1", "%d", "-new",
                             "/proc/new", "new\nline", "\xff", "\x1b[31mred"}) {
      hostile.push_back(name + ending);
    }
    for (const unsigned length : {255U, 256U, 5000U}) {
      hostile.push_back(std::string(length - ending.size(), 'a').append(ending));
    }
  }
  return {values(sensible), joined({values(hostile), values({"fifo"}, true), odd_words()})};
}

Values outputs(const system::OutputKind& kind) {
  Words endings;
  for (const system::OutputFormat& format : kind.formats) {
    for (const std::string_view ending : format.endings) {
      if (!ending.empty()) endings.emplace_back(ending);
    }
  }
  return outputs(endings);
}

/// Recordings of a motion.
Values recordings() {
  return {values({"recording.csv", "own_simulate.csv", "own_simulate.npz", "./recording.csv"}),
          joined({values({"notes.csv", "a.png", "own_simulate.json", "own_export.aem", "folder",
                          "missing.csv", "/dev/null", "/dev/zero", "loop", "sound.toml"}),
                  values({"fifo"}, true), odd_words()})};
}

Values output_folders() {
  return {values({"new", "missing/new", "frames", "caf\xc3\xa9", "folder"}),
          joined({values({"other",
                          "holes",
                          "orphans",
                          "m_empty",
                          "m_syntax",
                          "m_null",
                          "m_other",
                          "m_escapes",
                          "m_zero",
                          ".",
                          "a.png",
                          "a.png/new",
                          "locked",
                          "locked/new",
                          "read_only",
                          "read_only/new",
                          "/dev/null",
                          "/dev/full",
                          "/proc/new",
                          "loop",
                          "fifo",
                          "link.toml",
                          std::string(256, 'a'),
                          "new\nline",
                          "\xff",
                          "\x1b[31mred",
                          "-"}),
                  values({"m_fifo"}, true), odd_words()})};
}

const std::map<std::string, Values>& known() {
  static const Words methods{"rk4", "rkmk4", "rkmk45", "exact", "euler", "rkf45", "suzuki4"};
  static const Words features = names_and_lists<scene::Feature>();
  static const Words videos = video::format_texts(&video::OutputFormat::extension);
  static const std::map<std::string, Values> map{
      {"SCENE", scenes()},
      {"NAME", words({"gazebo-box", "nasa-tumbling-brick", "newton-dzhanibekov"})},
      {"case", words({"gazebo-box", "kynema-precession"})},
      {"A", pictures()},
      {"B", pictures()},
      {"FRAMES_DIR", folders_of_frames()},
      {"omega", lists({"1,2,3", "0.1,2,0.3", "0,0,1"}, {"1e6,5,3", "1e12,0,0"})},
      {"inertia", lists({"3,4,5", "1,1,1", "3,4,5,0.2,-0.1,0.3"},
                        {"1e-107,1e-107,1e-107", "1e30,1e30,1e-300", "3,4,5,1,2", "1,1,1,1,1,1",
                         "1,1,1,2,0,0", "1e30,1e30,1e30,1e300,0,0"})},
      {"method", words(methods)},
      {"methods", words({"rk4", "rk4,rkmk4", "rkmk45,exact"})},
      {"step", numbers({"0.1", "0.5"}, {"1e-9", "1e6", "20"})},
      {"steps", lists({"0.1", "0.1,0.05"}, {"1e-9", "1e6", "0.1,0.1,0.1"})},
      {"tolerance", numbers({"1e-6", "1e-9"}, {"1e-16", "1", "1e-14"})},
      {"tolerances", lists({"1e-6", "1e-4,1e-8"}, {"1e-16", "1", "2"})},
      {"duration", numbers({"1", "2.5"}, {"1e9", "1e-9"})},
      {"fps", numbers({"2", "4", "29.97"}, {"1000", "1e-9"})},
      {"speed", numbers({"1", "0.5", "6"}, {"1e6", "1e-9"})},
      {"times", lists({"0", "0,1,2", "1.5,0.5"}, {"1e9", "-1", "1e300"})},
      {"shape", words(enumerator_names<scene::Equimomental>())},
      {"material", words(scene::material_names())},
      {"language", words({"en", "nb"})},
      {"theme", words(enumerator_names<scene::Theme>())},
      {"size",
       {values({"64x48", "48x64", "160x90", "100x20", "16x16", "333x77"}),
        joined(
            {values({"996x100", "1600x30", "16x3000", "16384x16", "16x16384", "2048x1024"}, true),
             values({"16385x16", "15x16", "0x0", "-1x-1", "64", "64x", "x64", "64x48x3", "1e2x1e2",
                     "nanxnan", "64.5x48", "64X48", "99999999999x1", "65x49"}),
             odd_words()})}},
      {"background", words({"black", "white", "#102030", "transparent"})},
      {"samples", numbers({"1", "2", "4"}, {"64", "65", "3"})},
      {"motion-blur", numbers({"1", "2"}, {"256", "257"})},
      {"color", words({"gray", "#ff0000"})},
      {"metallic", numbers({"0", "1", "0.5"}, {"1.0000001"})},
      {"roughness", numbers({"0.05", "1", "0.5"}, {"0.049"})},
      {"title", texts()},
      {"view", words(enumerator_names<scene::View>())},
      {"compare", words({"rk4,exact", "rk4,rkmk4,euler,exact", "rk4"})},
      {"show", words(features)},
      {"hide", words(features)},
      {"trail-point", lists({"1,2,3", "0,0,0"}, {"1e12,1e12,1e12"})},
      {"trail-length", numbers({"1", "5"}, {"1e6", "1e-9"})},
      {"text-fade", numbers({"0", "0.5"}, {"1e6", "1e-9"})},
      {"star-trail", numbers({"0", "1.5"}, {"1000", "1e-9"})},
      {"font",
       {values({"sans", "mono"}),
        joined({values({"font.ttf", "a.png", "secret.toml", "/dev/zero", "folder", "missing.ttf"}),
                values({"fifo"}, true), odd_words()})}},
      {"azimuth", numbers({"0", "1", "-1"}, {"1e3", "1001"})},
      {"elevation", numbers({"0", "0.5"}, {"1.5707963267948966", "-1.5707963267948966", "1.58"})},
      {"distance", numbers({"1", "2"}, {"0.2", "20", "21"})},
      {"orbit", numbers({"0", "0.1"}, {"1e3", "-1e3"})},
      {"field-of-view", numbers({"0.5", "1"}, {"0.05", "2.5", "2.6"})},
      {"frame", words(enumerator_names<scene::Frame>())},
      {"render/output", outputs(videos)},
      {"encode/output", outputs(videos)},
      {"width", numbers({"16", "64", "65"}, {"15", "16385"})},
      {"simulate/output", outputs(system::motion_output)},
      {"export/output", outputs(system::exported_motion)},
      {"inertia/output", outputs(system::robot_output)},
      {"inertia/report", outputs(system::robot_page)},
      {"fix", outputs(system::robot_file)},
      {"link", words({"base", "hand", "tip"})},
      {"package-path", folders_of_frames()},
      {"study/output", outputs(system::study_output)},
      {"check/output", outputs(system::check_output)},
      {"cases/output", outputs(system::list_of_cases)},
      {"schema/output", outputs(system::schema_output)},
      {"page/output", outputs(system::page_output)},
      {"report/output", outputs(system::report_output)},
      {"plot/output", outputs(system::plot_output)},
      {"plot", outputs(system::plot_output)},
      {"report", outputs(system::comparison_page)},
      {"diff", outputs(system::difference_picture)},
      {"FILE", recordings()},
      {"motion", recordings()},
      {"from", numbers({"0", "0.5"}, {"1e12"})},
      {"to", numbers({"1", "2"}, {"1e12"})},
      {"frames-dir", output_folders()},
      {"frames",
       {values({"0", "0-1", "0-1:2"}),
        joined({values({"0-999999999", "1-0", "-1", "0-", "0-1:0", "0,0,0", "5000000",
                        "0-1:99999999999", "a-b", "0--1", "0-1,", "99999999999999999999"}),
                odd_words()})}},
      {"shard",
       {values({"1/1", "1/2", "2/2"}),
        joined({values({"0/2", "3/2", "1/0", "1", "1/", "/1", "-1/2", "1/99999999999", "1/1000000",
                        "1.5/2", "a/b"}),
                odd_words()})}},
      {"backend", words({"auto", "osmesa"})},
      {"encode", words(enumerator_names<video::Effort>())},
      {"crf", numbers({"0", "16", "51"}, {"63", "64", "52"})},
      {"egl-device", words({"software", "0"})},
      {"jobs", numbers({"1", "2", "4"}, {"256", "257"})},
      {"progress", words({"none", "plain", "json", "openjd", "bar", "auto"})},
      {"timing", words({"text", "json"})},
      {"unit", words({"mm", "cm", "m", "inch", "km"})},
      {"scale", numbers({"1", "0.1", "2.54"}, {"1e-9", "1e12"})},
      {"density", numbers({"1", "7.8"}, {"1e-9", "1e6", "2e6"})},
      {"mass", numbers({"1", "1000"}, {"1e12"})},
      {"weld", numbers({"1e-6", "0"}, {"1e12", "0.1"})},
      {"shell", numbers({"0.1"}, {"1e-9"})},
      {"inertia/format", words({"text", "json", "junit"})},
      {"simulate/format", words({"csv", "json", "npz"})},
      {"export/format", words({"glb", "py", "aem", "csv", "json", "npz"})},
      {"max-angle", numbers({"1e-4", "1e-3"}, {"1e-6", "9e-7", "10"})},
      {"epoch", words({"2026-01-01T00:00:00", "9999-12-31T23:59:59", "0001-01-01T00:00:00"})},
      {"study/format", words({"text", "csv", "json"})},
      {"doctor/format", words({"text", "json"})},
      {"cases/format", words({"text", "json", "csv"})},
      {"max-error", numbers({"1", "1e-3"}, {"0"})},
      {"max-energy-drift", numbers({"1", "1e-3"}, {"0"})},
      {"max-flip-error", numbers({"1", "1e-3"}, {"0"})},
      {"threshold", numbers({"0", "8", "255"}, {"256"})},
      {"share", numbers({"0", "0.5", "1"}, {"1.1"})}};
  return map;
}

/// Values of every kind.
const Values& any_values() {
  static const Values all = [] {
    Values whole;
    for (const auto& [name, some] : known()) {
      whole.sensible = joined({whole.sensible, some.sensible});
      whole.hostile = joined({whole.hostile, some.hostile});
    }
    return whole;
  }();
  return all;
}

}  // namespace

const Values& values_for(const std::string& command, const std::string& name) {
  for (const std::string& key : {command + "/" + name, name}) {
    if (const auto found = known().find(key); found != known().end()) return found->second;
  }
  return any_values();
}

}  // namespace twrench::torture
