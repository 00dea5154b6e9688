#include "table/reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "scratch_folder.h"
#include "table/read_table.h"

namespace twrench::table {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

using Rows = std::vector<std::vector<double>>;

/// The rows of a pass, at most `most`.
Rows pass(Reader& reader, const std::vector<std::size_t>& columns, std::size_t most = 1'000'000) {
  reader.begin_pass(columns);
  Rows rows;
  std::vector<Number> numbers(columns.size());
  while (rows.size() < most && reader.next(numbers)) {
    std::vector<double>& row = rows.emplace_back();
    for (const Number& number : numbers) row.push_back(number.value);
  }
  return rows;
}

/// Three rows of three columns in every format.
std::vector<std::string> tables() {
  std::ifstream npy(TWRENCH_TESTS_DIR "/reference/numpy/f8.npy", std::ios::binary);
  std::ifstream by_columns(TWRENCH_TESTS_DIR "/reference/numpy/f8_fortran.npy", std::ios::binary);
  return {
      {std::istreambuf_iterator<char>(npy), {}},
      {std::istreambuf_iterator<char>(by_columns), {}},
      "0,1.5,-2.25\n0.1,2.5,1e-3\n0.2,3.5,7\n",
      "# of a gyroscope\n\nt,p,q\ns,deg/s,deg/s\n# first\n0,1.5,-2.25\n0.1,2.5,1e-3\n0.2,3.5,7",
      "\xEF\xBB\xBFt;p;q\r\n0;1,5;-2,25\r\n0,1;2,5;1e-3\r\n0,2;3,5;7\r\n",
      "  t    p   q\n  0  1.5 -2.25\n0.1  2.5  1e-3\n0.2  3.5  7\n",
      "t,p,q\n\"0\",1.5,-2.25\n0.1,\"2.5\",1e-3\n0.2,3.5,7\n",
      "[[0, 1.5, -2.25], [0.1, 2.5, 1e-3], [0.2, 3.5, 7]]",
      R"({"body": [1], "samples": [{"t": 0, "w": [1.5, -2.25]}, {"t": 0.1, "w": [2.5, 1e-3]},
          {"t": 0.2, "w": [3.5, 7]}]})",
      "\xEF\xBB\xBF{\"t\": 0, \"p\": 1.5, \"q\": -2.25}\n{\"t\": 0.1, \"p\": 2.5, \"q\": 1e-3}\n"
      "{\"t\": 0.2, \"p\": 3.5, \"q\": 7}\n",
  };
}

TEST(Reader, ReadsTheRowsAgain) {
  for (const std::string& bytes : tables()) {
    const auto reader = open_table("run", bytes);
    const auto all = ElementsAre(ElementsAre(0, 1.5, -2.25), ElementsAre(0.1, 2.5, 1e-3),
                                 ElementsAre(0.2, 3.5, 7));
    EXPECT_THAT(pass(*reader, {0, 1, 2}), all) << bytes;
    const std::string last = reader->place();
    EXPECT_THAT(pass(*reader, {2, 0}, 2),
                ElementsAre(ElementsAre(-2.25, 0), ElementsAre(1e-3, 0.1)))
        << bytes;
    EXPECT_THAT(pass(*reader, {0, 1, 2}), all) << bytes;
    EXPECT_EQ(reader->place(), last) << bytes;
  }
}

