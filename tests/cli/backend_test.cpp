// Machines without one of the OpenGL backends, tested with the real program: the loader finds an
// empty file instead of the library and cannot load it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/twrench.h"
#include "system/file.h"

namespace twrench {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

/// Like run_twrench(), but without the backend from the environment: these tests choose it.
Outcome run(const ScratchFolder& folder, const std::string& arguments,
            const std::string& before = "") {
  return run_shell(folder, before + "\"$TWRENCH_BINARY\" " + arguments);
}

const std::string backend_run = "render --size 64x36 --no-video --frames 0 ";

std::string without(const ScratchFolder& folder, const std::vector<std::string>& libraries) {
  for (const std::string& library : libraries) {
    system::write_file_atomically(folder / library, std::string_view());
  }
  return "LD_LIBRARY_PATH='" + folder.path().string() + "' ";
}

const std::vector<std::string> osmesa{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
const std::vector<std::string> egl{"libEGL.so.1", "libEGL.so"};

TEST(Backend, WithoutOsmesaIsEgl) {
  const ScratchFolder folder;
  const std::string before = without(folder, osmesa);
  const Outcome done = run(folder, backend_run, before);
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.err, HasSubstr("drawing in software with EGL; OSMesa is not usable"));
  const Outcome asked = run(folder, backend_run + "--backend osmesa --overwrite", before);
  EXPECT_EQ(asked.code, 3);
  EXPECT_THAT(asked.err, HasSubstr("apt-get install libosmesa6"));
  EXPECT_THAT(asked.err, HasSubstr("--backend egl"));
  const Outcome doctor = run(folder, "doctor", before);
  EXPECT_EQ(doctor.code, 0) << doctor.out;
  EXPECT_THAT(doctor.out, ContainsRegex("OpenGL by osmesa +missing"));
  EXPECT_THAT(doctor.out, HasSubstr("not needed: OpenGL by egl"));
}

TEST(Backend, WithoutEglIsOsmesa) {
  const ScratchFolder folder;
  const std::string before = without(folder, egl);
  const Outcome done = run(folder, backend_run, before);
  if (done.code == 3) GTEST_SKIP() << "there is no OSMesa: " << done.err;
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.err, HasSubstr("drawing in software with OSMesa"));
  const Outcome asked = run(folder, backend_run + "--backend egl --overwrite", before);
  EXPECT_EQ(asked.code, 3);
  EXPECT_THAT(asked.err, HasSubstr("apt-get install libegl1"));
  const Outcome doctor = run(folder, "doctor", before);
  EXPECT_EQ(doctor.code, 0) << doctor.out;
  EXPECT_THAT(doctor.out, HasSubstr("apt-get install libegl1"));
  EXPECT_THAT(doctor.out, HasSubstr("not needed: OpenGL by osmesa"));
}

TEST(Backend, WithoutEitherIsAnErrorWithTheRemedy) {
  const ScratchFolder folder;
  const std::string before = without(folder, osmesa) + without(folder, egl);
  const Outcome done = run(folder, backend_run, before);
  EXPECT_EQ(done.code, 3);
  EXPECT_THAT(done.err, HasSubstr("no usable OpenGL"));
  EXPECT_THAT(done.err, HasSubstr("libegl1 libgl1-mesa-dri, or libosmesa6"));
  EXPECT_EQ(run(folder, "inertia", before).code, 0) << "what draws nothing needs none";
}

TEST(Backend, NamesTheDevicesThereAre) {
  const ScratchFolder folder;
  const Outcome done = run(folder, backend_run + "--egl-device 17");
  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("its devices: 0"));
}

}  // namespace
}  // namespace twrench
