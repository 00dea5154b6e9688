#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/twrench.h"

namespace twrench {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// NASA's files, whose moments and initial rates are known.
const std::string nasa_folder = TWRENCH_TESTS_DIR "/check/nasa/tumbling_brick_sim_";
const std::string brick = " --inertia 0.001894220,0.006211019,0.007194665 ";
const std::string brick_rates =
    " --columns t=time,wx=bodyAngularRateWrtEi_deg_s_Roll,wy=bodyAngularRateWrtEi_deg_s_Pitch,"
    "wz=bodyAngularRateWrtEi_deg_s_Yaw --units deg ";
const std::string from_10_20_30 =
    " --omega 0.17453292519943295,0.3490658503988659,0.5235987755982988 ";

/// Files that `simulate` writes into a separate folder.
class CheckCommand : public testing::Test {
 protected:
  /// Runs `simulate` for the body of `body` into the file.
  void simulate(const std::string& file, const std::string& options) const {
    const Outcome run =
        run_twrench(folder_, "simulate " + body + "--omega 0.4,1.5,0.3 --fps 10 --speed 1 " +
                                 options + " -o " + file);
    ASSERT_EQ(run.code, 0) << run.err;
  }
  Outcome check(const std::string& arguments) const {
    return run_twrench(folder_, "check " + arguments);
  }
  json judged(const std::string& arguments) const {
    const Outcome run = check(arguments + " --format json --no-fail");
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  }

  const ScratchFolder folder_;
  const std::string body = "--inertia 2,3,4 ";
};

/// "t,NAMES" and rows of these values at 0, 0.1, ...
std::string table(const std::string& names, const std::string& values, int rows) {
  std::string text = "t," + names + "\n";
  for (int i = 0; i < rows; ++i) text += fmt::format("{},{}\n", 0.1 * i, values);
  return text;
}

TEST_F(CheckCommand, TakesASceneFromAPipe) {
  simulate("a.csv", "--duration 5 --method exact");
  const Outcome run =
      run_shell(folder_,
                "printf '[body]\\nmoments = [2, 3, 4]\\n' | "
                "\"$TWRENCH\" check a.csv --scene /dev/stdin --plot p.svg -o report.txt");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(text_of(folder_ / "report.txt"), HasSubstr("has no detectable error"));
}

TEST_F(CheckCommand, RefusesRatesWhoseSquaresUnderflow) {
  system::write_file_atomically(folder_ / "tiny.csv", table("wx,wy,wz", "1e-300,1e-301,0", 9));
  const Outcome run = check("tiny.csv " + body);
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("tiny.csv:2: the rates have the magnitude 1e-300 "
                                 "rad/s, but must be zero or at least 1e-100"));
}

TEST_F(CheckCommand, FaultsMatricesThatAreNoRotations) {
  simulate("a.csv", "--duration 2 --method exact");
  std::istringstream rows(text_of(folder_ / "a.csv"));
  std::string scaled, row;
  std::getline(rows, row);
  scaled = row + "\n";
  while (std::getline(rows, row)) {
    std::istringstream cells(row);
    std::string cell;
    for (int i = 0; std::getline(cells, cell, ','); ++i) {
      const double value = std::stod(cell);
      scaled += fmt::format("{}{}", i == 0 ? "" : ",", i >= 1 && i <= 9 ? 3 * value : value);
    }
    scaled += "\n";
  }
  system::write_file_atomically(folder_ / "scaled.csv", scaled);
  EXPECT_THAT(judged("a.csv " + body)["verdict"].get<std::string>(),
              StartsWith("has no detectable error"));
  EXPECT_THAT(judged("scaled.csv " + body)["verdict"].get<std::string>(),
              AllOf(StartsWith("its matrices are not rotations: X^T X differs from the identity by "
                               "up to 13.9; apart from that, it is off by at most"),
                    HasSubstr("within the resolution of its digits")));
}