TEST(Reader, ReadsTheRowsOfALongFileAgain) {
  const ScratchFolder scratch;
  {
    std::ofstream file(scratch / "run.csv");
    file << "t,w\n";
    for (int i = 0; i < 100'000; ++i) file << i << ',' << -i << '\n';
  }
  const auto reader = open_table(scratch / "run.csv");
  const Rows once = pass(*reader, {0, 1});
  EXPECT_EQ(once.size(), 100'000U);
  pass(*reader, {1}, 70'000);
  EXPECT_EQ(pass(*reader, {0, 1}), once);
}

/// The error of a file that `change` changes before it is read.
std::string error_after(const std::string& text,
                        const std::function<void(const std::filesystem::path&)>& change) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "run.csv") << text;
  const auto reader = open_table(scratch / "run.csv");
  pass(*reader, {0, 1}, 10);
  change(scratch / "run.csv");
  try {
    pass(*reader, {0, 1});
  } catch (const system::FileError& error) {
    return std::string(error.what()) + " -- " + error.remedy();
  }
  return "no error";
}

TEST(Reader, DetectsThatAFileChanges) {
  std::string csv = "t,w\n", json = "[";
  for (int i = 0; i < 100'000; ++i) csv += std::to_string(i) + ",1\n";
  for (int i = 0; i < 100'000; ++i) json += (i > 0 ? ",[" : "[") + std::to_string(i) + ",1]\n";
  for (const std::string& text : {csv, json + "]"}) {
    const auto append = [](const auto& file) { std::ofstream(file, std::ios::app) << "100000,1"; };
    EXPECT_THAT(error_after(text, append),
                AllOf(HasSubstr("run.csv: it became longer while it was read -- wait until")));
    for (const std::size_t size : {text.size() - 3, text.size() / 2, std::size_t{0}}) {
      const auto cut = [&](const auto& file) { std::filesystem::resize_file(file, size); };
      EXPECT_THAT(error_after(text, cut), HasSubstr("run.csv: it became shorter while")) << size;
    }
    EXPECT_EQ(error_after(text, [](const auto&) {}), "no error");
    // The rows that were opened are still there.
    EXPECT_EQ(error_after(text, [](const auto& file) { std::filesystem::remove(file); }),
              "no error");
  }
}

TEST(Reader, ReadsColumnsInMemory) {
  const std::vector<double> rows{0, 1.5, -2.25, 0.1, 2.5, 1e-3}, backwards{7, 8};
  const auto reader = open_table(
      "data", {{"t", rows.data(), 3}, {"p", rows.data() + 1, 3}, {"n", &backwards[1], -1}}, 2);
  EXPECT_EQ(reader->header().file, "data");
  EXPECT_THAT(reader->header().names, ElementsAre("t", "p", "n"));
  for (int i = 0; i < 2; ++i) {
    EXPECT_THAT(pass(*reader, {2, 0, 1, 0}),
                ElementsAre(ElementsAre(8, 0, 1.5, 0), ElementsAre(7, 0.1, 2.5, 0.1)));
    EXPECT_EQ(reader->place(), "data: row 2");
  }
  reader->begin_pass(std::vector<std::size_t>{0});
  Number number{.value = 1, .rest = 1, .decimals = 2, .significant = 3};
  ASSERT_TRUE(reader->next({&number, 1}));
  EXPECT_EQ(number.rest, 0);
  EXPECT_EQ(number.decimals, Number::all_digits);
  EXPECT_EQ(number.significant, Number::all_digits);
  EXPECT_THROW(open_table("data", {{"t", nullptr, 1}}, 0), BadTable);
  EXPECT_THROW(open_table("data", std::vector<Column>(16385, {"t", rows.data(), 1}), 1),
               system::FileError);
}

// The keywords are comments then, so that the lines keep their numbers.
TEST(StkAttitude, IsATable) {
  const std::string head =
      "stk.v.11.0\nBEGIN Attitude\nNumberOfAttitudePoints 2\nScenarioEpoch 1 Jun 2002 12:00:00\n"
      "CoordinateAxes J2000\n";
  const std::string rows = "\n0.0e+000 0 0 0 1\n1.0e+001 0 0 0.5 0.8660254\n";
  const std::string end = "\nEND Attitude\n";
  const Table table = read_table(head + "AttitudeTimeQuaternions\n" + rows + end);
  EXPECT_EQ(table.names, (std::vector<std::string>{"t", "qx", "qy", "qz", "qw"}));
  EXPECT_EQ(table.rows,
            (std::vector<std::vector<double>>{{0, 0, 0, 0, 1}, {10, 0, 0, 0.5, 0.8660254}}));
  EXPECT_EQ(read_table(head + "AttitudeTimeQuatScalarFirst" + rows + end).names[1], "qw");
  EXPECT_EQ(
      read_table(head + "AttitudeTimeQuatAngVels\n0 0 0 0 1 0 0 6\n1 0 0 0 1 0 0 6" + end).names[5],
      "wx_deg_s");
  EXPECT_EQ(read_table(head + "AttitudeTimeDCM\n0 1 0 0 0 0 1 0 -1 0\n1 1 0 0 0 0 1 0 -1 0" + end)
                .names[2],
            "x21");
  EXPECT_THAT(file_error_of(head + "AttitudeTimeECFVector\n" + rows + end),
              testing::HasSubstr("run:6: its attitudes are AttitudeTimeECFVector, which are not "
                                 "read"));
  EXPECT_THAT(file_error_of(head + "AttitudeTimeQuaternions\n" + rows),
              testing::HasSubstr("it is cut off: END Attitude is missing"));
  EXPECT_THAT(table_error_of(head + "AttitudeTimeQuaternions\n" + rows + "2 0 0 x 1\n" + end),
              testing::HasSubstr("run:10: the column 'qz': 'x' is no number"));
}

TEST(ArduPilot, HasTheMessagesOfOneKind) {
  const std::string formats =
      "FMT, 128, 89, FMT, BBnNZ, Type,Length,Name,Format,Columns\n"
      "FMT, 64, 35, ATT, Qcc, TimeUS,Roll,Yaw\n"
      "FMT, 65, 60, IMU, QBff, TimeUS,I,GyrX,GyrY\n";
  const std::string gyroscopes = "IMU, 10, 0, 0.5, 0.25\nIMU, 10, 1, 9, 9\nIMU, 20, 0, 1, 2\n";
  const Table rates = read_table(formats + gyroscopes);
  EXPECT_EQ(rates.names, (std::vector<std::string>{"TimeUS", "I", "GyrX", "GyrY"}));
  EXPECT_EQ(rates.rows, (std::vector<std::vector<double>>{{10, 0, 0.5, 0.25}, {20, 0, 1, 2}}));
  const std::string attitudes = "ATT, 15, 1.5, 90\nPARM, 15, NAME, 3\nATT, 25, 2, 91\n";
  const Table angles = read_table(formats + gyroscopes + attitudes);
  EXPECT_EQ(angles.names, (std::vector<std::string>{"TimeUS", "Roll", "Yaw"}));
  EXPECT_EQ(angles.rows, (std::vector<std::vector<double>>{{15, 1.5, 90}, {25, 2, 91}}));
  EXPECT_THAT(table_error_of(formats + attitudes + "ATT, 35, x, 92\n"),
              testing::HasSubstr("run:7: the column 'Roll': 'x' is no number"));
  EXPECT_EQ(read_table(formats + "ATT,\n" + attitudes).rows, angles.rows);
  EXPECT_THAT(table_error_of(formats + attitudes + "ATT\n"),
              testing::HasSubstr("run:7: the column 'TimeUS': 'ATT' is no number"));
  EXPECT_THAT(file_error_of(formats + "MSG, 1, ArduCopter\n"),
              testing::HasSubstr("has no messages ATT, IMU or GYR"));
}

// Euler angles turn about axes that turn with the body, yaw, pitch and roll about fixed ones.
TEST(StkAttitude, StatesTheSequenceOfItsAngles) {
  const auto opened = [](const std::string& keywords) {
    static std::string text;
    text = "stk.v.11.0\n BEGIN Attitude\n" + keywords +
           "\n0 10 20 30\n1 11 21 31\n2 12 22 32\nEND Attitude\n";
    return open_table("run", text)->header();
  };
  const Header euler = opened(" Sequence 312\n AttitudeTimeEulerAngles");
  EXPECT_EQ(euler.sequence, "zxy");
  EXPECT_EQ(euler.names, (std::vector<std::string>{"t", "yaw_deg", "roll_deg", "pitch_deg"}));
  EXPECT_EQ(opened("Sequence 313\nAttitudeTimeEulerAngles").names[2], "pitch_deg");
  const Header ypr = opened("Sequence YPR\nAttitudeTimeYPRAngles");
  EXPECT_EQ(ypr.sequence, "xyz");
  EXPECT_EQ(ypr.names, (std::vector<std::string>{"t", "yaw_deg", "pitch_deg", "roll_deg"}));
}

TEST(OpenSim, HasAColumnForEachComponentOfAQuaternion) {
  const Table table = read_table(
      "DataRate=50\nDataType=Quaternion\nendheader\ntime\tpelvis_imu\n0\t1,0,0,0\n"
      "0.02\t0.5,0.5,0.5,0.5\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{"time", "pelvis_imu.qw", "pelvis_imu.qx",
                                                   "pelvis_imu.qy", "pelvis_imu.qz"}));
  EXPECT_EQ(table.rows,
            (std::vector<std::vector<double>>{{0, 1, 0, 0, 0}, {0.02, 0.5, 0.5, 0.5, 0.5}}));
}

// As ToString() of Unity and lists of Python write them.
TEST(VectorCells, HaveAColumnForEachNumber) {
  const std::vector<std::string> names{"t", "w[0]", "w[1]", "w[2]", "n"};
  for (const char* text : {"t;w;n\n0;(1.5, 2, 3);7\n0.1;(4, 5, 6);8\n",
                           "t,w,n\n0,\"(1.5, 2, 3)\",7\n0.1,\"(4, 5, 6)\",8\n",
                           "t,w,n\n0,(1.5, 2, 3),7\n0.1,(4, 5, 6),8\n",
                           "# a comment\nt\tw\tn\n0\t[1.5 2  3]\t7\n\n0.1\t[ 4 5 6 ]\t8\n"}) {
    const Table table = read_table(text);
    EXPECT_EQ(table.names, names) << text;
    EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{0, 1.5, 2, 3, 7}, {0.1, 4, 5, 6, 8}}))
        << text;
  }
}

