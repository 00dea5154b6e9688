// The files that `cmake --install` installs for each component, and the metadata of the components'
// Debian packages. scripts/maintain/try_packages.sh installs the packages themselves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "architecture/markdown.h"
#include "run_command.h"
#include "scratch_folder.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsSupersetOf;

/// The paths of all files below a folder, relative to it.
std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) files.insert(entry.path().lexically_relative(folder).string());
  }
  return files;
}

std::set<std::string> installed(const ScratchFolder& scratch, const std::string& component) {
  run_command("'" TWRENCH_CMAKE "' --install '" TWRENCH_BUILD "' --component " + component +
              " --prefix '" + scratch.path().string() + "' >/dev/null");
  return files_below(scratch.path());
}

/// The first group of each match of `pattern` in the C++ sources of `folder`.
std::set<std::string> found_in_sources(const std::string& folder, const std::string& pattern) {
  const std::regex expression(pattern);
  std::set<std::string> found;
  for (const std::string& file : files_below(project_folder() / folder)) {
    if (!file.ends_with(".cpp")) continue;
    const std::string text = file_text(project_folder() / folder / file);
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end;
         ++match) {
      found.insert((*match)[1].str());
    }
  }
  return found;
}

/// The value of cpack's `variable`.
std::string package_setting(const std::string& variable) {
  const std::string settings = file_text(fs::path(TWRENCH_BUILD) / "CPackConfig.cmake");
  const std::regex line("set\\(" + variable + " \"([^\"]*)\"\\)");
  std::smatch match;
  return std::regex_search(settings, match, line) ? match[1].str() : "";
}

TEST(Packaging, TheProgramComesWithItsManualCompletionsScenesAndLicences) {
  const ScratchFolder scratch;
  std::set<std::string> files = installed(scratch, "program");
  EXPECT_THAT(
      files,
      IsSupersetOf({"bin/twrench", "share/doc/twrench/LICENSE", "share/doc/twrench/THIRD-PARTY.md",
                    "share/man/man1/twrench.1", "share/man/man1/twrench-render.1",
                    "share/man/man5/twrench-scene.5", "share/bash-completion/completions/twrench",
                    "share/zsh/vendor-completions/_twrench",
                    "share/fish/vendor_completions.d/twrench.fish"}));
  for (const std::string& scene : files_below(project_folder() / "assets/scenes")) {
    EXPECT_THAT(files, Contains("share/doc/twrench/examples/scenes/" + scene));
  }
  for (const std::string& file : files_below(project_folder() / "assets/cases")) {
    EXPECT_THAT(files, Contains("share/doc/twrench/examples/cases/" + file));
  }
  for (const std::string& file : files) EXPECT_THAT(file, ContainsRegex("^(bin/twrench$|share/)"));
}

TEST(Packaging, TheDevelopmentFilesAreTheHeadersTheLibraryAndWhatFindsThem) {
  const ScratchFolder scratch;
  std::set<std::string> expected{"include/twrench/version.h"};
  for (const std::string& header : files_below(project_folder() / "include")) {
    expected.insert("include/" + header);
  }
  const std::string lib = TWRENCH_LIBDIR "/";
  for (const char* file :
       {"libtwrench-dynamics.a", "pkgconfig/twrench.pc", "cmake/twrench/twrenchConfig.cmake",
        "cmake/twrench/twrenchTargets.cmake", "cmake/twrench/twrenchConfigVersion.cmake"}) {
    expected.insert(lib + file);
  }
  std::set<std::string> files = installed(scratch, "development");
  // The name of this file depends on the build type.
  EXPECT_EQ(std::erase_if(files,
                          [](const std::string& file) {
                            return file.find("/twrenchTargets-") != std::string::npos;
                          }),
            1U);
  EXPECT_EQ(files, expected);
}

// The remedies name the packages of the libraries and programs that the program loads or starts.
TEST(Packaging, TheProgramDependsOnWhatItsRemediesInstall) {
  const std::set<std::string> remedies =
      found_in_sources("src", "apt-get install ([a-z0-9-]+(?:,? lib[a-z0-9-]+)*)");
  ASSERT_THAT(remedies, testing::SizeIs(testing::Ge(3U)));
  const std::string needed = package_setting("CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS") + ", " +
                             package_setting("CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS");
  for (const std::string& packages : remedies) {
    const std::regex name("[a-z0-9-]+");
    for (std::sregex_iterator match(packages.begin(), packages.end(), name), end; match != end;
         ++match) {
      EXPECT_THAT(needed, ContainsRegex("(^| )" + match->str() + "(,| |$)"));
    }
  }
}

TEST(Packaging, TheProgramDependsOnEachLibraryItLoads) {
  const std::set<std::string> loaded = found_in_sources("src/gl", "\"lib([A-Za-z]+)\\.so[.0-9]*\"");
  ASSERT_THAT(loaded, testing::SizeIs(testing::Ge(2U)));
  const std::string depends = package_setting("CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS");
  for (std::string library : loaded) {
    std::ranges::transform(library, library.begin(),
                           [](unsigned char c) { return std::tolower(c); });
    EXPECT_THAT(depends, ContainsRegex("(^| )lib" + library + "[0-9]+(,| |$)"));
  }
}

TEST(Packaging, ThePackagesHaveTheVersionThatTheProgramPrints) {
  const ScratchFolder scratch;
  run_command("'" TWRENCH_BINARY "' --version >'" + (scratch / "version").string() + "'");
  EXPECT_THAT(file_text(scratch / "version"),
              testing::StartsWith("twrench " + package_setting("CPACK_PACKAGE_VERSION") + "\n"));
}

TEST(Packaging, TheCopyrightNamesAllWhoseWorkIsBuiltIn) {
  const std::string copyright = file_text(project_folder() / "packaging/copyright");
  const MarkdownRows rows = markdown_table(file_text(project_folder() / "THIRD-PARTY.md"), "what");
  ASSERT_FALSE(rows.empty());
  for (const auto& row : rows) {
    std::istringstream holders(row.at(1));
    for (std::string holder; std::getline(holders >> std::ws, holder, ';');) {
      EXPECT_THAT(copyright, HasSubstr(holder));
    }
    // Debian calls this wording of the MIT License by another name.
    const std::string licence = row.at(2).substr(0, row.at(2).find_first_of(",;"));
    EXPECT_THAT(copyright,
                HasSubstr("\nLicense: " + (licence == "MIT" ? "Expat" : licence) + "\n "));
  }
}

}  // namespace
}  // namespace twrench