TEST_F(CheckCommand, HasARemedyForABodyAtRestThatHelps) {
  system::write_file_atomically(folder_ / "rest.csv", table("qw,qx,qy,qz", "1,0,0,0", 9));
  system::write_file_atomically(folder_ / "one.csv", table("qw,qx,qy,qz", "1,0,0,0", 1));
  const Outcome fitted = check("rest.csv --fit " + body);
  EXPECT_EQ(fitted.code, 2);
  EXPECT_THAT(fitted.err, HasSubstr("give --omega 0,0,0 without --fit"));
  EXPECT_THAT(check("rest.csv --omega 0,0,0 " + body).out, HasSubstr("at rest, and stays so"));
  EXPECT_THAT(check("one.csv --fit " + body).err,
              AllOf(HasSubstr("only one row"), HasSubstr("judge a file of several rows")));
}

TEST_F(CheckCommand, AdvisesNoStepsThatWereGiven) {
  simulate("a.csv", "--duration 2");
  EXPECT_THAT(check("a.csv a.csv " + body).out, HasSubstr("give their step sizes with --steps"));
  EXPECT_THAT(check("a.csv a.csv --steps 0.1,0.1 " + body).out,
              HasSubstr("order: the step sizes that --steps gives are the same"));
}

TEST_F(CheckCommand, CannotFaultTheSimulatorThatIsRight) {
  const json found = judged(nasa_folder + "01.csv" + brick + brick_rates + from_10_20_30);
  EXPECT_EQ(found["rows"], 301);
  EXPECT_EQ(found["rates"]["unit"], "deg/s");
  EXPECT_NEAR(found["rates"]["max_error"].get<double>(), 3.59e-10, 0.01e-10);
  EXPECT_TRUE(found["conditioning"]["within_digits"]);
  EXPECT_THAT(found["verdict"].get<std::string>(), StartsWith("has no detectable error"));
  EXPECT_TRUE(found["attitude"].is_null());
  EXPECT_TRUE(found["orthogonality_error"].is_null());
  EXPECT_FALSE(found["flips"].empty());
}

TEST_F(CheckCommand, FaultsTheSimulatorThatIsNot) {
  const json found = judged(nasa_folder + "05.csv" + brick + brick_rates + from_10_20_30);
  EXPECT_NEAR(found["rates"]["max_error"].get<double>(), 5.8e-5, 0.2e-5);
  EXPECT_FALSE(found["conditioning"]["within_digits"]);
  EXPECT_THAT(found["verdict"].get<std::string>(),
              AllOf(StartsWith("off by up to 5."), HasSubstr("mostly phase")));
  // Its times are of single precision.
  EXPECT_GT(found["conditioning"]["time_digit"].get<double>(), 1e-7);
}

TEST_F(CheckCommand, TakesTheBodyAndTheRatesOfAPublishedCase) {
  const std::string file = nasa_folder + "01.csv" + brick_rates;
  const json by_case = judged(file + "--case nasa-tumbling-brick");
  EXPECT_EQ(by_case, judged(file + brick + from_10_20_30));
  EXPECT_THAT(by_case["verdict"].get<std::string>(), StartsWith("has no detectable error"));
  ASSERT_EQ(run_twrench(folder_, "cases gazebo-box --format csv -o box.csv").code, 0);
  EXPECT_THAT(judged("box.csv --case gazebo-box")["verdict"].get<std::string>(),
              StartsWith("has no detectable error"));
}

// The rates are those of the case and not of the first row, which may be another state.
TEST_F(CheckCommand, FaultsAFileThatDoesNotStartAsThePublishedCase) {
  simulate("a.csv", "--duration 5 --method exact");
  EXPECT_THAT(judged("a.csv --case basilisk-spacecraft")["verdict"].get<std::string>(),
              Not(StartsWith("has no detectable error")));
}

