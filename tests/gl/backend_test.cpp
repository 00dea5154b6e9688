#include "gl/backend.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/error.h"
#include "gl/functions.h"

namespace twrench::gl {
namespace {

using testing::HasSubstr;

bool usable(const std::string& name) {
  const auto reports = backends();
  return std::ranges::any_of(reports, [&](const BackendReport& report) {
    return report.name == name && !report.renderer.empty();
  });
}

TEST(Backend, ReportsARendererOrAReasonForEach) {
  const auto reports = backends();
  ASSERT_GE(reports.size(), 2u);
  EXPECT_EQ(reports[0].name, "osmesa");
  EXPECT_EQ(reports[1].name.substr(0, 3), "egl");
  for (const BackendReport& report : reports) {
    EXPECT_NE(report.renderer.empty(), report.failure == nullptr) << report.name;
  }
}

TEST(Backend, IsTheOneAskedFor) {
  if (usable("osmesa")) {
    EXPECT_EQ(open_context({Backend::osmesa, {}}).context->backend(), "osmesa");
  }
  const OpenedContext egl = open_context({Backend::egl, "software"});
  EXPECT_EQ(egl.context->backend(), "egl");
  EXPECT_EQ(egl.note, "");
}

TEST(Backend, ADeviceOfEglMeansEgl) {
  EXPECT_EQ(open_context({Backend::automatic, "software"}).context->backend(), "egl");
  EXPECT_THROW(open_context({Backend::osmesa, "software"}), UsageError);
}

TEST(Backend, SaysWhatItFellBackTo) {
  for (const Backend backend : {Backend::automatic, Backend::egl}) {
    const OpenedContext opened = open_context({backend, {}});
    const std::string renderer = renderer_string(Functions(*opened.context));
    const bool software = renderer.find("llvmpipe") != std::string::npos;
    EXPECT_EQ(software, !opened.note.empty()) << renderer;
    if (software) {
      EXPECT_THAT(opened.note, HasSubstr(opened.context->backend() == "egl" ? "EGL" : "OSMesa"));
    }
  }
}

TEST(EglContext, ListsItsDevicesWhereThereIsNoneOfTheName) {
  try {
    make_egl_context("17");
    FAIL() << "no exception";
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "EGL device 17: EGL has no device of that name");
    EXPECT_THAT(error.remedy(), HasSubstr("its devices: 0"));
  }
}

TEST(EglContext, OpensEachDeviceThatItLists) {
  for (const EglDevice& device : egl_devices()) {
    if (!usable("egl " + device.name)) continue;
    const auto context = make_egl_context(device.name);
    EXPECT_NE(renderer_string(Functions(*context)), "") << device.name;
  }
}

// EGL has one display per device: destroying one context must not terminate the other.
TEST(EglContext, OutlivesAnotherOnTheSameDevice) {
  auto first = make_egl_context("software");
  const auto second = make_egl_context("software");
  first.reset();
  EXPECT_NE(renderer_string(Functions(*second)), "");
}

}  // namespace
}  // namespace twrench::gl
