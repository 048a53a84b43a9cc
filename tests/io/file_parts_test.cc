#include "io/file_parts.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/input_error.h"
#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

TEST(FileParts, AreTheFileInItsOrder) {
  const TemporaryFolder folder;
  std::string bytes;
  for (int i = 0; i < 400000; ++i) bytes += std::to_string(i);
  folder.Write("f", bytes);
  const FileParts parts(folder.File("f"));
  ASSERT_EQ(parts.size(), bytes.size());
  std::string together;
  int count = 0;
  parts.ForEach([&](std::string_view part) {
    together += part;
    ++count;
  });
  EXPECT_EQ(together, bytes);
  EXPECT_GT(count, 1);
  EXPECT_EQ(parts.Read(1234567, 10), bytes.substr(1234567, 10));
}

TEST(FileParts, RefusesFoldersAbsentFilesAndWhatIsNotThereAnyMore) {
  const TemporaryFolder folder;
  EXPECT_THROW(FileParts(folder.path()), InputError);
  EXPECT_THROW(FileParts(folder.File("absent")), InputError);
  folder.Write("f", "ten bytes.");
  const FileParts parts(folder.File("f"));
  std::filesystem::resize_file(folder.File("f"), 4);
  EXPECT_THROW(parts.Read(0, parts.size()), InputError);
}

}  // namespace
}  // namespace brachium
