// Made-up exports: the same turning sensor as each maker's program would write it.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "io/formats/export_format.h"
#include "io/formats/read_export.h"
#include "io/input_error.h"
#include "io/text.h"

namespace brachium {

inline const std::filesystem::path kSamples =
    std::filesystem::path(BRACHIUM_SOURCE_DIR) / "../shared/data/formats";

// A sensor that rolls to and fro about its x axis under gravity alone.
struct Turn {
  explicit Turn(double t)
      : angle(0.8 * std::sin(2.0 * t)),
        rate(1.6 * std::cos(2.0 * t)),
        acc_y(9.81 * std::sin(angle)),
        acc_z(9.81 * std::cos(angle)) {}
  double angle, rate, acc_y, acc_z;
};

struct MtOptions {
  std::string header = "// Start Time: Unknown\n// Update Rate: 100.0Hz\n";
  char delimiter = '\t';
  int first = 100;  // counter
  int rows = 200;
  int lost_after = -1;  // row after which three packets are lost
};

inline std::string MtText(const MtOptions& options = {}) {
  std::string text =
      options.header + "PacketCounter|SampleTimeFine|Acc_X|Acc_Y|Acc_Z|Gyr_X|Gyr_Y|Gyr_Z\n";
  for (int i = 0; i < options.rows; ++i) {
    const int count = i + (options.lost_after >= 0 && i > options.lost_after ? 3 : 0);
    const Turn turn(0.01 * count - 0.005);
    text += std::to_string((options.first + count) % 65536) + "||0|" + Shortest(turn.acc_y) + "|" +
            Shortest(turn.acc_z) + "|" + Shortest(turn.rate) + "|0|0\n";
  }
  std::ranges::replace(text, '|', options.delimiter);
  return text;
}

inline std::string DotText(const std::string& columns = "Acc_X,Acc_Y,Acc_Z,Gyr_X,Gyr_Y,Gyr_Z") {
  std::string text = "sep=,\nDeviceTag:,Wrist\nOutputRate:,60Hz\nSyncStatus:,Synced\n\n";
  text += "PacketCounter,SampleTimeFine," + columns + ",Status\n";
  for (int i = 0; i < 200; ++i) {
    const double t = i / 60.0;
    const Turn turn(t - 0.5 / 60.0);
    const auto ticks = static_cast<long long>(4294000000.0 + 1e6 * t) % 4294967296LL;
    text += std::to_string(i + 1) + "," + std::to_string(ticks) + ",0," + Shortest(turn.acc_y) +
            "," + Shortest(turn.acc_z) + "," + Shortest(turn.rate * 180.0 / M_PI) + ",0,0,0,\n";
  }
  return text;
}

inline std::string ApdmOldText() {
  std::string text = "Test Name:,Swing,,\nSample Rate:,128,Hz,\nTime";
  for (const std::string sensor : {"Wrist", "Upper"})
    for (const std::string quantity : {"Acceleration", "Angular Velocity"})
      for (const char axis : {'X', 'Y', 'Z'}) text += "," + sensor + "/" + quantity + "/" + axis;
  text += "\ns,m/s^2,m/s^2,m/s^2,deg/s,deg/s,deg/s,g,g,g,rad/s,rad/s,rad/s\n";
  for (int i = 0; i < 200; ++i) {
    const Turn turn(i / 128.0);
    text += Shortest(i / 128.0) + ",0," + Shortest(turn.acc_y) + "," + Shortest(turn.acc_z) + "," +
            Shortest(turn.rate * 180.0 / M_PI) + ",0,0,0," + Shortest(turn.acc_y / 9.80665) + "," +
            Shortest(turn.acc_z / 9.80665) + "," + Shortest(turn.rate) + ",0,0\n";
  }
  return text;
}

inline std::string ApdmNewText() {
  std::string text =
      "Format=7,11,,,Left Wrist,,,12,,,Right Wrist,,\n"
      "Time,Accelerometer,,,Gyroscope,,,Accelerometer,,,Gyroscope,,\n"
      ",X,Y,Z,X,Y,Z,X,Y,Z,X,Y,Z\n";
  for (int i = 0; i < 200; ++i) {
    const Turn turn(i / 128.0);
    const std::string cells = ",0," + Shortest(turn.acc_y) + "," + Shortest(turn.acc_z) + "," +
                              Shortest(turn.rate) + ",0,0";
    text += std::to_string(1550879504438281 + static_cast<long long>(i * 7812.5)) + cells + cells +
            "\n";
  }
  return text;
}

inline std::string XioText() {
  std::string text =
      "Time (s),Gyroscope X (deg/s),Gyroscope Y (deg/s),Gyroscope Z (deg/s),"
      "Accelerometer X (g),Accelerometer Y (g),Accelerometer Z (g)\n";
  for (int i = 0; i < 200; ++i) {
    const double t = 0.01 * i + 0.001 * (i % 3);
    const Turn turn(t);
    text += Shortest(5.0 + t) + "," + Shortest(turn.rate * 180.0 / M_PI) + ",0,0,0," +
            Shortest(turn.acc_y / 9.80665) + "," + Shortest(turn.acc_z / 9.80665) + "\n";
  }
  return text;
}

inline std::string BidsChannels() {
  std::string text = "name\tcomponent\ttype\ttracked_point\tunits\n";
  for (const std::string type : {"GYRO", "ACCEL"})
    for (const char axis : {'x', 'y', 'z'})
      text += "wrist_" + type + "_" + axis + "\t" + axis + "\t" + type + "\twrist\t" +
              (type == "GYRO" ? "deg/s" : "m/s^2") + "\n";
  return text;
}

inline std::string BidsText() {
  std::string text;
  for (int i = 0; i < 200; ++i) {
    const Turn turn(i / 50.0);
    text += i == 7 ? "n/a" : Shortest(turn.rate * 180.0 / M_PI);
    text += "\t0\t0\t0\t" + Shortest(turn.acc_y) + "\t" + Shortest(turn.acc_z) + "\n";
  }
  return text;
}

// One sensor of a text, through the same door as that of a trial folder.
inline RecordingFile ReadText(std::string_view format, const std::string& text,
                              const std::string& path = "MT_01-000_00B42D4B.txt",
                              const std::string& sensor = "", ExportClock clock = {},
                              Findings* findings = nullptr) {
  Findings unread;
  return ReadExport(*FindExportFormat(format), {.path = path, .name = path, .text = text}, sensor,
                    Segment::kForearm, &clock, findings != nullptr ? findings : &unread);
}

inline std::string Refusal(std::string_view format, const std::string& text,
                           const std::string& path = "MT_01-000_00B42D4B.txt",
                           const std::string& sensor = "") {
  try {
    ReadText(format, text, path, sensor);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// That each sample is what the sensor did at the time that it carries.
inline void ExpectTheTurn(const Recording& recording, double origin, double tolerance = 1e-6) {
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const Turn turn(recording.time[i] + origin);
    EXPECT_NEAR(recording.gyr_S[i].x(), turn.rate, tolerance) << i;
    EXPECT_NEAR(recording.acc_S[i].y(), turn.acc_y, tolerance) << i;
    EXPECT_NEAR(recording.acc_S[i].z(), turn.acc_z, tolerance) << i;
  }
}

}  // namespace brachium
