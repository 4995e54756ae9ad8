// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/freesurfer_labels.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/inflating_stream.hpp"
#include "corticle/formats/surfaces/surface_map.hpp"
#include "corticle/formats/surfaces/surface_reader.hpp"
#include "formats/surfaces/freesurfer_samples.hpp"
#include "formats/temporary_folder.hpp"
#include "formats/volumes/mgh_samples.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{

namespace
{

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<SampleStructure> structures{{5, "frontal", {25, 5, 25}}, {7, "temporal", {100, 250, 0}}};

std::vector<double> parsed(const std::string& kind, const std::string& bytes, const std::string& array = "")
{
    return formats::parse_surface_map(bytes, kind, "lh." + kind, array, 4);
}

std::string refusal(const std::string& kind, const std::string& bytes, const std::string& array = "")
{
    const std::string message = message_of<InputError>([&] { parsed(kind, bytes, array); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
}

std::vector<std::int32_t> sample_colours()
{
    return {packed_colour({100, 250, 0}), packed_colour({25, 5, 25}), 0, packed_colour({100, 250, 0})};
}

} // namespace

TEST(FreesurferLabels, AnnotationGivesNumbersOfStructures)
{
    EXPECT_THAT(parsed("annot", annotation(sample_colours(), structures)), ElementsAre(7, 5, -1, 7));
    EXPECT_THAT(parsed("annot", annotation(sample_colours(), structures, false)), ElementsAre(1, 0, -1, 1));
    EXPECT_THAT(refusal("annot", annotation({1, 2, 3}, structures)), HasSubstr("got 3 values; expected 4"));
}

TEST(FreesurferLabels, RefusesDamagedAnnotations)
{
    const std::string good = annotation(sample_colours(), structures);
    for (std::size_t size = 0; size < good.size(); ++size)
    {
        EXPECT_THROW(parsed("annot", good.substr(0, size)), InputError) << size;
    }
    const std::vector<SampleStructure> twins{{5, "a", {100, 250, 0}}, {7, "b", {100, 250, 0}}};
    EXPECT_THAT(refusal("annot", annotation(sample_colours(), twins)),
                HasSubstr("two structures of one colour, so that vertices do not tell them apart; got (100, 250, 0)"));
    std::string twice = good;
    twice.replace(4, 4, std::string("\0\0\0\2", 4));
    EXPECT_THAT(refusal("annot", twice), HasSubstr("bad vertex"));
    EXPECT_THAT(refusal("annot", good.substr(0, 36)), HasSubstr("without a colour table"));
}

TEST(FreesurferLabels, LabelIsOneAtItsVertices)
{
    const std::string label = "#!ascii label  , from subject a\n2\n3  1.0 2.0 3.0 0.5\n1 -1 -2 -3 0\n";
    EXPECT_THAT(parsed("label", label), ElementsAre(0, 1, 0, 1));
    EXPECT_THAT(parsed("label", "#!ascii label\n0\n"), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(refusal("label", "#!ascii label\n1\n4 0 0 0 0\n"), HasSubstr("got vertex 4; expected 0 to 3"));
    EXPECT_THAT(refusal("label", "#!ascii label\n2\n1 0 0 0 0\n"), HasSubstr("the end of the data"));
    EXPECT_THAT(refusal("label", "#!ascii label\n1\n1 0 0 0 0\n2 0 0 0 0\n"), HasSubstr("text behind"));
    EXPECT_THAT(refusal("label", "#!ascii label\n999999999\n"), HasSubstr("bad number of vertices"));
}

TEST(FreesurferLabels, TextScalarsCountTheirVertices)
{
    EXPECT_THAT(parsed("asc", "000 1 2 3 0.5\n001 1 2 3 -1\n002 1 2 3 2\n003 1 2 3 4\n"), ElementsAre(0.5, -1, 2, 4));
    EXPECT_THAT(refusal("asc", "000 1 2 3 0.5\n002 1 2 3 -1\n"), HasSubstr("got vertex 2; expected vertex 1"));
}

TEST(FreesurferLabels, TextSurface)
{
    const std::string text = freesurfer_text_surface(tetrahedron());
    std::vector<std::string> notes;
    const TriangleMesh mesh = formats::parse_surface(text, "asc", "lh.white.asc", {1.0, {}, &notes});
    EXPECT_EQ(mesh.vertices, tetrahedron().vertices);
    EXPECT_EQ(mesh.triangles, tetrahedron().triangles);
    EXPECT_THAT(notes, ElementsAre(HasSubstr("does not say where its volume lies")));
    for (std::size_t size = 0; size + 4 < text.size(); size += 3)
    {
        EXPECT_THROW(formats::parse_surface(text.substr(0, size), "asc", "cut.asc"), InputError) << size;
    }
    EXPECT_THROW(formats::parse_surface(text + "7\n", "asc", "long.asc"), InputError);
}

TEST(FreesurferLabels, MapsInMghHaveOneVoxelAVertex)
{
    const TemporaryFolder folder;
    MghSample sample;
    sample.size = {4, 1, 1, 2};
    sample.numbers<float>(3, std::vector<double>{1, 2, 3, 4, 0.5, -1.25, 3, 8});
    EXPECT_THAT(parsed("mgh", sample.bytes(), "1"), ElementsAre(0.5, -1.25, 3, 8));
    EXPECT_THAT(refusal("mgh", sample.bytes()), HasSubstr("which array is not said; got 2 maps; expected 0 to 1"));
    EXPECT_THAT(refusal("mgh", sample.bytes(), "2"), HasSubstr("no such array; got 2"));
    sample.size = {4, 1, 1, 1};
    put_bytes(folder / "lh.thickness.MGZ", formats::gzip(sample.bytes()));
    EXPECT_THAT(formats::read_surface_map(folder / "lh.thickness.MGZ", "", 4), ElementsAre(1, 2, 3, 4));
    EXPECT_TRUE(formats::is_vertex_image(folder / "lh.thickness.MGZ", 4));
    EXPECT_FALSE(formats::is_vertex_image(folder / "lh.thickness.MGZ", 5));
    EXPECT_FALSE(formats::is_vertex_image(folder / "lh.thickness", 4));
    sample.size = {2, 2, 1, 1};
    put_bytes(folder / "volume.mgz", formats::gzip(sample.bytes()));
    EXPECT_FALSE(formats::is_vertex_image(folder / "volume.mgz", 4));
    sample.size = {5, 1, 1, 1};
    EXPECT_THAT(refusal("mgh", sample.bytes()), HasSubstr("got 5 values; expected 4"));
}

} // namespace corticle
