#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <unistd.h>

#include "scratch_folder.h"
#include "system/file.h"
#include "system/output.h"

namespace twrench::system {
namespace {

namespace fs = std::filesystem;

/// A folder with the file `old`, links to it, and a link to a file that does not exist.
class FileListTest : public testing::Test {
 protected:
  FileListTest() {
    write_file_atomically(folder / "old", std::string_view("x"));
    write_file_atomically(folder / "other", std::string_view("x"));
    fs::create_symlink("old", folder / "link");
    fs::create_hard_link(folder / "old", folder / "hard");
    fs::create_directory(folder / "sub");
    fs::create_symlink("../new", folder / "sub/dangling");
    fs::create_symlink("sub", folder / "sub link");
  }

  static bool refuses_outputs(const fs::path& a, const fs::path& b) {
    FileList files;
    files.add_output(a);
    try {
      files.add_output(b);
    } catch (const OverwriteError&) {
      return true;
    }
    return false;
  }

  const ScratchFolder folder;
};

TEST_F(FileListTest, AnInputIsNoOutput) {
  for (const char* name : {"old", "link", "hard", "./old", "sub/../old", "sub link/../link"}) {
    FileList reading, writing;
    reading.add_input(folder / "old");
    EXPECT_THROW(reading.add_output(folder / name), OverwriteError) << name;
    writing.add_output(folder / name);
    EXPECT_THROW(writing.add_input(folder / "old"), OverwriteError) << name;
  }
  FileList files;
  files.add_input(folder / "old");
  files.add_input(folder / "link");
  files.add_input(folder / "none");
  EXPECT_NO_THROW(files.add_output(folder / "other"));
  EXPECT_NO_THROW(files.add_output(folder / "new"));
  EXPECT_NO_THROW(files.add_output(folder / "none")) << "a name that is no file is no input";
}

TEST_F(FileListTest, TwoOutputsAreNotOneFile) {
  EXPECT_TRUE(refuses_outputs(folder / "old", folder / "old"));
  EXPECT_TRUE(refuses_outputs(folder / "old", folder / "link"));
  EXPECT_TRUE(refuses_outputs(folder / "hard", folder / "old"));
  EXPECT_TRUE(refuses_outputs(folder / "new", folder / "sub/../new")) << "neither is there yet";
  EXPECT_TRUE(refuses_outputs(folder / "new", folder / "sub/dangling"));
  EXPECT_TRUE(refuses_outputs(folder / "sub/dangling", folder / "sub link/dangling"));
  EXPECT_TRUE(refuses_outputs(folder / "sub/new", folder / "sub link/new"));
  EXPECT_FALSE(refuses_outputs(folder / "new", folder / "sub/new"));
  EXPECT_FALSE(refuses_outputs(folder / "old", folder / "new"));
  EXPECT_TRUE(refuses_outputs("not-there", "./not-there"));
  EXPECT_FALSE(refuses_outputs("", ""));
  EXPECT_FALSE(refuses_outputs("-", "-"));
  EXPECT_FALSE(refuses_outputs("/dev/null", "/dev/null"));
}

TEST_F(FileListTest, FilesOfAFolderAreOutputs) {
  const auto is_frame = [](const std::string& name) { return name.starts_with("frame"); };
  const auto with_folder = [&](const auto& add) {
    FileList before, after;
    add(before);
    EXPECT_THROW(before.add_outputs(folder / "sub", is_frame), OverwriteError);
    after.add_outputs(folder / "sub link", is_frame);
    EXPECT_THROW(add(after), OverwriteError);
  };
  write_file_atomically(folder / "sub/frame1", std::string_view("x"));
  fs::create_symlink("sub/frame1", folder / "to frame");
  with_folder([&](FileList& files) { files.add_output(folder / "sub/frame2"); });
  with_folder([&](FileList& files) { files.add_output(folder / "sub"); });
  with_folder([&](FileList& files) { files.add_input(folder / "sub/frame1"); });
  with_folder([&](FileList& files) { files.add_input(folder / "to frame"); });
  FileList files;
  files.add_outputs(folder / "sub", is_frame);
  EXPECT_NO_THROW(files.add_output(folder / "sub/film"));
  EXPECT_NO_THROW(files.add_output(folder / "frame1"));
}

TEST_F(FileListTest, AnExistingFileOfSomethingElseIsKept) {
  const auto add = [&](const char* name, bool overwrite) {
    FileList files(overwrite);
    return files.add_output(schema_output, folder / name);
  };
  write_file_atomically(folder / "notes.json", std::string_view("{\"title\": \"mine\"}"));
  write_file_atomically(folder / "schema.json",
                        std::string_view("{\n  \"title\": \"Scene file of twrench\"}"));
  write_file_atomically(folder / "empty.json", std::string_view());
  fs::create_symlink("notes.json", folder / "link.json");
  EXPECT_THROW(add("notes.json", false), ExistingFileError);
  EXPECT_THROW(add("link.json", false), ExistingFileError);
  EXPECT_THROW(add("old", false), ExistingFileError);
  for (const char* name : {"schema.json", "empty.json", "new.json", "new"}) {
    EXPECT_NO_THROW(add(name, false)) << name;
  }
  EXPECT_EQ(add("notes.json", true).path(), folder / "notes.json");
}

TEST_F(FileListTest, AnOutputHasAPlaceBeforeItIsComputed) {
  FileList files;
  EXPECT_NO_THROW(files.add_output(schema_output, folder / "none/a.json"));
  EXPECT_NO_THROW(files.add_output(schema_output, "/dev/null"));
  if (::geteuid() == 0) GTEST_SKIP() << "root may write to any folder";
  fs::permissions(folder / "sub", fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(files.add_output(schema_output, folder / "sub/a.json"), FileError);
  fs::permissions(folder / "sub", fs::perms::owner_all);
}

std::string format_name(const OutputKind& kind, const std::string& file,
                        const std::string& name = {}) {
  return std::string(format_of(kind, file, name).name);
}

TEST(OutputKind, TheFormatFollowsTheNameOfTheFile) {
  EXPECT_EQ(format_name(motion_output, "run.json"), "json");
  EXPECT_EQ(format_name(motion_output, "run.CSV"), "csv");
  EXPECT_EQ(format_name(motion_output, "run"), "csv");
  EXPECT_EQ(format_name(motion_output, "-"), "csv");
  EXPECT_EQ(format_name(motion_output, "-", "json"), "json");
  EXPECT_EQ(format_name(motion_output, "run", "json"), "json");
  EXPECT_EQ(format_name(report_output, "-"), "html");
  EXPECT_EQ(format_name(check_output, "a.b/junit.xml"), "junit");
  EXPECT_EQ(format_name(exported_motion, "-", "glb"), "glb");
}

TEST(OutputKind, RefusesOtherEndings) {
  for (const char* file : {"run.xlsx", "run.txt", "run.csv.gz", ".csv/run.toml"}) {
    EXPECT_THROW(format_of(motion_output, file), InvalidArgument) << file;
  }
  for (const char* file : {"plot.bmp", "svg", "a.svg.txt", "-", ".png/a", ".svg"}) {
    EXPECT_THROW(format_of(plot_output, file), InvalidArgument) << file;
  }
  try {
    format_of(plot_output, "a/.svg");
    ADD_FAILURE() << "no failure";
  } catch (const InvalidArgument& error) {
    EXPECT_EQ(error.remedy(), "name a file, such as out.svg");
  }
  EXPECT_THROW(format_of(motion_output, "run.csv", "json"), InvalidArgument);
  EXPECT_THROW(format_of(motion_output, "run", "xml"), InvalidArgument);
  EXPECT_THROW(format_of(exported_motion, "-"), InvalidArgument);
  EXPECT_THROW(format_of(exported_motion, "run"), InvalidArgument);
  EXPECT_THROW(format_of(report_output, "report"), InvalidArgument);
}

}  // namespace
}  // namespace twrench::system
