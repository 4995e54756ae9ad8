// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/legacy_vtk.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace corticle::formats
{

namespace
{

/// Kinds of numbers; in BINARY files they are big endian.
struct NumberKind
{
    std::string_view name;
    std::size_t size;
    double (*at)(const char* bytes);
};

template <class Number>
double number_of(const char* bytes)
{
    return static_cast<double>(load<Number>(bytes, true));
}

constexpr std::array kinds{NumberKind{"float", 4, number_of<float>},
                           NumberKind{"double", 8, number_of<double>},
                           NumberKind{"int", 4, number_of<std::int32_t>},
                           NumberKind{"vtkidtype", 4, number_of<std::int32_t>},
                           NumberKind{"long", 8, number_of<std::int64_t>},
                           NumberKind{"vtktypeint64", 8, number_of<std::int64_t>},
                           NumberKind{"vtktypeint32", 4, number_of<std::int32_t>},
                           NumberKind{"unsigned_int", 4, number_of<std::uint32_t>},
                           NumberKind{"unsigned_long", 8, number_of<std::uint64_t>},
                           NumberKind{"short", 2, number_of<std::int16_t>},
                           NumberKind{"unsigned_short", 2, number_of<std::uint16_t>},
                           NumberKind{"char", 1, number_of<std::int8_t>},
                           NumberKind{"unsigned_char", 1, number_of<std::uint8_t>}};

class Parser
{
  public:
    Parser(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

    LegacyVtkFile parse()
    {
        take_header();
        for (std::string_view word = take_word(rest_); !word.empty(); word = take_word(rest_))
        {
            const std::string section = lower_case(word);
            if (section == "point_data" || section == "cell_data")
            {
                break; // the geometry stands before its data
            }
            take_section(section);
        }
        require_whole();
        return std::move(file_);
    }

  private:
    [[noreturn]] void fail(std::string_view what, std::string_view got, std::string_view expected) const
    {
        fail_reading(name_, what, got, expected);
    }

    void take_header()
    {
        constexpr std::string_view magic = "# vtk DataFile Version ";
        std::string_view line;
        if (!rest_.starts_with(magic))
        {
            fail("not a legacy VTK file", rest_.substr(0, magic.size()), magic);
        }
        take_line(rest_, line);
        take_line(rest_, line); // the title
        const std::string form = lower_case(take_word(rest_));
        if (form != "ascii" && form != "binary")
        {
            fail("bad legacy VTK header", form, "ASCII or BINARY in its third line");
        }
        is_binary_ = form == "binary";
        const std::string key = lower_case(take_word(rest_));
        const std::string kind = key == "dataset" ? lower_case(take_word(rest_)) : "no DATASET";
        if (kind != "polydata" && kind != "unstructured_grid")
        {
            fail("a kind of VTK data that is no surface and no tet mesh", kind, "POLYDATA or UNSTRUCTURED_GRID");
        }
        file_.is_grid = kind == "unstructured_grid";
    }

    void take_section(const std::string& section)
    {
        if (section == "points")
        {
            const std::size_t count = take_count("number of points", 3);
            const std::vector<double> numbers = take_numbers(3 * count, take_kind());
            for (std::size_t k = 0; k < numbers.size(); k += 3)
            {
                file_.points.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
            }
        }
        else if (section == "polygons" || section == "triangle_strips" || section == "cells")
        {
            LegacyVtkCells& cells =
                section == "cells" ? file_.cells : (section == "polygons" ? file_.polygons : file_.strips);
            cells = take_cells();
        }
        else if (section == "vertices" || section == "lines")
        {
            take_cells();
        }
        else if (section == "cell_types")
        {
            file_.types = take_whole(take_count("number of cell types", 1), kinds[2]);
        }
        else if (section == "field")
        {
            skip_field();
        }
        else if (section == "metadata")
        {
            skip_metadata();
        }
        else
        {
            fail("an unknown section of a legacy VTK file", section, "POINTS, POLYGONS, CELLS, ... or POINT_DATA");
        }
    }

    /// Of something that takes `numbers_each` numbers, which the bytes that are left can hold.
    std::size_t take_count(std::string_view what, std::size_t numbers_each)
    {
        const std::string_view word = take_word(rest_);
        std::int64_t count = 0;
        if (!to_number(word, count) || count < 0 || static_cast<std::uint64_t>(count) > rest_.size() / numbers_each + 1)
        {
            fail(fmt::format("bad {}", what), word.empty() ? "the end of the file" : word,
                 fmt::format("a number from 0 on that the {} bytes left can hold", rest_.size()));
        }
        return static_cast<std::size_t>(count);
    }

    const NumberKind& take_kind()
    {
        const std::string word = lower_case(take_word(rest_));
        const auto found = std::ranges::find(kinds, word, &NumberKind::name);
        if (found == kinds.end())
        {
            fail("an unknown kind of number in a legacy VTK file", word, "float, double, int, vtktypeint64, ...");
        }
        return *found;
    }

    std::vector<double> take_numbers(std::size_t count, const NumberKind& kind)
    {
        const std::size_t least = is_binary_ ? kind.size : 2; // a digit and a blank
        if (count > rest_.size() / least + 1)
        {
            fail("truncated legacy VTK file", fmt::format("{} bytes left", rest_.size()),
                 fmt::format("{} numbers", count));
        }
        std::vector<double> numbers(count);
        if (!is_binary_)
        {
            for (double& number : numbers)
            {
                const std::string_view word = take_word(rest_);
                if (!to_number(word, number))
                {
                    fail("bad number in a legacy VTK file", word.empty() ? "the end of the file" : word, "a number");
                }
            }
            return numbers;
        }
        rest_.remove_prefix(std::min(rest_.size(), rest_.find('\n') + 1)); // the end of the line that announces them
        if (rest_.size() / kind.size < count)
        {
            fail("truncated legacy VTK file", fmt::format("{} bytes left", rest_.size()),
                 fmt::format("{} numbers of {} bytes", count, kind.size));
        }
        for (std::size_t k = 0; k < count; ++k)
        {
            numbers[k] = kind.at(rest_.data() + k * kind.size);
        }
        rest_.remove_prefix(count * kind.size);
        return numbers;
    }

    std::vector<std::int64_t> take_whole(std::size_t count, const NumberKind& kind)
    {
        const std::vector<double> numbers = take_numbers(count, kind);
        std::vector<std::int64_t> whole(numbers.size());
        constexpr double largest = 1e15; // exact in a double
        for (std::size_t k = 0; k < numbers.size(); ++k)
        {
            if (!(std::abs(numbers[k]) <= largest) || numbers[k] != std::floor(numbers[k]))
            {
                fail("bad index in a legacy VTK file", fmt::format("{}", numbers[k]), "a whole number");
            }
            whole[k] = static_cast<std::int64_t>(numbers[k]);
        }
        return whole;
    }

    LegacyVtkCells take_cells()
    {
        const std::size_t count = take_count("number of cells", 1);
        const std::size_t size = take_count("size of the cells", 1);
        std::string_view ahead = rest_;
        const bool is_new = lower_case(take_word(ahead)) == "offsets"; // version 5: arrays of offsets and of corners
        return is_new ? take_offset_cells(count, size) : take_counted_cells(count, size);
    }

    LegacyVtkCells take_offset_cells(std::size_t offset_count, std::size_t corner_count)
    {
        take_word(rest_);
        std::vector<std::int64_t> offsets = take_whole(offset_count, take_kind());
        if (lower_case(take_word(rest_)) != "connectivity")
        {
            fail("damaged cells of a legacy VTK file", "no CONNECTIVITY", "OFFSETS, then CONNECTIVITY");
        }
        LegacyVtkCells cells;
        cells.corners = take_whole(corner_count, take_kind());
        const bool is_good = offsets.empty() ? corner_count == 0
                                             : offsets.front() == 0 && std::ranges::is_sorted(offsets) &&
                                                   offsets.back() == static_cast<std::int64_t>(corner_count);
        if (!is_good)
        {
            fail("the offsets of the cells do not count their corners", fmt::format("{} offsets", offsets.size()),
                 fmt::format("growing ones from 0 to {}", corner_count));
        }
        cells.ends.assign(offsets.begin() + (offsets.empty() ? 0 : 1), offsets.end());
        return cells;
    }

    LegacyVtkCells take_counted_cells(std::size_t count, std::size_t size)
    {
        const std::vector<std::int64_t> numbers = take_whole(size, kinds[2]);
        LegacyVtkCells cells;
        std::size_t at = 0;
        for (std::size_t k = 0; k < count; ++k)
        {
            const std::int64_t corners = at < size ? numbers[at] : -1;
            if (corners < 0 || static_cast<std::uint64_t>(corners) > size - at - 1)
            {
                fail(fmt::format("cell {} (counted from 0) is damaged", k), fmt::format("{} corners", corners),
                     fmt::format("cells of {} numbers in all", size));
            }
            const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(at) + 1;
            cells.corners.insert(cells.corners.end(), begin, begin + corners);
            cells.ends.push_back(std::ssize(cells.corners));
            at += 1 + static_cast<std::size_t>(corners);
        }
        return cells;
    }

    void skip_field()
    {
        take_word(rest_); // its name
        const std::size_t arrays = take_count("number of arrays", 1);
        for (std::size_t k = 0; k < arrays; ++k)
        {
            take_word(rest_);
            const std::size_t components = take_count("number of components", 1);
            const std::size_t tuples = take_count("number of tuples", 1);
            if (components > 0 && tuples > rest_.size() / components + 1)
            {
                fail("truncated legacy VTK file", fmt::format("{} bytes left", rest_.size()),
                     fmt::format("{} x {} numbers", tuples, components));
            }
            take_numbers(components * tuples, take_kind());
        }
    }

    /// Ends with an empty line.
    void skip_metadata()
    {
        std::string_view line;
        take_line(rest_, line);
        while (take_line(rest_, line) && !is_blank(line))
        {
        }
    }

    void require_indices(const LegacyVtkCells& cells) const
    {
        const std::int64_t points = std::ssize(file_.points);
        const auto bad =
            std::ranges::find_if(cells.corners, [&](std::int64_t corner) { return corner < 0 || corner >= points; });
        if (bad != cells.corners.end())
        {
            fail("a cell names no point", fmt::format("index {}", *bad), fmt::format("0 to {}", points - 1));
        }
    }

    void require_whole() const
    {
        for (const LegacyVtkCells* cells : {&file_.polygons, &file_.strips, &file_.cells})
        {
            require_indices(*cells);
        }
        if (file_.is_grid && file_.types.size() != file_.cells.count())
        {
            fail("cells and their types do not belong together", fmt::format("{} types", file_.types.size()),
                 fmt::format("{}, one for each cell", file_.cells.count()));
        }
    }

    std::string_view rest_;
    const std::string& name_;
    bool is_binary_ = false;
    LegacyVtkFile file_;
};

} // namespace

LegacyVtkFile parse_legacy_vtk(std::string_view bytes, const std::string& name)
{
    return Parser(bytes, name).parse();
}

} // namespace corticle::formats