TEST_F(CheckCommand, RefusesACaseBesideAnotherBodyOrAnUnknownOne) {
  simulate("a.csv", "--duration 1");
  for (const std::string& option :
       {std::string("--inertia 2,3,4"), std::string("--scene dzhanibekov"),
        std::string("--omega 1,2,3")}) {
    const Outcome run = check("a.csv --case gazebo-box -o report.txt " + option);
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.err, "twrench: error: --case: it gives the body and the initial rates, and " +
                           option.substr(0, option.find(' ')) +
                           " does too\n  leave out one of them\n");
  }
  const Outcome unknown = check("a.csv --case gazebo-bx -o report.txt");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, AllOf(StartsWith("twrench: error: --case: unknown name 'gazebo-bx'\n"),
                                 HasSubstr("did you mean 'gazebo-box'?")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "report.txt"));
}

TEST_F(CheckCommand, SeesThatTheAttitudeIsAgainstTheEarth) {
  const Outcome run = check(nasa_folder + "01.csv" + brick);
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("attitude and rates are inconsistent"), HasSubstr("the Earth's rate"),
                    HasSubstr("the rates have no detectable error")));
}

TEST_F(CheckCommand, HasTheKeysOfTheContract) {
  simulate("exact.csv", "--method exact --duration 40");
  const json found = judged("exact.csv " + body);
  for (const char* key : {"rows", "rates", "attitude", "energy_drift", "momentum_drift",
                          "orthogonality_error", "flips", "condition", "verdict"}) {
    EXPECT_TRUE(found.contains(key)) << key;
  }
  for (const char* key : {"unit", "max_error", "max_error_at", "rms_error"}) {
    EXPECT_TRUE(found["rates"].contains(key) && found["attitude"].contains(key)) << key;
  }
  EXPECT_EQ(found["rows"], 401);
  EXPECT_EQ(found["attitude"]["unit"], "deg");
  EXPECT_THAT(found["verdict"].get<std::string>(), StartsWith("has no detectable error"));
  for (const json& flip : found["flips"]) {
    EXPECT_NEAR(flip["t"].get<double>(), flip["exact"].get<double>(), 1e-9);
  }
}

TEST_F(CheckCommand, SeesTheOrderOfAMethod) {
  for (const auto& [method, order] : {std::pair("rkmk4", 4.0), {"rk4", 2.0}}) {
    std::string files, steps;
    for (const char* step : {"0.1", "0.05", "0.025"}) {
      const std::string file = fmt::format("{}-{}.csv ", method, step);
      simulate(file, fmt::format("--method {} --step {} --duration 5", method, step));
      files += file;
      steps += (steps.empty() ? "" : ",") + std::string(step);
    }
    const json found = judged(files + body + "--steps " + steps);
    EXPECT_EQ(found["files"].size(), 3U);
    EXPECT_NEAR(found["order"]["rates"].get<double>(), order, 0.2) << method;
    EXPECT_NEAR(found["order"]["attitude"].get<double>(), order, 0.2) << method;
    // The rows are equally far apart in all files.
    EXPECT_THAT(check(files + body).out, HasSubstr("give their step sizes with --steps"));
  }
}

TEST_F(CheckCommand, BoundsDecideTheExitCode) {
  simulate("rk4.csv", "--method rk4 --step 0.1 --duration 20");
  const json found = judged("rk4.csv " + body);
  const double rate = found["rates"]["max_error"], attitude = found["attitude"]["max_error"],
               drift = found["energy_drift"];
  for (const auto& [option, value] : {std::pair("--max-rate-error", rate),
                                      {"--max-attitude-error", attitude},
                                      {"--max-energy-drift", drift}}) {
    const auto bounded = [&](double bound) {
      return check(fmt::format("rk4.csv {} {} {:.17g}", body, option, bound));
    };
    EXPECT_EQ(bounded(value).code, 0) << option;
    const Outcome over = bounded(0.999 * value);
    EXPECT_EQ(over.code, 1) << option;
    EXPECT_THAT(over.err, HasSubstr(option));
    EXPECT_THAT(over.out, HasSubstr("exceeded"));
  }
}

TEST_F(CheckCommand, ABoundForWhatIsNotThereIsRefused) {
  const Outcome run =
      check(nasa_folder + "01.csv" + brick + brick_rates + "--max-attitude-error 1");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("has no attitude"));
}

