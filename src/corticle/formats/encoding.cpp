// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/encoding.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/quiet_vtk.hpp"

#include <vtkLZ4DataCompressor.h>
#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

namespace corticle::formats
{

namespace
{

const unsigned char* unsigned_bytes(std::string_view bytes)
{
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

template <class Decoder>
bool unpack(std::string_view packed, char* out, std::size_t size)
{
    silence_vtk(); // damaged blocks are reported by the caller
    vtkNew<Decoder> decoder;
    return size ==
           decoder->Uncompress(unsigned_bytes(packed), packed.size(), reinterpret_cast<unsigned char*>(out), size);
}

} // namespace

bool unpack_zlib(std::string_view packed, char* out, std::size_t size)
{
    return unpack<vtkZLibDataCompressor>(packed, out, size);
}

bool unpack_lz4(std::string_view packed, char* out, std::size_t size)
{
    return unpack<vtkLZ4DataCompressor>(packed, out, size);
}

std::string pack_zlib(std::string_view bytes)
{
    vtkNew<vtkZLibDataCompressor> encoder;
    std::string packed(encoder->GetMaximumCompressionSpace(bytes.size()), '\0');
    const std::size_t size = encoder->Compress(unsigned_bytes(bytes), bytes.size(),
                                               reinterpret_cast<unsigned char*>(packed.data()), packed.size());
    if (size == 0)
    {
        throw RunError("zlib could not compress data of " + std::to_string(bytes.size()) + " bytes");
    }
    packed.resize(size);
    return packed;
}

std::string to_base64(std::string_view bytes)
{
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3)
    {
        const std::string_view group = bytes.substr(i, 3);
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
        {
            bits = bits << 8 | (k < group.size() ? static_cast<unsigned char>(group[k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k)
        {
            text.push_back(k <= group.size() ? digits[bits >> (18 - 6 * k) & 63u] : '=');
        }
    }
    return text;
}

} // namespace corticle::formats