TEST(VectorCells, MayBeMissingInTheFirstRows) {
  const Table table = read_table("t;w;q\n0;(1, 2, 3);\n1;(NaN, NaN, NaN);(1, 0, 0, 0)\n", {0});
  EXPECT_EQ(table.names, (std::vector<std::string>{"t", "w[0]", "w[1]", "w[2]", "q[0]", "q[1]",
                                                   "q[2]", "q[3]"}));
}

TEST(VectorCells, AreNotGuessed) {
  // Some of these commas are decimal ones.
  EXPECT_EQ(read_table("t;w;n\n0;(0,1, 0,2, 0,3);1\n1;(0,1, 0,2, 0,3);1\n", {0}).names,
            (std::vector<std::string>{"t", "w", "n"}));
  EXPECT_EQ(read_table("t;z;n\n0;(1,5, 2,5);1\n1;(1,5, 2,5);1\n", {0}).names.size(), 3);
}

TEST(VectorCells, NameTheRowOfAMistake) {
  const std::string of_other_size = "t;w;n\n0;(1, 2, 3);1\n\n1;(1, 2);1\n";
  EXPECT_EQ(table_error_of(of_other_size),
            "run:4: the column 'w[0]': '(1, 2)' is no number -- correct or remove the row, or "
            "choose another column");
  // Columns that are not read may contain anything.
  EXPECT_EQ(read_table(of_other_size, {0, 4}).rows,
            (std::vector<std::vector<double>>{{0, 1}, {1, 1}}));
  EXPECT_EQ(table_error_of("t;w;n\n0;(1, 2, 3);1\n1;(1, x, 3);1\n"),
            "run:3: the column 'w[1]': 'x' is no number -- correct or remove the row, or choose "
            "another column");
  EXPECT_THAT(table_error_of("t;w;n\n0;(1, 2, 3);1\n1;;1\n"),
              testing::HasSubstr("run:3: the column 'w[0]': the cell is empty"));
}