TEST_F(CheckCommand, ReportsAsJUnit) {
  simulate("'a&b.csv'", "--method rk4 --step 0.1 --duration 20");
  const Outcome run = check("'a&b.csv' " + body +
                            "--max-rate-error 1e-9 --max-energy-drift 1 --format junit -o r.xml");
  EXPECT_EQ(run.code, 1);
  const std::string xml = text_of(folder_ / "r.xml");
  EXPECT_THAT(xml, StartsWith("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites "));
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"a&amp;b.csv\" tests=\"2\" failures=\"1\""));
  EXPECT_THAT(xml, HasSubstr("<failure type=\"exceeded\" message="));
  EXPECT_THAT(xml, HasSubstr("name=\"max-energy-drift 1\"/>"));
  // Another program finds it well-formed.
  EXPECT_EQ(run_shell(folder_,
                      "python3 -c \"import xml.dom.minidom as x; "
                      "d = x.parse('r.xml'); assert len(d.getElementsByTagName("
                      "'testcase')) == 2\"")
                .code,
            0);
}

TEST_F(CheckCommand, ProposesTheOnlyReadingThatFits) {
  simulate("radians.csv", "--method exact --duration 8");
  const Outcome degrees = check("radians.csv " + body + "--units deg");
  EXPECT_EQ(degrees.code, 1) << degrees.err;
  EXPECT_THAT(degrees.out, HasSubstr("but it does if the rates are in rad/s: use --units rad"));
  EXPECT_EQ(check("radians.csv " + body + "--units deg --no-fail").code, 0);
  EXPECT_THAT(check("radians.csv " + body + "--inverse").out,
              HasSubstr("if the attitude is space from body: leave --inverse out"));
  EXPECT_THAT(check("radians.csv --inertia 3,2,4").out,
              HasSubstr("if the moments have another order: use --inertia 2,3,4 (or --axes "));
  EXPECT_THAT(check("radians.csv " + body + "--rates space").out,
              HasSubstr("if the rates are in the body's axes: use --rates body"));
  EXPECT_THAT(check("radians.csv " + body + "--offset 0.8,0.6,0,0").out,
              HasSubstr("if the attitude is the body's own: leave --offset out"));
  EXPECT_THAT(
      check("radians.csv " + body + "--offset 0.8,0.6,0,0 --inverse --units deg").out,
      HasSubstr("the rates are in rad/s and the attitude is space from body and the attitude "
                "is the body's own: use --units rad, without --inverse and --offset"));
}

/// Python that prints the rows of `simulate` through stdin, with x the 9 numbers of X, w the rates.
std::string rewritten(const std::string& header, const std::string& line) {
  return "python3 -c \"import random, sys\nr = random.Random(1)\nprint('" + header +
         "')\nfor n in list(sys.stdin)[1:]:\n  n = [float(v) for v in n.split(',')]\n"
         "  t, x, w = n[0], n[1:10], n[10:13]\n  print(" +
         line + ", sep=',')\"";
}

TEST_F(CheckCommand, NamesAMistakeForWhatItIs) {
  simulate("e.csv", "--method exact --duration 40");
  const std::pair<std::string, std::string> cases[] = {
      // The same rates for ever; and rates in space without an attitude.
      {rewritten("t,wx,wy,wz", "t, 0.4, 1.5, 0.3"), "the gyroscopic term"},
      {rewritten("t,wx,wy,wz", "t, *[sum(x[3*i+j]*w[j] for j in range(3)) for i in range(3)]"),
       "without an attitude, rates in space axes cannot be recognised"},
  };
  for (const auto& [command, part] : cases) {
    ASSERT_EQ(run_shell(folder_, command + " < e.csv > wrong.csv").code, 0);
    EXPECT_THAT(check("wrong.csv " + body).out, HasSubstr(part));
  }
}

