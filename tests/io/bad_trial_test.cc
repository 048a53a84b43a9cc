// Trials with one thing wrong: each is refused with the place, the mistake and what was expected.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/io/trial_fixture.h"

namespace brachium {
namespace {

using nlohmann::ordered_json;
using testing::AllOf, testing::HasSubstr, testing::StartsWith;

struct BadJson {
  const char* name;
  std::function<void(ordered_json&)> change;
  const char* line_with;  // the complaint names the line that holds this text
  const char* complaint;
};

class BadTrialJson : public testing::TestWithParam<BadJson> {};

TEST_P(BadTrialJson, IsRefusedWithItsLine) {
  const TrialOnDisk disk(GetParam().change);
  const std::string line = std::to_string(disk.LineOf("trial.json", GetParam().line_with));
  EXPECT_THAT(Complaint(disk),
              AllOf(StartsWith("trial.json:" + line + ": "), HasSubstr(GetParam().complaint)));
}

const BadJson kBadJson[] = {
    {"MissingVersion", [](auto& j) { j.erase("brachium_trial"); }, "{",
     "brachium_trial is missing; it is required"},
    {"UnknownVersion", [](auto& j) { j["brachium_trial"] = 2; }, "brachium_trial",
     "brachium_trial is 2; expected version 1"},
    {"MissingArm", [](auto& j) { j.erase("arm"); }, "{", "arm is missing"},
    {"MissingSide", [](auto& j) { j["arm"].erase("side"); }, "\"arm\"", "arm.side is missing"},
    {"UnknownSide", [](auto& j) { j["arm"]["side"] = "middle"; }, "\"side\"",
     "arm.side is 'middle'; expected one of right, left"},
    {"UnknownSegmentInArm",
     [](auto& j) {
       j["arm"]["segments"]["leg"] = {{"length_m", 1}};
     },
     "\"leg\"", "names the unknown segment 'leg'; expected one of thorax, girdle"},
    {"ZeroLength", [](auto& j) { j["arm"]["segments"]["forearm"]["length_m"] = 0; },
     "\"length_m\": 0\n", "length_m is 0; expected a number greater than zero"},
    {"ZeroDistalJoint",
     [](auto& j) {
       j["arm"]["segments"]["forearm"] = {{"distal_joint_m", {0, 0, 0}}};
     },
     "distal_joint_m", "distal_joint_m is zero"},
    {"LengthInCentimetres", [](auto& j) { j["arm"]["segments"]["forearm"]["length_m"] = 26; },
     "\"length_m\": 26\n", "looks like centimetres"},
    {"NegativeSigma", [](auto& j) { j["arm"]["shoulder"]["sigma_m"] = -1; }, "sigma_m",
     "arm.shoulder.sigma_m is -1"},
    {"UnknownConstraint", [](auto& j) { j["arm"]["elbow"]["constraint"] = "hinge"; }, "constraint",
     "expected one of adduction, none"},
    {"CarryingAngleBeyondRight", [](auto& j) { j["arm"]["elbow"]["carrying_angle_deg"] = 95; },
     "carrying_angle_deg", "expected degrees"},
    {"NoRecordings", [](auto& j) { j["recordings"] = ordered_json::array(); }, "recordings",
     "recordings is empty"},
    {"MissingRecordings", [](auto& j) { j.erase("recordings"); }, "{", "recordings is missing"},
    {"RecordingsAreNoList", [](auto& j) { j["recordings"] = "all"; }, "recordings",
     "recordings is not a list"},
    {"UnknownSegment", [](auto& j) { j["recordings"][1]["segment"] = "lower_arm"; }, "lower_arm",
     "recordings[1].segment names the unknown segment 'lower_arm'"},
    {"SegmentTwice", [](auto& j) { j["recordings"][1]["segment"] = "upper_arm"; },
     "\"segment\": \"upper_arm\",\n   \"file\": \"forearm.csv\"",
     "is 'upper_arm' as in recordings[0]; expected each segment once"},
    {"HandWithoutForearm", [](auto& j) { j["recordings"][1]["segment"] = "hand"; }, "recordings",
     "without the forearm between them"},
    {"MissingFileName", [](auto& j) { j["recordings"][1].erase("file"); },
     "{\n   \"segment\": \"forearm\"", "recordings[1].file is missing"},
    {"AbsentFile", [](auto& j) { j["recordings"][1]["file"] = "gone.csv"; }, "gone.csv",
     "names 'gone.csv', which is not a file in the trial folder"},
    {"UnknownFormat", [](auto& j) { j["recordings"][1]["format"] = "c3d"; }, "c3d",
     "is 'c3d'; expected one of csv"},
    {"UnknownNoise", [](auto& j) { j["recordings"][1]["noise"] = "loud"; }, "loud",
     "expected one of mtw, mtx"},
    {"MountingWithoutRotation", [](auto& j) { j["recordings"][1]["mounting"].erase("q_BS_wxyz"); },
     "\"mounting\": {\n    \"p_BS_m\"", "q_BS_wxyz is missing"},
    {"MountingOffTheUnitSphere",
     [](auto& j) {
       j["recordings"][1]["mounting"]["q_BS_wxyz"] = {1, 0, 0, 0.1};
     },
     "\"q_BS_wxyz\": [\n     1,\n     0,\n     0,\n     0.1",
     "has the norm 1.0050; expected a unit quaternion"},
    {"MountingOfThreeNumbers",
     [](auto& j) {
       j["recordings"][0]["mounting"]["q_BS_wxyz"] = {1, 0, 0};
     },
     "q_BS_wxyz", "has 3 numbers; expected 4"},
    {"MountingInMillimetres",
     [](auto& j) {
       j["recordings"][0]["mounting"]["p_BS_m"] = {10, -120, 0};
     },
     "p_BS_m", "looks like centimetres or millimetres"},
    {"IntervalThatEndsBeforeItStarts", [](auto& j) { j["intervals"][0]["end_s"] = 0.05; },
     "\"end_s\"", "expected a time after start_s"},
    {"UnknownStartPose", [](auto& j) { j["start_pose"]["label"] = "sleeping"; }, "sleeping",
     "is the unknown pose 'sleeping'"},
    {"StartPoseWithoutPose", [](auto& j) { j["start_pose"].erase("label"); }, "start_pose",
     "states no pose"},
    {"StartPoseOutsideTheRecordings", [](auto& j) { j["start_pose"]["at_s"] = 50; }, "at_s",
     "expected a time within the recordings, 0 to 1.99 s"},
    {"EndPoseOutsideTheRecordings",
     [](auto& j) {
       j["end_pose"] = {{"elbow_flexion_deg", 10}, {"at_s", 60}};
     },
     "60", "expected a time within the recordings, 0 to 1.99 s"},
    {"ContactOfAPointWithoutASensor",
     [](auto& j) {
       j["contacts"] = {{{"point", "hand"}, {"at_s", {0.5, 1}}}};
     },
     "\"hand\"", "is 'hand'; expected a point of a segment that is recorded: elbow, wrist"},
    {"ContactWithoutInstants",
     [](auto& j) {
       j["contacts"] = {{{"point", "wrist"}, {"at_s", nlohmann::ordered_json::array()}}};
     },
     "at_s\": []", "is empty; expected the instants"},
    {"ContactOutsideTheRecordings",
     [](auto& j) {
       j["contacts"] = {{{"point", "wrist"}, {"at_s", {0.5, 77}}}};
     },
     "\"at_s\": [", "expected a time within the recordings, 0 to 1.99 s"},
    {"ContactAtAPlaceTwice",
     [](auto& j) {
       j["contacts"] = {{{"point", "wrist"}, {"at_s", {0.5}}, {"place", "cup"}},
                        {{"point", "elbow"}, {"at_s", {0.7}}, {"place", "cup"}, {"sigma_m", 0.02}}};
     },
     "\"cup\",", "is the place 'cup' again"},
    {"ContactOfUnknownAxes",
     [](auto& j) {
       j["contacts"] = {{{"point", "wrist"}, {"at_s", {0.5}}, {"axes", "x"}}};
     },
     "\"axes\"", "expected all or height"},
    {"UnknownFrames", [](auto& j) { j["reference"]["frames"] = "world"; }, "frames",
     "expected 'segment' or 'cluster'"},
    {"UnknownUp", [](auto& j) { j["reference"]["up"] = "x"; }, "\"up\"", "expected 'z' or 'y'"},
    {"UnknownNameInColumns", [](auto& j) { j["reference"]["columns"]["leg"] = "seg1"; }, "\"leg\"",
     "is neither a segment nor a joint"},
    {"AbsentReference", [](auto& j) { j["reference"]["file"] = "gone.csv"; }, "gone.csv",
     "is not a file in the trial folder"},
    {"TextForANumber", [](auto& j) { j["intervals"][0]["start_s"] = "zero"; }, "\"zero\"",
     "is \"zero\"; expected a number"},
};

INSTANTIATE_TEST_SUITE_P(All, BadTrialJson, testing::ValuesIn(kBadJson),
                         [](const auto& tested) { return tested.param.name; });

struct BadFile {
  const char* name;
  const char* file;
  std::string bytes;
  const char* complaint;  // its beginning, without the folder
};

class BadTrialFile : public testing::TestWithParam<BadFile> {};

TEST_P(BadTrialFile, IsRefusedWithItsPlace) {
  const TrialOnDisk disk;
  disk.Write(GetParam().file, GetParam().bytes);
  EXPECT_THAT(Complaint(disk), StartsWith(GetParam().complaint));
}

std::string SlowedDown(double factor) { return Scaled(RecordingText(), {"time_s"}, factor); }

std::string Swapped() {
  std::string text = RecordingText();
  return "time_s,acc_x,acc_y,acc_z,gyr_x,gyr_y,gyr_z" + text.substr(text.find('\n'));
}

const BadFile kBadFiles[] = {
    {"Empty", "forearm.csv", "", "forearm.csv: is empty"},
    {"Binary", "forearm.csv", std::string("PK\3\4\0\0", 6), "forearm.csv: is a binary file"},
    {"MissingColumn", "forearm.csv", "time_s,gyr_x,gyr_y,gyr_z,acc_x,acc_y\n0,0,0,0,0,0\n",
     "forearm.csv:1: column 'acc_z' is missing"},
    {"TextInANumber", "forearm.csv", WithCell(RecordingText(), 5, 2, "fast"),
     "forearm.csv:7: gyr_y is 'fast'; expected a number"},
    {"ShortRow", "forearm.csv", WithCell(RecordingText(), 5, 6, "1\n1,2"),
     "forearm.csv:8: row has 2 cells; expected 7"},
    {"LongRow", "forearm.csv", WithCell(RecordingText(), 5, 2, "0,5"),
     "forearm.csv:7: row has 8 cells; expected 7"},
    {"OneSample", "forearm.csv", RecordingText(1),
     "forearm.csv: has 1 usable sample; expected two or more"},
    {"HeaderAlone", "forearm.csv", RecordingText(0), "forearm.csv: has 0 usable samples"},
    {"TimeRunningBackThroughout", "forearm.csv", SlowedDown(-1.0),
     "forearm.csv:3: time_s repeats itself or runs back here and in most of the rows"},
    {"TimeInMilliseconds", "forearm.csv", SlowedDown(1000.0),
     "forearm.csv: time_s has a median step of 10; expected seconds"},
    {"RatesInDegrees", "forearm.csv",
     Scaled(RecordingText(), {"gyr_x", "gyr_y", "gyr_z"}, 1 / kDegree),
     "forearm.csv: gyr looks like deg/s"},
    {"AccelerationInG", "forearm.csv",
     Scaled(RecordingText(), {"acc_x", "acc_y", "acc_z"}, 1 / 9.81),
     "forearm.csv: acc looks like g (median norm 1.000); expected m/s^2"},
    {"AccelerationInThousandthsOfG", "forearm.csv",
     Scaled(RecordingText(), {"acc_x", "acc_y", "acc_z"}, 1000 / 9.81),
     "forearm.csv: acc looks like thousandths of g"},
    {"AccelerationWithoutGravity", "forearm.csv",
     Scaled(RecordingText(), {"acc_x", "acc_y", "acc_z"}, 0.01), "forearm.csv: acc lacks gravity"},
    {"GyroscopeAndAccelerometerSwapped", "forearm.csv", Swapped(),
     "forearm.csv: gyr and acc look swapped"},
    {"PartOfAMagnetometer", "forearm.csv", WithColumn(RecordingText(), "mag_x", "1"),
     "forearm.csv:1: column 'mag_y' is missing"},
    {"OrientationOffTheUnitSphere", "forearm.csv",
     WithColumn(
         WithColumn(WithColumn(WithColumn(RecordingText(), "q_w", "1"), "q_x", "0.1"), "q_y", "0"),
         "q_z", "0"),
     "forearm.csv:2: q_w, q_x, q_y, q_z have the norm 1.0050; expected a unit quaternion"},
    {"ReferenceOffTheUnitSphere", "reference.csv", WithCell(ReferenceText(), 3, 1, "0.9"),
     "reference.csv:5: upper_arm_qw.._qz have the norm 1.0817; expected a unit quaternion"},
    {"ReferenceOfUnknownNames", "reference.csv", "time_s,leg_px,leg_py\n0,1,1\n0.1,1,1\n",
     "reference.csv:1: has no column of a known segment or joint"},
    {"ReferenceWithPartOfAQuaternion", "reference.csv", "time_s,hand_qw\n0,1\n0.1,1\n",
     "reference.csv:1: column 'hand_qx' is missing"},
    {"ReferenceWithoutTime", "reference.csv", "hand_px,hand_py\n0,1\n0.1,1\n",
     "reference.csv:1: column 'time_s' is missing"},
    {"SyntaxError", "trial.json", "{\n \"brachium_trial\": 1,\n \"arm\": {]\n}",
     "trial.json:3: is not valid JSON"},
    {"EmptyTrialJson", "trial.json", "", "trial.json: is empty"},
    {"TrialJsonIsAList", "trial.json", "[1]", "trial.json:1: the file is not an object"},
};

INSTANTIATE_TEST_SUITE_P(All, BadTrialFile, testing::ValuesIn(kBadFiles),
                         [](const auto& tested) { return tested.param.name; });

TEST(BadTrial, WithoutACommonTimeIsRefused) {
  const TrialOnDisk disk;
  disk.Write("forearm.csv", RecordingText(200, 3600.0));
  EXPECT_THAT(
      Complaint(disk),
      AllOf(StartsWith("trial.json:" + std::to_string(disk.LineOf("trial.json", "recordings"))),
            HasSubstr("upper_arm.csv from 0 to 1.99 s, forearm.csv from 3600 to 3601.99"),
            HasSubstr("expected one clock")));
}

TEST(BadTrial, WithoutTrialJsonIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(Complaint(folder), StartsWith("trial.json: cannot be read"));
}

TEST(BadTrial, ThatIsNoFolderIsRefused) { EXPECT_THROW(ReadTrial("/nowhere/at/all"), InputError); }

TEST(BadTrial, WithAMappedNameThatTheReferenceLacksIsRefused) {
  const TrialOnDisk disk([](ordered_json& json) { json["reference"]["columns"]["hand"] = "foot"; });
  EXPECT_THAT(Complaint(disk), StartsWith("reference.csv:1: has no columns foot_qw.._qz"));
}

}  // namespace
}  // namespace brachium
