// User errors: each prints one line that names the mistake, has the right exit code, and writes no
// file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/twrench.h"
#include "sanitizers.h"
#include "system/file.h"

namespace twrench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Mistake {
  const char* arguments;
  int code;
  const char* message;  ///< part of standard error
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.arguments; }

class BadInput : public testing::TestWithParam<Mistake> {};

TEST_P(BadInput, IsOneClearLine) {
  if (has_sanitizers && std::string_view(GetParam().arguments).find("16384") != std::string::npos) {
    GTEST_SKIP() << "allocates gigabytes";
  }
  const ScratchFolder folder;
  system::write_file_atomically(folder / "key.toml",
                                "[body]\nmoments = [1, 2, 3]\n[film]\nfsp = 3\n");
  system::write_file_atomically(folder / "syntax.toml", "title = \n");
  system::write_file_atomically(folder / "mass.toml",
                                "[[part]]\nshape = 'sphere'\nradius = 1\ndensity = -1\n");
  system::write_file_atomically(folder / "SYNTAX.Toml", "title = \n");
  system::write_file_atomically(folder / "file", "");
  std::filesystem::create_directory(folder / "folder.toml");
  const Outcome run = run_twrench(folder, GetParam().arguments);
  EXPECT_EQ(run.code, GetParam().code) << run.err;
  EXPECT_THAT(run.err, StartsWith("twrench: error: "));
  EXPECT_THAT(run.err, HasSubstr(GetParam().message));
  EXPECT_LE(std::ranges::count(run.err, '\n'), 2) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_FALSE(std::filesystem::exists(folder / "out")) << "something was written";
}

