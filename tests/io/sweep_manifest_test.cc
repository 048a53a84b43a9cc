#include "io/sweep_manifest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "io/input_error.h"
#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

// Lines from three hundred bytes to thousands.
SweepTask TaskNumber(std::size_t index) {
  SweepTask task{.index = index,
                 .trial = "trial",
                 .path = std::string(index % 7 == 0 ? 40 * (index % 300) : 5, 'p'),
                 .method = "gyroscope",
                 .options = {{"number", index}}};
  task.key = KeyOf(task);
  return task;
}

std::string Lines(std::size_t tasks) {
  std::string text;
  for (std::size_t i = 0; i < tasks; ++i) text += ManifestLine(TaskNumber(i));
  return text;
}

TEST(SweepManifest, FindsEveryTaskInAnyOrder) {
  const TemporaryFolder folder;
  for (const std::size_t tasks : {1, 2, 3, 17, 1000}) {
    folder.Write("manifest.jsonl", Lines(tasks));
    const SweepManifest manifest(folder.File("manifest.jsonl"));
    ASSERT_EQ(manifest.size(), tasks);
    std::vector<std::size_t> order(tasks);
    std::iota(order.begin(), order.end(), 0);
    for (int round = 0; round < 2; ++round) {
      for (const std::size_t i : order) EXPECT_EQ(manifest.At(i).key, TaskNumber(i).key);
      std::shuffle(order.begin(), order.end(), std::mt19937(1));
    }
  }
}

TEST(SweepManifest, RefusesLinesThatAreMissingTwiceThereOrEmpty) {
  const TemporaryFolder folder;
  const std::string one = ManifestLine(TaskNumber(1));
  for (const std::string& wrong : {std::string(), one + one, std::string("\n"), one.substr(1)}) {
    std::string text = Lines(20);
    folder.Write("manifest.jsonl", text.replace(text.find(one), one.size(), wrong));
    const SweepManifest manifest(folder.File("manifest.jsonl"));
    EXPECT_THROW(for (std::size_t i = 0; i < manifest.size(); ++i) manifest.At(i), InputError);
  }
}

TEST(SweepManifest, RefusesAFileThatDoesNotEndWithATask) {
  const TemporaryFolder folder;
  for (const std::string& text :
       {std::string(), std::string("{"), Lines(2) + "{\"task\":2", Lines(2) + "\n"}) {
    folder.Write("manifest.jsonl", text);
    EXPECT_THROW(SweepManifest(folder.File("manifest.jsonl")), InputError);
  }
}

}  // namespace
}  // namespace brachium
