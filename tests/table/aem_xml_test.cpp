#include "table/aem_xml.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "table/read_table.h"

namespace twrench::table {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// One message in both notations.
struct Message {
  std::string version, metadata;  ///< "KEYWORD = value" lines
  std::string values, elements;   ///< of a row: in a line, and as elements
};

const std::string named_frames =
    "OBJECT_NAME = SHIP\nREF_FRAME_A = EME2000\nREF_FRAME_B = SC_BODY_1\n";
const std::string epochs[] = {"2026-11-28T12:00:00.000", "2026-11-28T12:00:00.020"};

std::string in_lines(const Message& message) {
  std::string text = "CCSDS_AEM_VERS = " + message.version + "\nMETA_START\n" + message.metadata +
                     "META_STOP\nDATA_START\n";
  for (const std::string& epoch : epochs) text += epoch + " " + message.values + "\n";
  return text + "DATA_STOP\n";
}

std::string segment_of(const Message& message) {
  std::string text = "<segment><metadata><COMMENT>a test</COMMENT>";
  std::size_t at = 0;
  while (at < message.metadata.size()) {
    const std::size_t equals = message.metadata.find(" = ", at);
    const std::size_t end = message.metadata.find('\n', at);
    const std::string keyword = message.metadata.substr(at, equals - at);
    text += fmt::format("<{0}> {1}\n</{0}>", keyword,
                        message.metadata.substr(equals + 3, end - equals - 3));
    at = end + 1;
  }
  text += "</metadata><data><COMMENT>rows</COMMENT>";
  for (const std::string& epoch : epochs) {
    text += fmt::format("<attitudeState><form><EPOCH>{}</EPOCH>{}</form></attitudeState>\n", epoch,
                        message.elements);
  }
  return text + "</data></segment>";
}

std::string document_of(const std::string& segments, const std::string& version = "2.0") {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<aem id=\"CCSDS_AEM_VERS\" version=\"{}\"><header/>"
      "<body>{}</body></aem>\n",
      version, segments);
}

void expect_same(const Message& message) {
  const std::string lines = in_lines(message),
                    document = document_of(segment_of(message), message.version);
  const Header a = open_table("a.aem", std::string_view(lines))->header();
  const Header b = open_table("a.xml", std::string_view(document))->header();
  EXPECT_EQ(a.names, b.names) << document;
  EXPECT_EQ(a.units, b.units);
  EXPECT_EQ(a.sequence, b.sequence);
  EXPECT_EQ(a.states_inverse, b.states_inverse);
  EXPECT_EQ(read_table(lines).rows, read_table(document).rows) << document;
}

const std::string quaternion =
    "<quaternion><QC>0.5</QC><Q1>0.1</Q1><Q2>-0.7</Q2><Q3>0.5</Q3></quaternion>";
const std::string type = "ATTITUDE_TYPE = ";

const Message plain{"2.0", named_frames + type + "QUATERNION\n", "0.1 -0.7 0.5 0.5", quaternion};

