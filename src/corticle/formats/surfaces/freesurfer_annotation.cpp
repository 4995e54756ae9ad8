// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/surfaces/freesurfer_labels.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <map>

namespace corticle::formats
{

namespace
{

/// Takes whole numbers of 32 bits, big endian, and texts off an annotation.
class Source
{
  public:
    Source(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

    std::int32_t integer(std::string_view what)
    {
        if (rest_.size() < sizeof(std::int32_t))
        {
            fail_reading(name_, "truncated FreeSurfer annotation", fmt::format("no {}", what), "a whole file");
        }
        const auto value = load<std::int32_t>(rest_.data(), true);
        rest_.remove_prefix(sizeof(std::int32_t));
        return value;
    }

    /// Counts what takes at least so many bytes each.
    std::int32_t count(std::string_view what, std::size_t bytes_each)
    {
        const std::int32_t value = integer(what);
        if (value < 0 || static_cast<std::size_t>(value) > rest_.size() / bytes_each)
        {
            fail_reading(name_, fmt::format("bad {} of a FreeSurfer annotation", what), fmt::format("{}", value),
                         fmt::format("a number from 0 on that the {} bytes left can hold", rest_.size()));
        }
        return value;
    }

    void skip_text(std::string_view what) { rest_.remove_prefix(static_cast<std::size_t>(count(what, 1))); }

    bool is_at_end() const { return rest_.size() < sizeof(std::int32_t); }

  private:
    std::string_view rest_;
    const std::string& name_;
};

constexpr std::int32_t no_structure = -1;
constexpr std::int32_t several_structures = -2;

/// Structures by their colours.
using ColourTable = std::map<std::int32_t, std::int32_t>;

/// Of the three channels that annotations hold.
std::int32_t take_colour(Source& source)
{
    std::int32_t colour = 0;
    for (int channel = 0; channel < 3; ++channel)
    {
        colour |= (source.integer("colour") & 0xff) << (8 * channel);
    }
    source.integer("transparency");
    return colour;
}

ColourTable take_colours(Source& source, const std::string& name)
{
    constexpr std::size_t least_entry = 5 * sizeof(std::int32_t);
    ColourTable table;
    const bool has_table = !source.is_at_end() && source.integer("tag of the colour table") == 1;
    const std::int32_t first = has_table ? source.integer("size of the colour table") : 0;
    if (first == 0)
    {
        fail_reading(name, "a FreeSurfer annotation without a colour table", "colours alone",
                     "a table that numbers its structures");
    }
    // The older version begins with the number of entries, which are in order; the newer with -2.
    constexpr std::int32_t newer = -2;
    if (first < 0 && first != newer)
    {
        fail_reading(name, "an unknown version of the colour table of an annotation", fmt::format("{}", -first), "2");
    }
    if (first == newer)
    {
        source.integer("largest structure");
    }
    source.skip_text("name of the colour table");
    const std::int32_t entries = first == newer ? source.count("number of structures", least_entry) : first;
    for (std::int32_t k = 0; k < entries; ++k)
    {
        const std::int32_t structure = first == newer ? source.integer("number of a structure") : k;
        source.skip_text("name of a structure");
        const auto [found, is_new] = table.emplace(take_colour(source), structure);
        found->second = is_new || found->second == structure ? found->second : several_structures;
    }
    return table;
}

} // namespace

std::vector<double> parse_annotation(std::string_view bytes, const std::string& name)
{
    Source source(bytes, name);
    const std::int32_t count = source.count("number of vertices", 2 * sizeof(std::int32_t));
    std::vector<std::int32_t> colours(static_cast<std::size_t>(count), 0);
    std::vector<bool> is_given(colours.size(), false);
    for (std::int32_t k = 0; k < count; ++k)
    {
        const std::int32_t vertex = source.integer("number of a vertex");
        if (vertex < 0 || vertex >= count || is_given[static_cast<std::size_t>(vertex)])
        {
            fail_reading(name, "bad vertex of a FreeSurfer annotation", fmt::format("{}", vertex),
                         fmt::format("0 to {}, each once", count - 1));
        }
        is_given[static_cast<std::size_t>(vertex)] = true;
        colours[static_cast<std::size_t>(vertex)] = source.integer("colour") & 0xffffff;
    }
    const ColourTable table = take_colours(source, name);
    std::vector<double> values;
    values.reserve(colours.size());
    for (const std::int32_t colour : colours)
    {
        const auto found = table.find(colour);
        const std::int32_t structure = found == table.end() ? no_structure : found->second;
        if (structure == several_structures)
        {
            fail_reading(name, "two structures of one colour, so that vertices do not tell them apart",
                         fmt::format("({}, {}, {})", colour & 0xff, colour >> 8 & 0xff, colour >> 16 & 0xff),
                         "a colour of its own for each");
        }
        values.push_back(structure);
    }
    return values;
}

} // namespace corticle::formats
