// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds damaged NIfTI and MGH files to the reader: plain, damaged after compression, and before it. Usage:
// volume_reader [seconds].
#include "corticle/formats/volumes/volume_reader.hpp"

#include "formats/volumes/mgh_samples.hpp"
#include "formats/volumes/nifti_samples.hpp"
#include "fuzz/reader_fuzz.hpp"

namespace corticle
{

namespace
{

std::vector<NiftiSample> images()
{
    std::vector<NiftiSample> result;
    for (const bool wide : {false, true})
    {
        for (const bool swapped : {false, true})
        {
            result.push_back(plain_sample(wide, swapped));
            result.push_back(plain_sample(wide, swapped));
            result.back().data<float>(formats::NumberType::float32, sample_labels());
            result.back().code(result.back().layout().qform_code, 1);
            result.push_back(plain_sample(wide, swapped));
            result.back().dimensions({2, 3, 2, 2}).data<std::int64_t>(formats::NumberType::int64, sample_labels());
            result.back().sform({Mat3::diagonal(-1, 1, 2), {1, 2, 3}});
        }
    }
    return result;
}

std::vector<Sample> samples()
{
    std::vector<Sample> result;
    for (const NiftiSample& image : images())
    {
        result.emplace_back("nii", image.bytes());
        result.emplace_back("nii", formats::gzip(image.bytes()));
        result.emplace_back("to_pack", image.bytes());
    }
    MghSample image;
    result.emplace_back("mgh", image.bytes());
    result.emplace_back("mgh", image.numbers<float>(3, sample_labels()).bytes());
    result.emplace_back("to_pack", image.bytes());
    return result;
}

/// What readers of a binary header trip over.
std::vector<std::string> awkward_numbers()
{
    return {"\x7f\xff",
            "\xff\x7f",
            std::string("\x7f\x80\0\0", 4),
            std::string("\0\0\xc0\x7f", 4),
            "\x7f\xff\xff\xff",
            std::string("\x80\0\0\0", 4),
            std::string("\x01\0", 2),
            std::string("\0\x01", 2)};
}

} // namespace

} // namespace corticle

int main(int argc, char** argv)
{
    using namespace corticle;
    limit_memory();
    return fuzz_reader(argc > 1 ? std::atof(argv[1]) : 10.0, samples(), awkward_numbers(),
                       [](const std::string& kind, const std::string& bytes)
                       {
                           const auto volume =
                               bytes.size() % 2 == 0 ? std::optional<std::int64_t>(bytes.size() % 3) : std::nullopt;
                           const std::string given = kind == "to_pack" ? formats::gzip(bytes) : bytes;
                           formats::parse_labels({given, {}}, "fuzz.nii", {volume, formats::Coordinates::scanner, {}});
                       });
}
