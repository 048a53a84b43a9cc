#include "io/file_bytes.h"

#include <gtest/gtest.h>

#include "io/input_error.h"
#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

TEST(FileBytes, HoldsTheBytesOfAFile) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n", 4);
  folder.Write("f", bytes);
  folder.Write("empty", "");
  EXPECT_EQ(FileBytes(folder.File("f")).text(), bytes);
  EXPECT_EQ(FileBytes(folder.File("empty")).text(), "");
}

TEST(FileBytes, RefusesFoldersAndAbsentFiles) {
  const TemporaryFolder folder;
  EXPECT_THROW(FileBytes(folder.path()), InputError);
  EXPECT_THROW(FileBytes(folder.File("absent")), InputError);
}

// The examples of FIPS 180-2.
TEST(Sha256, AgreesWithThePublishedExamples) {
  EXPECT_EQ(Sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(Sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace brachium
