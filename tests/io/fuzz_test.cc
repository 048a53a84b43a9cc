// Damaged files, thousands of them: each is read, or refused as a wrong file; nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/io/trial_fixture.h"

namespace brachium {
namespace {

class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  // The text with one to four places changed, taken out, doubled, or cut off behind.
  std::string To(std::string text) {
    const std::size_t wounds = 1 + Below(4);
    for (std::size_t i = 0; i < wounds && !text.empty(); ++i) Wound(&text);
    return text;
  }

 private:
  std::size_t Below(std::size_t n) { return random_() % n; }

  void Wound(std::string* text) {
    static constexpr std::string_view kNasty[] = {"\n",
                                                  ",",
                                                  "-",
                                                  "1e308",
                                                  "nan",
                                                  "inf",
                                                  "\"",
                                                  "{",
                                                  "}",
                                                  "[",
                                                  "]",
                                                  ":",
                                                  "null",
                                                  "true",
                                                  "0",
                                                  "-1",
                                                  "99999999999999999999",
                                                  "\r",
                                                  ",,",
                                                  "\\u0000",
                                                  "e",
                                                  ".",
                                                  " ",
                                                  "1e-320"};
    const std::size_t at = Below(text->size());
    const std::size_t length = std::min(1 + Below(20), text->size() - at);
    switch (Below(6)) {
      case 0:
        (*text)[at] = static_cast<char>(Below(256));
        return;
      case 1:
        text->erase(at, length);
        return;
      case 2:
        text->insert(at, text->substr(at, length));
        return;
      case 3:
        text->insert(at, kNasty[Below(std::size(kNasty))]);
        return;
      case 4:
        text->replace(at, length, kNasty[Below(std::size(kNasty))]);
        return;
      default:
        if (Below(8) == 0) text->resize(at);
    }
  }

  std::mt19937 random_;
};

// How many of `count` damaged copies of a file are still read. Whatever escapes as anything but an
// InputError fails the test.
int CountRead(const char* file, unsigned seed, int count) {
  const TrialOnDisk disk;
  if (std::string(file) != "trial.json") disk.Write(file, disk.Read(file).substr(0, 3000));
  const std::string sound = disk.Read(file);
  Damage damage(seed);
  int read = 0;
  for (int i = 0; i < count; ++i) {
    disk.Write(file, damage.To(sound));
    try {
      ReadTrial(disk.path());
      ++read;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(": "), std::string::npos);
    } catch (const std::exception& error) {
      ADD_FAILURE() << "damage " << i << " of " << file << " escaped: " << error.what();
    }
  }
  return read;
}

TEST(Fuzz, ADamagedTrialJsonIsReadOrRefused) {
  const int read = CountRead("trial.json", 1, 1500);
  EXPECT_GT(read, 20);
  EXPECT_LT(read, 1400);
}

TEST(Fuzz, ADamagedRecordingIsReadOrRefused) {
  const int read = CountRead("forearm.csv", 2, 1500);
  EXPECT_GT(read, 20);
  EXPECT_LT(read, 1400);
}

TEST(Fuzz, ADamagedReferenceIsReadOrRefused) {
  const int read = CountRead("reference.csv", 3, 1000);
  EXPECT_GT(read, 20);
  EXPECT_LT(read, 900);
}

}  // namespace
}  // namespace brachium