TEST(AemXml, HasTheRowsOfTheOtherNotation) {
  const std::string a2b = named_frames + "ATTITUDE_DIR = A2B\n";
  const std::string rotations =
      "<rotationAngles><rotation1 angle=\"Z_ANGLE\" units=\"deg\">1</rotation1>"
      "<rotation2 angle=\"Y_ANGLE\">2</rotation2><rotation3 angle=\"X_ANGLE\">3</rotation3>"
      "</rotationAngles>";
  const std::string rates =
      "<rotationRates><rotation1 rate=\"X_RATE\">4</rotation1><rotation2 rate=\"Y_RATE\">5"
      "</rotation2><rotation3 rate=\"Z_RATE\">6</rotation3></rotationRates>";
  const std::string velocity =
      "<ANGVEL_X units=\"deg/s\">4</ANGVEL_X><ANGVEL_Y>5</ANGVEL_Y><ANGVEL_Z>6</ANGVEL_Z>";
  const std::string angles =
      "<ANGLE_1 units=\"deg\">1</ANGLE_1><ANGLE_2>2</ANGLE_2><ANGLE_3>3</ANGLE_3>";
  const std::string spin =
      "<SPIN_ALPHA>0</SPIN_ALPHA><SPIN_DELTA>80</SPIN_DELTA><SPIN_ANGLE>45</SPIN_ANGLE>"
      "<SPIN_ANGLE_VEL>1</SPIN_ANGLE_VEL>";
  const std::string dots =
      "<Q1_DOT>1</Q1_DOT><Q2_DOT>2</Q2_DOT><Q3_DOT>3</Q3_DOT><QC_DOT>4</QC_DOT>";
  const std::vector<Message> messages{
      plain,
      {"1.0", a2b + type + "QUATERNION\nQUATERNION_TYPE = FIRST\n", "0.5 0.1 -0.7 0.5", quaternion},
      {"1.0", named_frames + "ATTITUDE_DIR = B2A\n" + type + "QUATERNION\nQUATERNION_TYPE = LAST\n",
       "0.1 -0.7 0.5 0.5", quaternion},
      {"1.0", a2b + type + "QUATERNION/RATE\nQUATERNION_TYPE = LAST\nRATE_FRAME = REF_FRAME_B\n",
       "0.1 -0.7 0.5 0.5 4 5 6", quaternion + rates},
      {"1.0", a2b + type + "QUATERNION/DERIVATIVE\nQUATERNION_TYPE = LAST\n",
       "0.1 -0.7 0.5 0.5 1 2 3 4", quaternion + "<quaternionRate>" + dots + "</quaternionRate>"},
      {"2.0", named_frames + type + "QUATERNION/DERIVATIVE\n", "0.1 -0.7 0.5 0.5 1 2 3 4",
       quaternion + "<quaternionDot>" + dots + "</quaternionDot>"},
      {"2.0", named_frames + type + "QUATERNION/ANGVEL\nANGVEL_FRAME = EME2000\n",
       "0.1 -0.7 0.5 0.5 4 5 6", quaternion + "<angVel>" + velocity + "</angVel>"},
      {"1.0", a2b + type + "euler_angle\nEULER_ROT_SEQ = 321\n", "1 2 3", rotations},
      {"1.0", a2b + type + "EULER_ANGLE/RATE\nEULER_ROT_SEQ = 321\n", "1 2 3 4 5 6",
       rotations + rates},
      {"2.0", named_frames + type + "EULER_ANGLE\nEULER_ROT_SEQ = XZY\n", "1 2 3", angles},
      {"2.0", named_frames + type + "EULER_ANGLE/DERIVATIVE\nEULER_ROT_SEQ = XZY\n", "1 2 3 7 8 9",
       angles +
           "<ANGLE_1_DOT>7</ANGLE_1_DOT><ANGLE_2_DOT>8</ANGLE_2_DOT><ANGLE_3_DOT>9</ANGLE_3_DOT>"},
      {"2.0", named_frames + type + "EULER_ANGLE/ANGVEL\nEULER_ROT_SEQ = ZXZ\n", "1 2 3 4 5 6",
       angles + velocity},
      {"2.0", named_frames + type + "SPIN\n", "0 80 45 1", spin},
      {"2.0", named_frames + type + "SPIN/NUTATION\n", "0 80 45 1 2 3 4",
       spin + "<NUTATION>2</NUTATION><NUTATION_PER units=\"s\">3</NUTATION_PER>"
              "<NUTATION_PHASE>4</NUTATION_PHASE>"},
      {"2.0", named_frames + type + "SPIN/NUTATION_MOM\n", "0 80 45 1 2 3 4",
       spin + "<MOMENTUM_ALPHA>2</MOMENTUM_ALPHA><MOMENTUM_DELTA>3</MOMENTUM_DELTA>"
              "<NUTATION_VEL>4</NUTATION_VEL>"}};
  for (const Message& message : messages) expect_same(message);
}

TEST(AemXml, IsReadInAnNdmAndWithPrefixes) {
  const std::string aem = "<aem version=\"2.0\"><body>" + segment_of(plain) + "</body></aem>";
  const std::vector<std::vector<double>> rows = read_table(in_lines(plain)).rows;
  EXPECT_EQ(read_table("<ndm><COMMENT>two</COMMENT><apm/>" + aem + "</ndm>").rows, rows);
  std::string prefixed = aem;
  for (const char* name : {"aem", "body", "segment", "quaternion"}) {
    for (const char* bracket : {"<", "</"}) {
      const std::string tag = std::string(bracket) + name;
      for (std::size_t at = 0; (at = prefixed.find(tag, at)) != std::string::npos; at += 5)
        prefixed.insert(at + std::string(bracket).size(), "ndm:");
    }
  }
  EXPECT_EQ(read_table(prefixed).rows, rows) << prefixed;
}

