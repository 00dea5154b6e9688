#include "plot/gnuplot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "scratch_folder.h"
#include "system/error.h"
#include "system/file.h"

namespace twrench::plot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Plot line{400, 300, "plot x title \"a line\"\n"};

std::string first_bytes(const std::string& path, std::size_t count) {
  const auto bytes = system::read_file(path, 10'000'000);
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// Puts a substitute gnuplot, a shell script, first in PATH during its lifetime.
class StubGnuplot {
 public:
  StubGnuplot(const ScratchFolder& scratch, const std::string& script) {
    std::filesystem::create_directories(scratch / "bin");
    system::write_file_atomically(scratch / "bin/gnuplot",
                                  std::string_view("#!/bin/sh\n" + script));
    std::filesystem::permissions(scratch / "bin/gnuplot", std::filesystem::perms::owner_all);
    setenv("PATH", ((scratch / "bin").string() + ":" + before_).c_str(), 1);
  }
  ~StubGnuplot() { setenv("PATH", before_.c_str(), 1); }
  StubGnuplot(const StubGnuplot&) = delete;
  StubGnuplot& operator=(const StubGnuplot&) = delete;

 private:
  const std::string before_ = std::getenv("PATH");
};

std::string text_of(const std::filesystem::path& path) {
  const auto bytes = system::read_file(path, 10'000'000);
  return {bytes.begin(), bytes.end()};
}

system::OutputFile output(const std::filesystem::path& path) {
  return system::FileList().add_output(system::plot_output, path);
}

template <typename Failure>
Failure failure_of(const std::string& path) {
  try {
    draw_plot(output(path), line);
  } catch (const Failure& failure) {
    return failure;
  }
  ADD_FAILURE() << "no failure";
  return Failure("", "");
}

TEST(Gnuplot, DrawsEachFormatByTheFilesEnding) {
  const ScratchFolder scratch;
  for (const auto& [ending, start] :
       {std::pair{".svg", "<?xml"}, std::pair{".pdf", "%PDF-"}, std::pair{".png", "\x89PNG"}}) {
    const std::string path = scratch / (std::string("plot") + ending);
    require_gnuplot(system::format_of(system::plot_output, path));
    draw_plot(output(path), line);
    EXPECT_EQ(first_bytes(path, std::string_view(start).size()), start);
  }
  EXPECT_EQ(scratch.names().size(), 3U) << "a temporary file was left";
}

TEST(Gnuplot, MarksEachFileSoThatItMayBeReplaced) {
  const ScratchFolder scratch;
  for (const char* name : {"plot.svg", "plot.pdf", "plot.png"}) {
    draw_plot(output(scratch / name), line);
    EXPECT_NO_THROW(output(scratch / name)) << name;
    std::string text = text_of(scratch / name);
    text.erase(text.find(std::string(name).ends_with("png") ? "tEXt" : "twrench"), 4);
    system::write_file_atomically(scratch / name, text);
    EXPECT_THROW(output(scratch / name), system::ExistingFileError) << name;
  }
}

TEST(Gnuplot, TakesAnyNameAndAnyText) {
  const ScratchFolder scratch;
  const std::string odd = "a 'b' \"c\" \\ $(d) `e`\nf.svg";
  draw_plot(output(scratch / odd),
            {400, 300, "plot x title " + gnuplot_string("`date` \\ é") + " noenhanced\n"});
  EXPECT_THAT(scratch.names(), ElementsAre(odd));
  const auto bytes = system::read_file(scratch / odd, 1'000'000);
  EXPECT_THAT(std::string(bytes.begin(), bytes.end()), HasSubstr("`date` \\ é"));
}

TEST(Gnuplot, TellsWhatGnuplotSaidAndLeavesNothing) {
  const ScratchFolder scratch;
  try {
    draw_plot(output(scratch / "a.svg"), {400, 300, "plot nonsense(x)\n"});
    FAIL();
  } catch (const PlotError& error) {
    EXPECT_THAT(error.what(), HasSubstr("nonsense"));
  }
  EXPECT_THAT(scratch.names(), testing::IsEmpty());
}

TEST(Gnuplot, AFileThatIsNotCompleteIsNotKept) {
  const ScratchFolder scratch;
  const StubGnuplot stub(scratch, "cat >/dev/null\n");
  EXPECT_THAT(failure_of<system::FileError>(scratch / "a.svg").what(),
              HasSubstr("left it incomplete"));
  EXPECT_THAT(scratch.names(), ElementsAre("bin"));
}

TEST(Gnuplot, LeavesTheUsersSettingsOut) {
  const ScratchFolder scratch;
  const std::string home = std::getenv("HOME") == nullptr ? "/" : std::getenv("HOME");
  draw_plot(output(scratch / "a.svg"), line);
  system::write_file_atomically(scratch / ".gnuplot", "set title 'mine'\nset terminal dumb\n");
  setenv("HOME", scratch.path().c_str(), 1);
  draw_plot(output(scratch / "b.svg"), line);
  setenv("HOME", home.c_str(), 1);
  EXPECT_EQ(system::read_file(scratch / "a.svg", 1'000'000),
            system::read_file(scratch / "b.svg", 1'000'000));
}

TEST(Gnuplot, LacksAFormat) {
  const ScratchFolder scratch;
  const StubGnuplot stub(scratch, "echo 'unknown terminal' >&2; exit 1\n");
  try {
    require_gnuplot(system::plot_output.formats[1]);
    FAIL();
  } catch (const PlotError& error) {
    EXPECT_THAT(error.what(), HasSubstr("gnuplot cannot write .pdf files: "));
    EXPECT_THAT(error.what(), HasSubstr("unknown terminal"));
    EXPECT_THAT(error.remedy(), HasSubstr("gnuplot-nox"));
  }
}

TEST(Gnuplot, ThatIsKilledIsNotABuildThatLacksAFormat) {
  const ScratchFolder scratch;
  const StubGnuplot stub(scratch, "kill -KILL $$\n");
  try {
    require_gnuplot(system::plot_output.formats.front());
    FAIL();
  } catch (const PlotError& error) {
    EXPECT_THAT(error.what(), HasSubstr("gnuplot ended with exit status 137"));
    EXPECT_EQ(error.remedy(), "try it by hand: gnuplot --default-settings -e 'set terminal svg'");
  }
}

}  // namespace
}  // namespace twrench::plot
