// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/byte_source.hpp"
#include "corticle/formats/encoding.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/formats/vtk_xml.hpp"

#include <fmt/format.h>

namespace corticle::formats
{

namespace
{

std::string damaged(const VtkXmlArray& array)
{
    return fmt::format("truncated or damaged array \"{}\"", array.name);
}

/// Bytes of one number, 0 for a type that is not known.
std::size_t size_of(std::string_view type)
{
    const std::string_view digits = type.substr(
        type.find_first_of("0123456789") == std::string_view::npos ? type.size() : type.find_first_of("0123456789"));
    const std::string_view kind = type.substr(0, type.size() - digits.size());
    const bool is_whole =
        (kind == "Int" || kind == "UInt") && (digits == "8" || digits == "16" || digits == "32" || digits == "64");
    const bool is_real = kind == "Float" && (digits == "32" || digits == "64");
    return !is_whole && !is_real ? 0 : (digits == "8" ? 1 : (digits == "16" ? 2 : (digits == "32" ? 4 : 8)));
}

template <class Stored, class Number>
void convert(const std::string& bytes, bool big_endian, std::vector<Number>& values)
{
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        const Stored stored = load<Stored>(bytes.data() + i * sizeof(Stored), big_endian);
        if constexpr (std::is_floating_point_v<Stored> && std::is_integral_v<Number>)
        {
            const bool fits = stored > Stored(-9e18) && stored < Stored(9e18);
            values[i] = fits ? static_cast<Number>(stored) : Number{-1};
        }
        else
        {
            values[i] = static_cast<Number>(stored);
        }
    }
}

template <class Number>
void convert(const std::string& bytes, std::string_view type, bool big, std::vector<Number>& values)
{
    const bool is_signed = type.front() == 'I';
    switch (size_of(type))
    {
    case 1:
        return is_signed ? convert<std::int8_t>(bytes, big, values) : convert<std::uint8_t>(bytes, big, values);
    case 2:
        return is_signed ? convert<std::int16_t>(bytes, big, values) : convert<std::uint16_t>(bytes, big, values);
    case 4:
        return type.front() == 'F' ? convert<float>(bytes, big, values)
               : is_signed         ? convert<std::int32_t>(bytes, big, values)
                                   : convert<std::uint32_t>(bytes, big, values);
    default:
        return type.front() == 'F' ? convert<double>(bytes, big, values)
               : is_signed         ? convert<std::int64_t>(bytes, big, values)
                                   : convert<std::uint64_t>(bytes, big, values);
    }
}

} // namespace

/// The sizes before an array: bytes, or blocks when compressed.
std::uint64_t VtkXmlFile::take_size(ByteSource& source, const VtkXmlArray& array) const
{
    std::string header;
    if (!source.take(header_bytes_, header))
    {
        fail(damaged(array), "the end of the data", "its size");
    }
    return header_bytes_ == 8 ? load<std::uint64_t>(header.data(), big_endian_)
                              : load<std::uint32_t>(header.data(), big_endian_);
}

std::string VtkXmlFile::unpacked_blocks(ByteSource& source, const VtkXmlArray& array, std::size_t size) const
{
    const std::uint64_t blocks = take_size(source, array);
    const std::uint64_t block = take_size(source, array);
    const std::uint64_t last = take_size(source, array); // 0 when the last block is full
    const std::uint64_t full = last == 0 ? blocks : blocks - 1;
    const bool good = blocks > 0 && block > 0 && full <= size / block && last <= block && full * block + last == size;
    if (!good)
    {
        fail(damaged(array), fmt::format("{} blocks of {} bytes, the last of {}", blocks, block, last),
             fmt::format("{} bytes in all", size));
    }
    std::vector<std::uint64_t> packed_sizes;
    for (std::uint64_t i = 0; i < blocks; ++i)
    {
        packed_sizes.push_back(take_size(source, array));
    }
    const auto unpack = compressor_ == "vtkLZ4DataCompressor" ? unpack_lz4 : unpack_zlib;
    std::string bytes(size, '\0');
    std::string packed;
    for (std::size_t i = 0; i < blocks; ++i)
    {
        packed.clear();
        const std::size_t unpacked = i < full ? block : last;
        // Packing never makes a block much larger: so no array can make the reader go over the whole file again.
        const bool plausible = packed_sizes[i] <= 2 * unpacked + 1024;
        if (!plausible || !source.take(packed_sizes[i], packed) || !unpack(packed, bytes.data() + i * block, unpacked))
        {
            fail(damaged(array), fmt::format("a bad block {} of {}", i, blocks), fmt::format("{} bytes", unpacked));
        }
    }
    return bytes;
}

std::string VtkXmlFile::decoded_bytes(const VtkXmlArray& array, std::size_t size) const
{
    const bool is_appended = array.format == "appended";
    if (is_appended && static_cast<std::uint64_t>(array.offset) > appended_.size())
    {
        fail(damaged(array), fmt::format("offset {}", array.offset), fmt::format("at most {}", appended_.size()));
    }
    ByteSource source(is_appended ? appended_.substr(static_cast<std::size_t>(array.offset)) : array.content,
                      !is_appended || appended_base64_);
    if (!compressor_.empty())
    {
        return unpacked_blocks(source, array, size);
    }
    std::string bytes;
    const std::uint64_t announced = take_size(source, array);
    if (announced != size || !source.take(size, bytes))
    {
        fail(damaged(array), fmt::format("{} bytes announced", announced), fmt::format("{} bytes", size));
    }
    return bytes;
}

template <class Number>
std::vector<Number> VtkXmlFile::text_numbers(const VtkXmlArray& array, std::size_t count) const
{
    std::vector<Number> values;
    std::string_view text = array.content;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text))
    {
        Number value{};
        if (values.size() == count || !to_number(word, value))
        {
            fail(fmt::format("bad number in array \"{}\"", array.name), word, fmt::format("{} numbers", count));
        }
        values.push_back(value);
    }
    if (values.size() != count)
    {
        fail(fmt::format("array \"{}\" has too few numbers", array.name), fmt::format("{}", values.size()),
             fmt::format("{}", count));
    }
    return values;
}

template <class Number>
std::vector<Number> VtkXmlFile::numbers(const VtkXmlArray& array, std::int64_t count) const
{
    const std::size_t number_size = size_of(array.type);
    if (number_size == 0)
    {
        fail(fmt::format("unknown type of array \"{}\"", array.name), array.type, "Int8 to UInt64, Float32 or Float64");
    }
    const auto size = static_cast<std::uint64_t>(count);
    if (count < 0 || size > budget_ / sizeof(Number))
    {
        fail(fmt::format("array \"{}\" is larger than the file can hold", array.name), fmt::format("{} numbers", count),
             fmt::format("at most {}", budget_ / sizeof(Number)));
    }
    budget_ -= size * sizeof(Number);
    if (count == 0)
    {
        return {};
    }
    if (array.format == "ascii")
    {
        return text_numbers<Number>(array, size);
    }
    const std::string bytes = decoded_bytes(array, size * number_size);
    std::vector<Number> values(size);
    convert(bytes, array.type, big_endian_, values);
    return values;
}

std::vector<double> VtkXmlFile::doubles(const VtkXmlArray& array, std::int64_t count) const
{
    return numbers<double>(array, count);
}

std::vector<std::int64_t> VtkXmlFile::integers(const VtkXmlArray& array, std::int64_t count) const
{
    return numbers<std::int64_t>(array, count);
}

} // namespace corticle::formats