TEST(AemXml, OfSeveralBodiesAsksForOne) {
  Message probe = plain;
  probe.metadata.replace(probe.metadata.find("SHIP"), 4, "PROBE");
  EXPECT_THAT(table_error_of(document_of(segment_of(plain) + segment_of(probe))),
              AllOf(HasSubstr("its 2 segments are of 2 objects: SHIP, PROBE"),
                    HasSubstr("keep one of its <segment> elements")));
}

TEST(AemXml, NamesTheRowOfAMistake) {
  const auto refusal = [](const std::string& elements) {
    Message message = plain;
    message.elements = elements;
    return file_error_of(document_of(segment_of(message)));
  };
  EXPECT_THAT(refusal("<Q1>0</Q1><Q2>0</Q2><Q3>0</Q3>"), HasSubstr("run: row 1: it has no QC"));
  EXPECT_THAT(refusal(quaternion + "<Q1>0</Q1>"), HasSubstr("it has more than one Q1"));
  EXPECT_THAT(refusal(quaternion + "<ANGVEL_X>0</ANGVEL_X>"),
              HasSubstr("it has ANGVEL_X, which is not a value of its ATTITUDE_TYPE"));
  EXPECT_THAT(refusal("<Q1>0 1</Q1><Q2>0</Q2><Q3>0</Q3><QC>1</QC>"), HasSubstr("its Q1 is '0 1'"));
  EXPECT_THAT(refusal("<Q1 units=\"deg\">0</Q1><Q2>0</Q2><Q3>0</Q3><QC>1</QC>"),
              HasSubstr("the unit of its Q1 is deg, but the standard has none"));
  Message euler{"1.0", named_frames + type + "EULER_ANGLE\nEULER_ROT_SEQ = 123\n", "",
                "<rotationAngles><rotation1 angle=\"Z_ANGLE\">1</rotation1><rotation2>2</rotation2>"
                "<rotation3>3</rotation3></rotationAngles>"};
  EXPECT_THAT(file_error_of(document_of(segment_of(euler), "1.0")),
              HasSubstr("its rotation 1 is Z_ANGLE, but the EULER_ROT_SEQ is xyz"));
  std::string wrong_epoch = document_of(segment_of(plain));
  wrong_epoch.replace(wrong_epoch.rfind("2026"), 4, "COMM");
  EXPECT_THAT(file_error_of(wrong_epoch), HasSubstr("row 2: its EPOCH is 'COMM-11"));
  Message text = plain;
  text.elements = "<Q1>x</Q1><Q2>0</Q2><Q3>0</Q3><QC>1</QC>";
  EXPECT_THAT(table_error_of(document_of(segment_of(text))),
              HasSubstr("run: row 1: the column 'qx': 'x' is no number"));
}

TEST(AemXml, RefusesOtherAndDamagedDocuments) {
  const std::string whole = document_of(segment_of(plain));
  EXPECT_THAT(file_error_of(whole.substr(0, whole.size() - 40)),
              HasSubstr("is cut off or damaged"));
  EXPECT_THAT(file_error_of("<?xml version=\"1.0\"?><gpx/>"),
              HasSubstr("an XML document without attitude ephemerides"));
  EXPECT_THAT(file_error_of(document_of("")), HasSubstr("without attitude ephemerides"));
  const std::string other = "<aem version=\"1.0\"><body/></aem><aem version=\"2.0\"/>";
  EXPECT_THAT(file_error_of("<ndm>" + other + "</ndm>"), HasSubstr("of the versions 1.0 and 2.0"));
  std::string nested = "<aem version=\"2.0\">";
  for (int i = 0; i < 100'000; ++i) nested += "<a>";
  EXPECT_THAT(file_error_of(nested), HasSubstr("is cut off or damaged"));
}

// An entity that stands for a thousand others would fill the memory if it were expanded.
TEST(AemXml, ExpandsNoEntities) {
  std::string document = document_of(segment_of(plain));
  document.insert(document.find("<aem"),
                  "<!DOCTYPE aem [<!ENTITY a \"0.1\"><!ENTITY b SYSTEM \"/etc/hostname\">]>");
  EXPECT_EQ(read_table(document).rows, read_table(in_lines(plain)).rows);
  document.replace(document.find("<Q1>0.1"), 7, "<Q1>&a;");
  EXPECT_THAT(table_error_of(document), HasSubstr("'&a;' is no number"));
  document.replace(document.find("&a;"), 3, "&b;");
  EXPECT_THAT(table_error_of(document), HasSubstr("'&b;' is no number"));
}

}  // namespace
}  // namespace twrench::table
