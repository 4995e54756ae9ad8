// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/checkpoint.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/formats/checksum.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/record/checkpoint_image.hpp"

#include <fmt/format.h>

namespace corticle::record
{

namespace
{

// A checkpoint is an HDF5 file behind a user block of 512 bytes, which HDF5 leaves to the application. The block holds
// the size and a checksum of all that follows, so damage is found before HDF5 sees a byte: HDF5 itself does not survive
// every damaged file.
constexpr std::size_t block_size = 512;
constexpr std::string_view magic = "corticle checkpoint 1\n";

std::string user_block(std::string_view image)
{
    std::string block = fmt::format("{}{} bytes\n{:016x} checksum\n", magic, image.size(), formats::checksum(image));
    block.resize(block_size, '\n');
    return block;
}

} // namespace

void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint)
{
    std::string bytes(block_size, '\n');
    if (!append_checkpoint_image(checkpoint, bytes))
    {
        throw RunError(fmt::format("cannot write {}: HDF5 could not build the file in memory", file.string()));
    }
    const std::string block = user_block(std::string_view(bytes).substr(block_size));
    bytes.replace(0, block_size, block);
    formats::write_text_atomically(file, bytes);
    formats::flush_names(file.parent_path());
}

Checkpoint read_checkpoint(const std::filesystem::path& file)
{
    const std::string bytes = formats::read_whole_file(file);
    const std::string name = file.string();
    if (bytes.size() < block_size || bytes.compare(0, magic.size(), magic) != 0)
    {
        formats::fail_reading(name, "not a checkpoint of this program",
                              fmt::format("{} bytes that begin otherwise", bytes.size()),
                              "a checkpoint.h5 of format 1");
    }
    const std::string_view image = std::string_view(bytes).substr(block_size);
    std::string_view announced = std::string_view(bytes).substr(magic.size(), block_size - magic.size());
    std::uint64_t size = 0;
    if (!formats::to_number(formats::take_word(announced), size) || size != image.size())
    {
        formats::fail_reading(name, "truncated checkpoint", fmt::format("{} bytes of data", image.size()),
                              fmt::format("{}", size));
    }
    if (std::string_view(bytes).substr(0, block_size) != user_block(image))
    {
        formats::fail_reading(name, "damaged checkpoint", "data that do not match their checksum",
                              "a checkpoint as it was written");
    }
    Checkpoint checkpoint;
    if (!parse_checkpoint_image(image, checkpoint))
    {
        formats::fail_reading(name, "damaged checkpoint", "data HDF5 cannot read", "a checkpoint as it was written");
    }
    return checkpoint;
}

} // namespace corticle::record
