#include "io/trial_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/trial_fixture.h"

namespace brachium {
namespace {

using nlohmann::ordered_json;
using testing::Contains, testing::HasSubstr, testing::IsEmpty, testing::Not, testing::SizeIs;

// Reports as one text, one sentence a line.
std::string Joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + "\n";
  return text;
}

void KeepOneRecording(ordered_json& json) {
  json["recordings"].erase(1);
  json["recordings"][0].erase("mounting");
}

TEST(TrialFolder, HoldsWhatTrialJsonSays) {
  const TrialFolder folder = ReadTrial(TrialOnDisk().path());
  const Observations& observations = folder.trial.observations;
  EXPECT_EQ(folder.trial.name, "drinking");
  EXPECT_EQ(observations.arm.side, Side::kRight);
  EXPECT_EQ(observations.arm.segments.at(Segment::kForearm).p_distal_B,
            Eigen::Vector3d(0, -0.26, 0));
  ASSERT_THAT(observations.recordings, SizeIs(2));
  EXPECT_EQ(observations.recordings[1].segment, Segment::kForearm);
  EXPECT_EQ(observations.recordings[1].size(), 200u);
  EXPECT_EQ(observations.recordings[1].mounting->p_BS_B, Eigen::Vector3d(0.01, -0.1, 0));
  EXPECT_DOUBLE_EQ(observations.recordings[0].gyr_S[0].x(), 1.6);
  ASSERT_THAT(observations.intervals, SizeIs(1));
  EXPECT_EQ(observations.intervals[0].label, "task:drinking");
  EXPECT_DOUBLE_EQ(*observations.start_pose->elbow_flexion, 10 * kDegree);
  EXPECT_DOUBLE_EQ(*observations.start_pose->forearm_pronation, 90 * kDegree);
  EXPECT_DOUBLE_EQ(*observations.start_pose->shoulder_elevation, 0.0);
  EXPECT_THAT(folder.repairs, IsEmpty());
  EXPECT_THAT(folder.warnings, IsEmpty());
  EXPECT_FALSE(folder.simulated);
}

TEST(TrialFolder, ReportsEveryDefaultThatItTook) {
  const std::string defaults = Joined(ReadTrial(TrialOnDisk().path()).defaults);
  EXPECT_THAT(defaults, HasSubstr("recordings[0].noise = mtw\n"));
  EXPECT_THAT(defaults, HasSubstr("recordings[1].mounting.q_sigma_deg = 2 deg\n"));
  EXPECT_THAT(defaults, HasSubstr("arm.segments.forearm.length_sigma_m = 0.005 m\n"));
  EXPECT_THAT(defaults, HasSubstr("arm.elbow = adduction constraint"));
  EXPECT_THAT(defaults, HasSubstr("start_pose.sd_deg = 10 deg\n"));
  EXPECT_THAT(defaults, HasSubstr("reference.frames = segment\n"));
  EXPECT_THAT(defaults, Not(HasSubstr("length_m")));
}

TEST(TrialFolder, TakesAnAdultsMeanForALengthThatNobodyMeasured) {
  const TrialOnDisk disk([](ordered_json& json) { json["arm"].erase("segments"); });
  const TrialFolder folder = ReadTrial(disk.path());
  EXPECT_EQ(folder.trial.observations.arm.segments.at(Segment::kUpperArm).p_distal_B,
            DefaultGeometry(Segment::kUpperArm, Side::kRight).p_distal_B);
  EXPECT_THAT(folder.defaults, Contains(HasSubstr("arm.segments.upper_arm")));
}

TEST(TrialFolder, ListsItsInputsWithTheirChecksums) {
  const TrialFolder folder = ReadTrial(TrialOnDisk().path());
  ASSERT_THAT(folder.inputs, SizeIs(4));
  EXPECT_EQ(folder.inputs[0].path, "trial.json");
  EXPECT_EQ(folder.inputs[2].path, "forearm.csv");
  EXPECT_EQ(folder.inputs[3].path, "reference.csv");
  EXPECT_EQ(folder.inputs[1].sha256, folder.inputs[2].sha256);
  EXPECT_EQ(folder.inputs[0].sha256.size(), 64u);
}

TEST(TrialFolder, NamesTheReferenceWithoutParsingItWhereOnlyRecordingsAreAskedFor) {
  TrialOnDisk disk;
  const TrialFolder all = ReadTrial(disk.path());
  const TrialFolder recordings = ReadTrial(disk.path(), TrialParts::kRecordings);
  EXPECT_TRUE(all.trial.reference.has_value());
  EXPECT_FALSE(recordings.trial.reference.has_value());
  ASSERT_EQ(recordings.inputs.size(), all.inputs.size());
  EXPECT_EQ(recordings.inputs.back().sha256, all.inputs.back().sha256);
}

TEST(TrialFolder, LeavesARecordingWithoutMountingUncalibrated) {
  const TrialOnDisk disk([](ordered_json& json) { json["recordings"][1].erase("mounting"); });
  const auto recordings = ReadTrial(disk.path()).trial.observations.recordings;
  EXPECT_TRUE(recordings[0].mounting.has_value());
  EXPECT_FALSE(recordings[1].mounting.has_value());
}

TEST(TrialFolder, TakesALoneSensorsAxesForTheSegments) {
  const TrialFolder folder = ReadTrial(TrialOnDisk(KeepOneRecording).path());
  const Mounting mounting = *folder.trial.observations.recordings[0].mounting;
  EXPECT_EQ(mounting.q_BS.w(), 1.0);
  EXPECT_EQ(mounting.p_BS_B, Eigen::Vector3d::Zero());
  EXPECT_THAT(folder.defaults, Contains(HasSubstr("recordings[0].mounting = identity")));
}

TEST(TrialFolder, PutsASensorOfUnknownPlaceHalfWayAlongItsSegment) {
  const TrialOnDisk disk(
      [](ordered_json& json) { json["recordings"][0]["mounting"].erase("p_BS_m"); });
  const Mounting mounting = *ReadTrial(disk.path()).trial.observations.recordings[0].mounting;
  EXPECT_EQ(mounting.p_BS_B, Eigen::Vector3d(0, -0.155, 0));
  EXPECT_EQ(mounting.p_sigma, 0.05);
}

TEST(TrialFolder, ReadsNoiseAsPresetOrAsFigures) {
  const TrialOnDisk disk([](ordered_json& json) {
    json["recordings"][0]["noise"] = "mtx";
    json["recordings"][1]["noise"] = {{"preset", "mtx"}, {"gyro_density_deg_s_rthz", 0.02}};
  });
  const auto recordings = ReadTrial(disk.path()).trial.observations.recordings;
  EXPECT_EQ(recordings[0].noise.gyro_density, MtxNoise().gyro_density);
  EXPECT_DOUBLE_EQ(recordings[1].noise.gyro_density, 0.02 * kDegree);
  EXPECT_EQ(recordings[1].noise.accel_density, MtxNoise().accel_density);
}

TEST(TrialFolder, LetsAnglesReplaceThoseOfTheLabel) {
  const TrialOnDisk disk([](ordered_json& json) { json["start_pose"]["elbow_flexion_deg"] = 90; });
  const HeldPose pose = *ReadTrial(disk.path()).trial.observations.start_pose;
  EXPECT_DOUBLE_EQ(*pose.elbow_flexion, 90 * kDegree);
  EXPECT_DOUBLE_EQ(*pose.forearm_pronation, 90 * kDegree);
}

TEST(TrialFolder, StartsThePoseWithTheRecordingWhenNoTimeIsGiven) {
  const TrialOnDisk disk([](ordered_json& json) {
    json["start_pose"] = {{"forearm_pronation_deg", 45}};
  });
  disk.Write("forearm.csv", RecordingText(200, 0.25));
  const HeldPose pose = *ReadTrial(disk.path()).trial.observations.start_pose;
  EXPECT_EQ(pose.time, 0.25);
  EXPECT_FALSE(pose.elbow_flexion.has_value());
}

TEST(TrialFolder, TakesTheEndPoseForThatOfTheEndOfTheCommonTime) {
  const TrialOnDisk disk([](ordered_json& json) {
    json["end_pose"] = {{"label", "arms_along_body_thumbs_forward"}, {"sd_deg", 5}};
  });
  disk.Write("forearm.csv", RecordingText(150));
  const TrialFolder folder = ReadTrial(disk.path());
  const HeldPose pose = *folder.trial.observations.end_pose;
  EXPECT_DOUBLE_EQ(pose.time, folder.trial.observations.recordings[1].time.back());
  EXPECT_DOUBLE_EQ(*pose.forearm_pronation, 90 * kDegree);
  EXPECT_DOUBLE_EQ(pose.sigma, 5 * kDegree);
  EXPECT_THAT(folder.defaults, Contains(HasSubstr("end_pose.at_s = 1.49 s")));
}

TEST(TrialFolder, TakesContactsAndNamesThosePlacesThatHaveNoName) {
  const TrialOnDisk disk([](ordered_json& json) {
    json["contacts"] = {
        {{"point", "wrist"}, {"at_s", {0.2, 1.2}}, {"place", "edge"}, {"sigma_m", 0.02}},
        {{"point", "elbow"}, {"at_s", {0.5, 0.7, 0.9}}, {"axes", "height"}}};
  });
  const TrialFolder folder = ReadTrial(disk.path());
  const std::vector<Contact>& contacts = folder.trial.observations.contacts;
  ASSERT_THAT(contacts, SizeIs(2));
  EXPECT_EQ(contacts[0].place, "edge");
  EXPECT_EQ(contacts[0].segment, Segment::kForearm);
  EXPECT_EQ(contacts[0].times, (std::vector<double>{0.2, 1.2}));
  EXPECT_EQ(contacts[0].sigma, 0.02);
  EXPECT_FALSE(contacts[0].height_only);
  EXPECT_EQ(contacts[1].place, "place_2");
  EXPECT_EQ(contacts[1].segment, Segment::kUpperArm);
  EXPECT_EQ(contacts[1].sigma, 0.01);
  EXPECT_TRUE(contacts[1].height_only);
  EXPECT_THAT(Joined(folder.defaults), HasSubstr("contacts[1].sigma_m = 0.01 m\n"));
}

TEST(TrialFolder, RefusesContactsWhereTheArmIsNotKnown) {
  const TrialOnDisk disk([](ordered_json& json) {
    json["recordings"].erase(1);
    json["contacts"] = {{{"point", "elbow"}, {"at_s", {0.2, 1.2}}}};
  });
  EXPECT_THAT(Complaint(disk), HasSubstr("contacts cannot be used"));
}

TEST(TrialFolder, KeepsALeftArmLeft) {
  const TrialOnDisk disk([](ordered_json& json) { json["arm"]["side"] = "left"; });
  const Observations observations = ReadTrial(disk.path()).trial.observations;
  EXPECT_EQ(observations.arm.side, Side::kLeft);
  EXPECT_DOUBLE_EQ(observations.recordings[0].gyr_S[0].x(), 1.6);
}

TEST(TrialFolder, NamesUnknownKeysAndColumnsWithTheNearestKnownOnes) {
  const TrialOnDisk disk([](ordered_json& json) {
    json["start_poes"] = 1;
    json["recordings"][0]["mountings"] = 1;
    json["intervals"][0]["label"] = "calibration:forearm_pronatoin";
  });
  disk.Write("forearm.csv", WithColumn(RecordingText(), "Mag_x", "1"));
  const std::string warnings = Joined(ReadTrial(disk.path()).warnings);
  EXPECT_THAT(warnings,
              HasSubstr("trial.json:" + std::to_string(disk.LineOf("trial.json", "start_poes")) +
                        ": start_poes is not a known key and was ignored; did you mean "
                        "'start_pose'?"));
  EXPECT_THAT(warnings, HasSubstr("recordings[0].mountings is not a known key"));
  EXPECT_THAT(warnings, HasSubstr("did you mean 'calibration:forearm_pronation'?"));
  EXPECT_THAT(warnings, HasSubstr("forearm.csv:1: the column 'Mag_x' is not known and was ignored; "
                                  "did you mean 'mag_x'?"));
}

TEST(TrialFolder, WarnsOfAnIntervalOutsideTheRecordings) {
  const TrialOnDisk disk([](ordered_json& json) { json["intervals"][0]["end_s"] = 100; });
  EXPECT_THAT(ReadTrial(disk.path()).warnings, Contains(HasSubstr("outside of the recordings")));
}

}  // namespace
}  // namespace brachium