INSTANTIATE_TEST_SUITE_P(
    All, BadInput,
    testing::Values(
        Mistake{"", 2, "command line: no command was given"},
        Mistake{"--versoin", 2, "command line: unknown option '--versoin'"},
        Mistake{"--versoin", 2, "did you mean '--version'?"},
        Mistake{"help rendr", 2, "did you mean 'render'?"},
        Mistake{"methods more", 2, "methods: unexpected argument 'more'"},
        Mistake{"cases nasa-tumbling-brik", 2, "did you mean 'nasa-tumbling-brick'?"},
        Mistake{"cases gazebo-bx -o out", 2, "case: unknown name 'gazebo-bx'"},
        Mistake{"cases ''", 2, "NAME: its value is empty\n  give a value, or omit the argument\n"},
        Mistake{"compare '' a.png", 2, "EXPECTED: its value is empty\n  give a value\n"},
        Mistake{"schema -o ''", 2, "empty\n  give a value, or omit the option\n"},
        Mistake{"cases gazebo-box more", 2, "cases: unexpected argument 'more'"},
        Mistake{"cases --format xml", 2, "--format: unknown name 'xml'"},
        Mistake{"cases -o missing/a.txt", 5, "missing/a.txt"},
        Mistake{"schema more", 2, "schema: unexpected argument 'more'"},
        Mistake{"schema --format json", 2, "schema: unknown option '--format'"},
        Mistake{"schema -o missing/a.json", 5, "missing/a.json"},
        Mistake{"schema -o folder.toml", 2, "must end in .json"},
        Mistake{"schema -o ''", 2, "--output: its value is empty"},
        Mistake{"schema -o a -o b", 2,
                "--output: it can be given only once, but was given 2 times, the second as 'b'"},
        Mistake{"schema --help-most", 2, "schema: unknown option '--help-most'"},
        Mistake{"render --sise=640x360", 2, "did you mean '--size'? see twrench render --help"},
        Mistake{"render --method", 2, "--method: its value NAME is missing"},
        Mistake{"render --fps 1 --fps 2", 2,
                "--fps: it can be given only once, but was given 2 times"},
        Mistake{"render --fps 30/0", 2, "--fps: '30/0' is not a fraction"},
        Mistake{"simulate --fps 2000/1", 2, "--fps: is 2000"},
        Mistake{"render --no-video=x", 2, "--no-video: it takes no value"},
        Mistake{"render --timing=xml", 2, "--timing: unknown name 'xml'"},
        Mistake{
            "simulate stable-y stable-z", 2,
            "SCENE: it can be given only once, but was given 2 times, the second as 'stable-z'"},
        Mistake{"render --resume=2 new.mp4", 2, "--resume: it takes no value"},
        Mistake{"inertia missing --scale 0.1", 2, "scene: unknown name 'missing'"},
        Mistake{"inertia sphere --scale 0.1", 2, "--scale: is for a mesh"},
        Mistake{"study --max-error ''", 2, "--max-error: its value is empty"},
        Mistake{"study --max-error= stable-y", 2, "--max-error: its value is empty"},
        Mistake{"study --methods ''", 2, "--methods: its value is empty"},
        Mistake{"simulate --times ''", 2, "--times: its value is empty"},
        Mistake{"simulate -o ''", 2, "--output: its value is empty"},
        Mistake{"simulate ''", 2, "SCENE: its value is empty"},
        Mistake{"render --frames ''", 2, "--frames: its value is empty"},
        Mistake{"inertia missing.TOML", 5, "cannot read missing.TOML"},
        Mistake{"inertia ./missing", 5, "cannot read ./missing"},
        Mistake{"inertia SYNTAX.Toml", 2, "SYNTAX.Toml:1"}, Mistake{"inertia file", 2, "file"},
        Mistake{"inertia \"$(printf 'a\\nopenjd_env: B=c\\033[2J.toml')\"", 5,
                "a\\nopenjd_env: B=c\\x1b[2J.toml"},
        Mistake{"inertia $(printf '%300s' | tr ' ' a).toml", 5, "File name too long"},
        Mistake{"simulate -o $(printf '%300s' | tr ' ' a)", 5, "File name too long"},
        Mistake{"encode $(printf '%300s' | tr ' ' a) -o v.mp4", 5, "File name too long"},
        Mistake{"rendr", 2, "did you mean 'render'?"},
        Mistake{"render --sise 640x360", 2, "--sise"},
        Mistake{"render dzhanibekow", 2, "did you mean 'dzhanibekov'?"},
        Mistake{"render missing.toml", 5, "missing.toml"},
        Mistake{"render --theme papr", 2, "did you mean 'paper'?"},
        Mistake{"render --view quat", 2, "--view: unknown name 'quat'"},
        Mistake{"render --show hat", 2, "--show: unknown name 'hat'"},
        Mistake{"render --hide hat", 2, "--hide: unknown name 'hat'"},
        Mistake{"render --color pink", 2, "--color: 'pink' is not a colour"},
        Mistake{"render --metallic 2", 2, "--metallic: is 2"},
        Mistake{"render --roughness 0", 2, "--roughness: is 0"},
        Mistake{"render --trail-point a,b,c", 2, "--trail-point: 'a' is not a number"},
        Mistake{"render --trail-length 0", 2, "--trail-length: is 0"},
        Mistake{"render --motion-blur 0", 2, "--motion-blur: is 0"},
        Mistake{"render --elevation 3", 2, "--elevation: is 3"},
        Mistake{"render --compare rk4,rk4,rk4,rk4,rk4", 2, "has 5 methods"},
        Mistake{"render --font sams", 2, "font: unknown name 'sams'"},
        Mistake{"render --font missing.ttf", 2, "missing.ttf"},
        Mistake{"render --font ./file", 2, "font ./file: is not a TrueType or OpenType font"},
        Mistake{"render --title \u0646\u0635", 2,
                "title: contains the character U+0646, which neither the font nor the built-in "
                "sans can draw\n  --font FILE takes a font that has it: fc-list :charset=646 lists "
                "those that are installed; --title TEXT gives another title"},
        Mistake{"render --view quad --compare rk4,exact", 2, "compare: the view 'quad'"},
        Mistake{"render folder.toml", 5, "folder.toml"},
        Mistake{"render --size 16384x16384 --samples 64", 2, "samples"},
        Mistake{"render syntax.toml", 2, "syntax.toml:1"},
        Mistake{"render key.toml", 2, "key.toml:4: film: unknown name 'fsp'"},
        Mistake{"render mass.toml", 2, "mass.toml:4: part[0].density: is -1"},
        Mistake{"render --method rk5", 2, "did you mean 'rk4'?"},
        Mistake{"render --size 0x360", 2, "--size: is 0"},
        Mistake{"render --size -640x360", 2, "--size: is -640"},
        Mistake{"render --size 640", 2, "--size: '640' is not WIDTHxHEIGHT"},
        Mistake{"render --size 640x", 2, "--size: '640x' is not WIDTHxHEIGHT"},
        Mistake{"render --size 640,360", 2, "--size: '640,360' is not WIDTHxHEIGHT"},
        Mistake{"render --size 641x360", 2, "--size 642x360"},
        Mistake{"render --size 99999x99999", 2, "--size: is 99999"},
        Mistake{"render --fps 0", 2, "--fps: is 0"}, Mistake{"render --fps -5", 2, "--fps: is -5"},
        Mistake{"render --step 0", 2, "--step: is 0"},
        Mistake{"render --step x", 2, "--step: 'x' is not a number"},
        Mistake{"render --tolerance 0", 2, "--tolerance: is 0"},
        Mistake{"render --tolerance -1e-9", 2, "--tolerance: is -1e-09"},
        Mistake{"render --duration 0", 2, "--duration: is 0"},
        Mistake{"render --duration nan", 2, "--duration: is nan"},
        Mistake{"render --duration inf", 2, "--duration: is inf"},
        Mistake{"render --speed 0", 2, "--speed: is 0"},
        Mistake{"render --omega 1,2", 2, "--omega: '1,2' is not three numbers"},
        Mistake{"render --omega 1,nan,0", 2, "--omega: is nan"},
        Mistake{"render --inertia 1,0,2", 2, "--inertia: is 0"},
        Mistake{"render --inertia 1,-1,2", 2, "--inertia: is -1"},
        Mistake{"render --inertia 1,2,3,4", 2, "--inertia: '1,2,3,4' is not three or six numbers"},
        Mistake{"render --inertia 1,2", 2, "  give A,B,C or Ixx,Iyy,Izz,Ixy,Ixz,Iyz"},
        Mistake{"render --inertia 1,2,3,x,0,0", 2, "--inertia: 'x' is not a number"},
        Mistake{"simulate --inertia 1,2,3,nan,0,0", 2, "--inertia: is nan"},
        Mistake{"study --inertia 1,2,3,0,0,inf", 2, "--inertia: is inf"},
        Mistake{"plot -o a.svg --inertia 2,2,4,3,0,0", 2, "moments are -1, 4 and 5, but each must"},
        Mistake{"inertia --inertia 2,2,4,3,0,0", 2, "  check the signs of the products of inertia"},
        Mistake{"render --duration 1e9 --fps 1000", 2, "frames"},
        Mistake{"render --duration 1e9", 2, "a greater speed, a lower frame rate or a shorter"},
        Mistake{"render --speed 1e9", 2, "a smaller speed, a higher frame rate or a longer"},
        Mistake{"simulate --duration 1e9", 2, "use --fps 0.009 or less, or a shorter --duration"},
        Mistake{"export -o a.aem --fps 1000 --duration 1e5", 2, "use --fps 90 or less"},
        Mistake{"simulate --inertia 3,5,7 --omega 1,1e9,1 --duration 1", 2, "  use a shorter"},
        Mistake{"report --static -o a.html --method rk4 --step 1e-7", 2, "take a longer --step"},
        Mistake{"report --static -o a.html --method rk4 --step 1e3", 2, "take a shorter --step"},
        Mistake{"report --static -o a.html --duration 1e5 --tolerance 1e-14", 2,
                "take a shorter --duration or a larger --tolerance, or --method exact for a rigid "
                "body"},
        Mistake{"render explain --method rk4 --step 1e-9", 2, "take a longer --step"},
        Mistake{"render --duration 1e-6", 2, "0 frames"}, Mistake{"render --frames 5-3", 2, "5-3"},
        Mistake{"render --frames 0-960", 2, "960"}, Mistake{"render --frames x", 2, "'x'"},
        Mistake{"render --jobs 0", 2, "--jobs: is 0"},
        Mistake{"render --samples 0", 2, "--samples: is 0"},
        Mistake{"render --samples 64", 2, "samples"},
        Mistake{"render --background pink", 2, "--background: 'pink'"},
        Mistake{"render --progress loud", 2, "--progress"},
        Mistake{"render --backend metal", 2, "--backend"},
        Mistake{"render --no-video --no-frames", 2, "nothing to write"},
        Mistake{"render --crf 52 -o out/f.mp4", 2, "crf 52: the encoder libx264 accepts 0 to 51"},
        Mistake{"render --crf 60 -o out/f.mov", 2, "choose a number in this range"},
        Mistake{"render --crf 64 -o out/f.webm", 2, "--crf: is 64, but must be an integer"},
        Mistake{"render --crf=-1", 2, "--crf: is -1, but must be an integer"},
        Mistake{"render --crf 17.5", 2, "--crf: is 17.5, but must be an integer"},
        Mistake{"render --crf good", 2, "--crf: 'good' is not a number"},
        Mistake{"render --crf 20 -o out/f.gif", 2, "crf 20: the encoder gif has no such setting"},
        Mistake{"render --encode small -o out/f.webp", 2,
                "leave it out, or choose another format (.mp4, .mov, .mkv, .webm)"},
        Mistake{"render --encode fast --background transparent -o out/f.mov", 2,
                "encode fast: the encoder prores_ks has no such setting"},
        Mistake{"render --encode smal", 2, "did you mean 'small'?"},
        Mistake{"render --crf 20 --no-video", 2, "give --encode and --crf to twrench encode"},
        Mistake{"render --encode fast --shard 1/2", 2, "no video is encoded"},
        Mistake{"encode folder.toml -o out/f.mp4 --crf 64", 2, "--crf: is 64"},
        Mistake{"render --frames-dir file/x --no-video --size 32x32", 5, "file"},
        Mistake{"render -o file/x.mp4 --size 32x32", 5, "file"},
        Mistake{"render -o /dev/null/x.mp4 --size 32x32", 5, "/dev/null"},
        Mistake{"simulate --times 1,,2", 2, "--times: '' is not a number"},
        Mistake{"simulate --times 1,inf", 2, "--times: is inf"},
        Mistake{"simulate --format xml", 2, "--format"},
        Mistake{"simulate --method rk4 --step 1e-9 --times 1000", 2, "more than"},
        Mistake{"simulate --method rk4 --step 400 --times 1000", 2, "longer than a turn"},
        Mistake{"simulate --method rk4 --step 400 --times 1000", 2, "take a shorter --step"},
        Mistake{"simulate --method rk4 --step 1e-9 --times 1000", 2, "take a longer --step"},
        Mistake{
            "simulate --method euler --inertia 1,2,3 --omega 0.1,100,0.1 --step 0.06 --times 99", 2,
            "a shorter --step, or a method that stays on SO(3)"},
        Mistake{"study --inertia 1,2,3 --omega 1e12,1e11,1 --duration 1e9", 2,
                "give a shorter --duration"},
        Mistake{"render --backend osmesa --egl-device 0", 2, "--egl-device: OSMesa has none"},
        Mistake{"simulate --method rkmk4 --step 6 --omega 1,1,1 --times 9", 2, "--step"},
        Mistake{"simulate --method implicit-trapezoid --step 4 --times 9", 2, "too long"},
        Mistake{"simulate --tolerance 1e-16", 2, "(the limit of double precision)"},
        Mistake{"simulate --inertia 1,nan,2", 2, "--inertia: is nan"},
        Mistake{"plot", 2, "--output"},
        Mistake{"plot -o a.bmp", 2, "must end in .svg, .pdf or .png"},
        Mistake{"plot -o -", 2, "must end in .svg, .pdf or .png"},
        Mistake{"plot stable-z nothing -o a.svg", 2, "unknown name 'nothing'"},
        Mistake{"plot -o missing/a.svg", 5, "missing/a.svg"},
        Mistake{"study --methods rk4,rk5", 2, "--methods: unknown name 'rk5'"},
        Mistake{"study --steps 0.1,0", 2, "--steps: is 0"},
        Mistake{"study --steps 0.1,x", 2, "--steps: 'x' is not a number"},
        Mistake{"study --tolerances 1e-20", 2, "--tolerances: is 1e-20"},
        Mistake{"study --inertia 0,1,1", 2, "--inertia: is 0"},
        Mistake{"study --max-error x", 2, "--max-error: 'x' is not a number"},
        Mistake{"study --max-energy-drift -1", 2, "--max-energy-drift: is -1"},
        Mistake{"study --format xml", 2, "--format"},
        Mistake{"study --plot a.gif", 2, "must end in .svg, .pdf or .png"},
        Mistake{"study --methods exact --plot a.svg", 2, "no steps to plot"},
        Mistake{"inertia nothing", 2, "unknown name 'nothing'"},
        Mistake{"encode missing -o a.mp4", 5, "missing"},
        Mistake{"encode missing -o a.mp4", 5, "the folder that twrench render wrote"},
        Mistake{"compare key.toml", 2, "ACTUAL"}));

TEST(BadInput, ADamagedFontIsOneClearLine) {
  const ScratchFolder folder;
  const std::string font = text_of(TWRENCH_SANS_FILE);
  system::write_file_atomically(folder / "cut.ttf", font.substr(0, font.size() / 2));
  const Outcome run = run_twrench(folder, "render --font cut.ttf");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.err,
            "twrench: error: font cut.ttf: is a damaged font: not all of its tables can be read\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "out")) << "something was written";
}

TEST(BadInput, FfmpegIsMissedBeforeTheFirstFrame) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "render --size 32x32", "PATH=/nowhere ");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("ffmpeg"));
  EXPECT_THAT(run.err, HasSubstr("apt-get install ffmpeg"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out")) << "something was written";
}

TEST(BadInput, AFullDiskIsReportedForStandardOutput) {
  const ScratchFolder folder;
  const Outcome run = run_shell(folder, "\"$TWRENCH\" simulate --times 1 >/dev/full");
  EXPECT_EQ(run.code, 5);
  EXPECT_THAT(run.err, HasSubstr("No space left on device"));
}

}  // namespace
}  // namespace twrench