TEST_F(CheckCommand, AsksForAnOptionWhereNamesAreAmbiguous) {
  ASSERT_EQ(
      run_shell(folder_, "\"$TWRENCH\" simulate " + body +
                             "--omega 0.4,1.5,0.3 --fps 10 --duration 20 --method exact | "
                             "python3 -c \"import sys\n"
                             "for i, line in enumerate(sys.stdin):\n"
                             "  n = line.split(',')\n"
                             "  if i == 0: print('t,q0,q1,q2,q3'); continue\n"
                             "  x = [float(v) for v in n[1:10]]\n"
                             "  k = [1 + x[0] + x[4] + x[8], x[7] - x[5], x[2] - x[6], x[3] - "
                             "x[1]]\n"
                             "  s = sum(v * v for v in k) ** .5\n"
                             "  k = [v / s for v in k]\n"
                             "  print(n[0], k[1], k[2], k[3], k[0], sep=',')\" > q.csv")
          .code,
      0);
  const Outcome run = check("q.csv " + body + "--omega 0.4,1.5,0.3");
  EXPECT_EQ(run.code, 2) << run.out;
  EXPECT_THAT(run.err, HasSubstr("these quaternions fit as xyzw, space from body: add --columns"));
}

TEST_F(CheckCommand, AsksForTheRatesOfTwoThatAreThere) {
  simulate("e.csv", "--method exact --duration 5");
  const std::string attitude = "x11,x12,x13,x21,x22,x23,x31,x32,x33";
  const std::string command =
      rewritten("t," + attitude + ",w_body_x,w_body_y,w_body_z,w_world_x,w_world_y,w_world_z",
                "t, *x, *w, *[sum(x[3*i+j]*w[j] for j in range(3)) for i in range(3)]");
  ASSERT_EQ(run_shell(folder_, command + " < e.csv > both.csv").code, 0);
  const Outcome run = check("both.csv " + body);
  EXPECT_EQ(run.code, 2) << run.out;
  EXPECT_THAT(run.err, HasSubstr("its columns can be read in 2 ways\n  say which: --columns "));
  const std::string before = "; or ", advice = run.err.substr(run.err.find(before) + before.size());
  EXPECT_THAT(advice, HasSubstr("wx=w_world_x,"));
  EXPECT_THAT(advice, testing::EndsWith("' --rates space\n"));
  const Outcome followed = check("both.csv " + body + advice.substr(0, advice.size() - 1));
  EXPECT_EQ(followed.code, 0) << followed.out << followed.err;
}

TEST_F(CheckCommand, FitsAnInitialState) {
  simulate("exact.csv", "--method exact --duration 40");
  const json found = judged("exact.csv --fit " + body);
  EXPECT_EQ(found["fit"]["rows"], 401);
  EXPECT_NEAR(found["omega"][1].get<double>(), 1.5, 1e-12);
  EXPECT_LT(found["fit"]["omega_deviation"][1].get<double>(), 1e-13);
  EXPECT_EQ(found["fit"]["omega_covariance"].size(), 3U);
}

TEST_F(CheckCommand, JudgesAPartOfTheRows) {
  simulate("exact.csv", "--method exact --duration 40");
  const json found = judged("exact.csv --from 10 --to 20 " + body);
  EXPECT_EQ(found["rows"], 101);
  EXPECT_NEAR(found["first_time"].get<double>(), 10, 1e-12);
  EXPECT_LT(found["rates"]["max_error"].get<double>(), 1e-12);
  const Outcome none = check("exact.csv --from 50 --to 60 " + body);
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("no row is from 50 to 60 s after the first"));
}

TEST_F(CheckCommand, FitsTheRatiosOfTheMoments) {
  simulate("exact.csv", "--method exact --duration 40");
  for (const char* order : {"exact.csv --fit inertia", "--fit inertia exact.csv"}) {
    const json found = judged(order);
    EXPECT_NEAR(found["inertia"]["moments"][1].get<double>(), 1.5, 1e-9);
    EXPECT_NEAR(found["inertia"]["moments"][2].get<double>(), 2, 1e-9);
    EXPECT_LT(found["inertia"]["deviations"][2].get<double>(), 1e-9);
    EXPECT_EQ(found["finding"], "exact");
  }
  EXPECT_THAT(
      check("exact.csv --fit inertia").out,
      AllOf(HasSubstr("1 : 1.5 +- "), HasSubstr("do not determine their size; --inertia ")));
  EXPECT_THAT(check("exact.csv --fit inertia " + body).err,
              HasSubstr("--fit inertia: it finds the body, and --inertia gives one"));
  EXPECT_EQ(check("exact.csv --fit=moments").code, 2);
}