/// The row of `ros2 topic echo --csv` with these first cells, and numbers behind them.
std::string row_of_ros(std::string row, int count) {
  for (int i = 4; i <= count; ++i) row += "," + std::to_string(i);
  return row + "\n";
}

TEST(RosMessage, HasTheNamesOfItsMembers) {
  const Table imu =
      read_table(row_of_ros("17,250000000,imu", 40) + row_of_ros("17,260000000,imu", 40), {0});
  ASSERT_EQ(imu.names.size(), 40);
  EXPECT_EQ(imu.names[0], "header.stamp.sec");
  EXPECT_EQ(imu.names[1], "header.stamp.nanosec");
  EXPECT_EQ(imu.names[3], "orientation.x");
  EXPECT_EQ(imu.names[6], "orientation.w");
  EXPECT_EQ(imu.names[16], "angular_velocity.x");
  EXPECT_EQ(imu.names[18], "angular_velocity.z");
  EXPECT_EQ(imu.names[28], "linear_acceleration.x");
  const Table pose = read_table(row_of_ros("17,250000000,map", 10), {0});
  EXPECT_EQ(pose.names[5], "pose.position.z");
  EXPECT_EQ(pose.names[6], "pose.orientation.x");
  EXPECT_EQ(pose.names[9], "pose.orientation.w");
}

TEST(RosMessage, HasAHeaderAndAsManyNumbers) {
  for (const std::string& row :
       {row_of_ros("17,250000000,map", 9), row_of_ros("17,250000000,3", 10),
        row_of_ros("17,2500000000,map", 10), row_of_ros("17.5,250000000,map", 10)}) {
    EXPECT_EQ(read_table(row, {0}).names[0], "#1") << row;
  }
}

}  // namespace
}  // namespace twrench::table
