// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/nifti_fields.hpp"

#include "corticle/formats/format_error.hpp"

#include <fmt/format.h>

namespace corticle::formats
{

NiftiFields::NiftiFields(std::string_view start, InflatingStream& stream, const std::string& name) : name_(name)
{
    start.copy(bytes_.data(), 4);
    if (start.size() < 4 || !find_layout())
    {
        fail_reading(name, "not a NIfTI or MGH file",
                     start.size() < 4 ? fmt::format("{} bytes", start.size()) : first_bytes(),
                     "a header of 348 (NIfTI-1), 540 (NIfTI-2) or 284 bytes (MGH)");
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
    for (const bool big_endian : {false, true})
    {
        const auto size = load<std::int32_t>(bytes_.data(), big_endian);
        if (size == 348 || size == 540)
        {
            layout_ = size == 348 ? nifti1_layout : nifti2_layout;
            big_endian_ = big_endian;
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
    using namespace std::string_view_literals;
    const std::string_view magic(bytes_.data() + layout_.magic, layout_.wide ? 8 : 4);
    const std::string_view single = layout_.wide ? "n+2\0\r\n\032\n"sv : "n+1\0"sv;
    const std::string_view pair = layout_.wide ? "ni2\0\r\n\032\n"sv : "ni1\0"sv;
    if (magic == single || magic == pair)
    {
        return;
    }
    constexpr std::size_t regular = 38; // where ANALYZE 7.5 has an 'r', or nothing; it has no magic
    if (!layout_.wide && (magic == "\0\0\0\0"sv || (bytes_[regular] == 'r' && magic.front() != 'n')))
    {
        fail_reading(name_, "an ANALYZE 7.5 header, which does not say where left and right are", "no NIfTI magic",
                     "NIfTI or MGH");
    }
    fail_reading(name_, "wrong magic", fmt::format("\"{}\"", magic), layout_.wide ? "n+2 or ni2" : "n+1 or ni1");
}

} // namespace corticle::formats