TEST_F(CheckCommand, TakesTheBodyOfAScene) {
  ASSERT_EQ(run_twrench(folder_, "simulate dzhanibekov --duration 30 --method exact -o s.csv").code,
            0);
  EXPECT_THAT(check("s.csv --scene dzhanibekov").out, HasSubstr("has no detectable error"));
  EXPECT_EQ(check("s.csv --scene dzhanibekov --inertia 1,2,3").code, 2);
}

TEST_F(CheckCommand, SeesThatAFileBeginsOtherwise) {
  simulate("exact.csv", "--method exact --duration 40");
  for (const char* told : {"-0.4,1.5,0.3", "0.4,1.50001,0.3", "0,0,0"}) {
    EXPECT_THAT(check(fmt::format("exact.csv {} --omega {}", body, told)).out,
                AllOf(HasSubstr("starts from another state: its first row is already off by"),
                      HasSubstr("--fit finds 0.4,1.5,0.3 rad/s at 0 s")))
        << told;
  }
  EXPECT_THAT(check("exact.csv --omega 0.4,1.5,0.3 " + body).out,
              HasSubstr("has no detectable error"));
  EXPECT_THAT(
      check("exact.csv --inertia 2,3.3,4").out,
      HasSubstr("follows the motion of another body: the principal moments fit in the ratio "
                "1 : 1.5 : 2, but those given are in the ratio 1 : 1.65 : 2"));
}

TEST_F(CheckCommand, SaysWhatIsMissingOrWrong) {
  simulate("e.csv", "--method exact --duration 2");
  const std::pair<std::string, std::string> cases[] = {
      {"e.csv", "give its principal moments with --inertia"},
      {"e.csv --inertia 1,2", "--inertia"},
      {"e.csv --inertia 0,2,3", "--inertia"},
      {"e.csv --inertia 2,3,4,0,0", "--inertia: '2,3,4,0,0' is not three or six numbers"},
      {"e.csv --inertia 2,2,4,3,0,0", "its principal moments are -1, 4 and 5"},
      {"e.csv --inertia 1,-2,3", "--inertia"},
      {"e.csv --inertia nan,2,3", "--inertia"},
      {"e.csv --inertia 2,3,4 --columns t=time", "time"},
      {"e.csv --inertia 2,3,4 --columns t=t,qw=x11", "given for qw, but not for qx"},
      {"e.csv --inertia 2,3,4 --units grad", "--units"},
      {"e.csv --inertia 2,3,4 --time-unit days", "--time-unit"},
      {"e.csv --inertia 2,3,4 --angle-units rpm", "--angle-units"},
      {"e.csv --inertia 2,3,4 --axes x,y", "such as x,-z,y"},
      {"e.csv --inertia 2,3,4 --axes x,y,-x", "such as x,-z,y"},
      {"e.csv --inertia 2,3,4 --axes x,y,z,x", "such as x,-z,y"},
      {"e.csv --inertia 2,3,4 --offset 1,0,0", "four of a quaternion"},
      {"e.csv --inertia 2,3,4 --offset 2,0,0,0", "has the length 2"},
      {"e.csv --inertia 2,3,4 --sequence xyw", "--sequence"},
      {"e.csv --inertia 2,3,4 --frame last", "--frame"},
      {"e.csv --inertia 2,3,4 --omega 1,2,3 --omega-at last", "--omega-at"},
      {"e.csv --inertia 2,3,4 --steps 0.1,0.2", "--steps"},
      {"e.csv --inertia 2,3,4 --max-rate-error -1", "--max-rate-error"},
      {"e.csv --inertia 2,3,4 -o e.csv", "e.csv"},
      {"e.csv --inertia 2,3,4 --plot e.txt", ".svg"},
  };
  for (const auto& [arguments, part] : cases) {
    const Outcome run = check(arguments);
    EXPECT_EQ(run.code, 2) << arguments << run.err;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_THAT(run.err, AllOf(StartsWith("twrench: error: "), HasSubstr(part))) << arguments;
  }
  EXPECT_EQ(check("missing.csv --inertia 2,3,4").code, 5);
  EXPECT_THAT(check("e.csv --inertia 2,3,9").err, HasSubstr("no real body has them"));
}

