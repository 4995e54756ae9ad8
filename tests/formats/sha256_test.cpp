// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/sha256.hpp"

#include "formats/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace corticle
{

/// Examples of FIPS 180-2, appendix B.
TEST(Sha256, GivesThePublishedExamples)
{
    const TemporaryFolder folder;
    put_bytes(folder / "abc", "abc");
    EXPECT_EQ(formats::sha256_of_file(folder / "abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    put_bytes(folder / "million", std::string(1000000, 'a'));
    put_bytes(folder / "empty", "");
    EXPECT_EQ(formats::sha256_of_file(folder / "million"),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    EXPECT_EQ(formats::sha256_of_file(folder / "empty"),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, OfAFileLongerThanItsBufferDependsOnEveryByte)
{
    const TemporaryFolder folder;
    std::string text(3 << 20, 'x');
    put_bytes(folder / "one", text);
    text.back() = 'y';
    put_bytes(folder / "two", text);
    EXPECT_NE(formats::sha256_of_file(folder / "one"), formats::sha256_of_file(folder / "two"));
}

TEST(Sha256, IsEmptyWhereThereIsNoFile)
{
    const TemporaryFolder folder;
    EXPECT_EQ(formats::sha256_of_file(folder / "none"), "");
    EXPECT_EQ(formats::sha256_of_file(folder.path()), "");
}

} // namespace corticle
