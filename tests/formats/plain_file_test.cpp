// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/plain_file.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/inflating_stream.hpp"
#include "corticle/formats/surfaces/surface_map.hpp"
#include "corticle/formats/surfaces/surface_reader.hpp"
#include "formats/gifti_samples.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(PlainFile, UnpacksWhateverIsPacked)
{
    const TemporaryFolder folder;
    put_bytes(folder / "A.SURF.GII.GZ", formats::gzip(gifti_surface(tetrahedron(), {"Base64Binary"})));
    put_bytes(folder / "a.stl.gz", formats::gzip(stl_binary(tetrahedron())));
    put_bytes(folder / "packed_in_silence.obj", formats::gzip(obj_text(tetrahedron())));
    put_bytes(folder / "not_packed.obj.gz", obj_text(tetrahedron()));
    for (const char* name : {"A.SURF.GII.GZ", "a.stl.gz", "packed_in_silence.obj", "not_packed.obj.gz"})
    {
        EXPECT_EQ(formats::read_surface(folder / name).triangles.size(), 4u) << name;
    }
    put_bytes(folder / "a.shape.gii.gz", formats::gzip(gifti_scalars({}, {1, 2, 3, 4})));
    EXPECT_THAT(formats::read_surface_map(folder / "a.shape.gii.gz", "depth", 4), ElementsAre(1, 2, 3, 4));
}

TEST(PlainFile, RefusesBombsAndBrokenArchives)
{
    const std::string bomb = formats::gzip(std::string(std::size_t{300} << 20, '\0'));
    EXPECT_LT(bomb.size(), std::size_t{1} << 20);
    EXPECT_THAT(message_of<InputError>([&] { formats::unpacked(bomb, "bomb.gii.gz"); }),
                HasSubstr("bomb.gii.gz: unpacks to more than any mesh or map does"));
    const std::string packed = formats::gzip(obj_text(tetrahedron()));
    EXPECT_EQ(formats::unpacked(packed + packed, "two"), obj_text(tetrahedron()) + obj_text(tetrahedron()));
    for (std::size_t size = 2; size < packed.size(); ++size)
    {
        EXPECT_THROW(formats::unpacked(packed.substr(0, size), "cut.gz"), InputError) << size;
    }
}

} // namespace corticle