TEST_F(CheckCommand, FitsTheStateToAttitudesAlone) {
  simulate("e.csv", "--method exact --duration 20");
  ASSERT_EQ(run_shell(folder_, "cut -d, -f1-10 e.csv > x.csv").code, 0);
  const Outcome run = check("x.csv " + body);
  EXPECT_THAT(run.out, AllOf(HasSubstr("has no detectable error"), HasSubstr("fit")));
  EXPECT_EQ(run.out, check("x.csv --fit " + body).out);
  EXPECT_THAT(check("x.csv --inverse " + body).out,
              HasSubstr("if the attitude is space from body: leave --inverse out"));
}

TEST_F(CheckCommand, NamesTheConventionThatFits) {
  simulate("e.csv", "--method rkmk4 --step 0.1 --duration 40");
  const std::pair<std::string, std::string> cases[] = {
      {"1e3 * t, *w", "if t is in ms: use --time-unit ms"},
      {"1e6 * t, *w", "if t is in us: use --time-unit us"},
      {"t / 60, *w", "if t is in min: use --time-unit min"},
      {"t, *[v * 180 / 3.141592653589793 for v in w]",
       "if the rates are in deg/s: use --units deg"},
      {"t, *[v * 30 / 3.141592653589793 for v in w]", "if the rates are in rpm: use --units rpm"},
      {"t, *[v / 2 / 3.141592653589793 for v in w]", "if the rates are in rev/s: use --units rev"},
      {"t, w[0], w[2], w[1]", "if its axes are the body's x,z,y: use --axes x,z,y"},
      {"t, -w[0], w[1], w[2]", "if its axes are the body's -x,y,z: use --axes -x,y,z"},
      {"1e3 * t, *[v * 180 / 3.141592653589793 for v in w]",
       "if t is in ms and the rates are in deg/s: use --time-unit ms --units deg"}};
  for (const auto& [line, part] : cases) {
    ASSERT_EQ(run_shell(folder_, rewritten("t,wx,wy,wz", line) + " < e.csv > w.csv").code, 0);
    const Outcome run = check("w.csv " + body);
    EXPECT_EQ(run.code, 1) << line << run.err;
    EXPECT_THAT(run.out, HasSubstr(part)) << line;
    const std::string options = part.substr(part.find("use ") + 4);
    const json corrected = judged("w.csv " + body + options);
    EXPECT_EQ(corrected["finding"], "integration") << line;
    EXPECT_TRUE(corrected["alternatives"].empty()) << line;
  }
}

TEST_F(CheckCommand, KnowsNoiseFromErrors) {
  simulate("e.csv", "--method exact --duration 40");
  ASSERT_EQ(run_shell(folder_, rewritten("t,wx,wy,wz", "t, *[v + r.gauss(0, 1e-3) for v in w]") +
                                   " < e.csv > noisy.csv")
                .code,
            0);
  const Outcome run = check("noisy.csv " + body);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("follows the exact motion within its noise"),
                             HasSubstr("use --fit")));
  EXPECT_NEAR(judged("noisy.csv " + body)["noise"]["rates"].get<double>(), 1e-3, 1e-4);
  const Outcome fitted = check("noisy.csv --fit " + body);
  EXPECT_EQ(fitted.code, 0) << fitted.out;
  EXPECT_THAT(fitted.out, Not(HasSubstr("use --fit")));
  // Rounding errors of a simulator may be noise that is smaller than the last digit.
  simulate("rounded.csv", "--method rkmk4 --step 0.001 --duration 10");
  EXPECT_THAT(check("rounded.csv " + body).out, Not(HasSubstr(",  rms")));
  // An error of a method is no noise.
  simulate("rough.csv", "--method rkmk4 --step 0.5 --duration 40");
  EXPECT_EQ(judged("rough.csv " + body)["finding"], "integration");
}

