// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/nifti_fields.hpp"

#include "corticle/formats/format_error.hpp"

#include <fmt/format.h>

namespace corticle::formats
{

NiftiFields::NiftiFields(InflatingStream& stream, const std::string& name) : name_(name)
{
    const std::size_t there = stream.read(bytes_.data(), 4);
    if (there < 4 || !find_layout())
    {
        fail_reading(name, "not a NIfTI file", there < 4 ? fmt::format("{} bytes", there) : first_bytes(),
                     "a header of 348 (NIfTI-1) or 540 bytes (NIfTI-2)");
    }
    const std::size_t rest = stream.read(bytes_.data() + 4, layout_.size - 4);
    if (rest < layout_.size - 4)
    {
        fail_reading(name, "truncated in its header", fmt::format("{} bytes", rest + 4),
                     fmt::format("{}", layout_.size));
    }
    require_magic();
}

bool NiftiFields::find_layout()
{
    for (const bool swapped : {false, true})
    {
        const auto size = number_at<std::int32_t>(bytes_.data(), swapped);
        if (size == 348 || size == 540)
        {
            layout_ = size == 348 ? nifti1_layout : nifti2_layout;
            swapped_ = swapped;
            return true;
        }
    }
    return false;
}

std::string NiftiFields::first_bytes() const
{
    std::string text = "the bytes";
    for (int k = 0; k < 4; ++k)
    {
        text += fmt::format(" {:02x}", static_cast<unsigned>(static_cast<unsigned char>(bytes_[k])));
    }
    return text;
}

void NiftiFields::require_magic() const
{
    const std::string_view magic(bytes_.data() + layout_.magic, layout_.wide ? 8 : 4);
    const std::string_view single =
        layout_.wide ? std::string_view("n+2\0\r\n\032\n", 8) : std::string_view("n+1\0", 4);
    if (magic.substr(0, 3) == "ni1" || magic.substr(0, 3) == "ni2")
    {
        fail_reading(name_, "a pair of header and image files", magic.substr(0, 3), "a single .nii or .nii.gz file");
    }
    if (magic != single)
    {
        fail_reading(name_, "wrong magic", fmt::format("\"{}\"", magic), layout_.wide ? "n+2" : "n+1");
    }
}

} // namespace corticle::formats