TEST_F(CheckCommand, ReportsTheRowAtWhichTheUnitChanges) {
  simulate("e.csv", "--method exact --duration 10");
  const std::pair<std::string, std::string> cases[] = {
      {"t, *[v * (57.29577951308232 if t > 4.95 else 1) for v in w]",
       "mixed.csv:52: from this row on, the angular momentum is 57.3 times"},
      {"t if t < 4.95 else 1e3 * t, *w",
       "mixed.csv:52: from this row on, the time between rows is 1000 times"}};
  for (const auto& [line, part] : cases) {
    ASSERT_EQ(run_shell(folder_, rewritten("t,wx,wy,wz", line) + " < e.csv > mixed.csv").code, 0);
    const Outcome run = check("mixed.csv " + body + "-o report.txt");
    EXPECT_EQ(run.code, 2) << run.out;
    EXPECT_THAT(run.err, HasSubstr(part));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "report.txt"));
  }
}

TEST_F(CheckCommand, JudgesWhatHasNoFlipsOrOneRow) {
  for (const char* inertia : {"2,2,2", "2,2,3", "2,3,4"}) {
    ASSERT_EQ(run_twrench(folder_, fmt::format("simulate --inertia {} --omega 0,0,1 --duration 5 "
                                               "--method exact -o n.csv",
                                               inertia))
                  .code,
              0);
    const Outcome run = check(fmt::format("n.csv --inertia {}", inertia));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, AllOf(HasSubstr("none: the exact motion is steady"),
                               HasSubstr("has no detectable error"), Not(HasSubstr("nan"))));
  }
  ASSERT_EQ(run_shell(folder_, "head -2 n.csv > one.csv").code, 0);
  const Outcome one = check("one.csv --inertia 2,3,4");
  EXPECT_EQ(one.code, 2);
  EXPECT_THAT(
      one.err,
      HasSubstr("has 1 row, too few to determine a motion\n  judge a file of several rows"));
  // With the state at another time, it tells something.
  ASSERT_EQ(run_shell(folder_, "tail -1 n.csv > rows && (head -1 n.csv; cat rows) > last.csv").code,
            0);
  EXPECT_THAT(check("last.csv --inertia 2,3,4 --omega 0,0,1").out,
              HasSubstr("has no detectable error"));
}

TEST_F(CheckCommand, SaysWhereDigitsAreTooFewToTell) {
  ASSERT_EQ(run_shell(folder_,
                      "printf 't,wx,wy,wz\\n0,1,2,3\\n0.1,1,2,3\\n' > two.csv; "
                      "printf '0.2,1,2,3\\n' | cat two.csv - > few.csv")
                .code,
            0);
  EXPECT_THAT(check("two.csv " + body).err, HasSubstr("has 2 rows, too few to determine a motion"));
  EXPECT_EQ(check("two.csv " + body).code, 2);
  EXPECT_THAT(check("few.csv " + body).out,
              AllOf(HasSubstr("has no detectable error"), HasSubstr("almost any motion would be")));
}

TEST_F(CheckCommand, PlotsErrorsAgainstTime) {
  simulate("rk4.csv", "--method rk4 --step 0.1 --duration 20");
  const Outcome run = check("rk4.csv " + body + "--plot e.svg -o e.txt");
  EXPECT_EQ(run.code, 1) << run.err;
  const std::string svg = text_of(folder_ / "e.svg");
  EXPECT_THAT(svg, AllOf(HasSubstr("Attitude"), HasSubstr("resolution limit of the digits")));
  EXPECT_EQ(run_twrench(folder_, "check rk4.csv " + body + "--plot f.svg", "PATH=/nowhere ").code,
            4);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "f.svg"));
}

}  // namespace
}  // namespace twrench
