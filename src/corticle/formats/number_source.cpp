// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/number_source.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::formats
{

void NumberSource::fail(std::string_view what, std::string_view got, std::string_view expected) const
{
    const std::string_view before = bytes_.substr(0, position_);
    const std::string place = is_text() ? fmt::format("line {}", 1 + std::count(before.begin(), before.end(), '\n'))
                                        : fmt::format("byte {}", position_);
    fail_reading(file_, fmt::format("{} at {}", what, place), got, expected);
}

std::string_view NumberSource::word()
{
    std::string_view rest = bytes_.substr(position_);
    const std::string_view taken = take_word(rest);
    position_ = bytes_.size() - rest.size();
    return taken;
}

void NumberSource::skip_line()
{
    position_ = std::min(bytes_.find('\n', position_), bytes_.size());
}

bool NumberSource::is_at_end() const
{
    return is_text() ? is_blank(bytes_.substr(position_)) : position_ >= bytes_.size();
}

std::string_view NumberSource::take_bytes(std::size_t size, std::string_view what)
{
    if (bytes_.size() - position_ < size)
    {
        fail(fmt::format("bad {}", what), "the end of the data", fmt::format("{} bytes", size));
    }
    const std::string_view taken = bytes_.substr(position_, size);
    position_ += size;
    return taken;
}

std::int64_t NumberSource::integer(int size, std::string_view what)
{
    if (!is_text())
    {
        const std::string_view taken = take_bytes(static_cast<std::size_t>(size), what);
        const bool big = form_ == Form::big_endian;
        return size == 4 ? load<std::int32_t>(taken.data(), big) : load<std::int64_t>(taken.data(), big);
    }
    const std::string_view taken = word();
    std::int64_t value = 0;
    if (!to_number(taken, value))
    {
        fail(fmt::format("bad {}", what), taken.empty() ? "the end of the data" : taken, "a whole number");
    }
    return value;
}

double NumberSource::real(std::string_view what)
{
    if (!is_text())
    {
        return load<double>(take_bytes(sizeof(double), what).data(), form_ == Form::big_endian);
    }
    const std::string_view taken = word();
    double value = 0.0;
    if (!to_number(taken, value))
    {
        fail(fmt::format("bad {}", what), taken.empty() ? "the end of the data" : taken, "a number");
    }
    return value;
}

std::int64_t NumberSource::count(int size, std::size_t binary_bytes_each, std::size_t numbers_each,
                                 std::string_view what)
{
    const std::int64_t value = integer(size, what);
    const std::size_t left = bytes_.size() - position_;
    const std::size_t each = is_text() ? 2 * numbers_each : binary_bytes_each;
    if (value < 0 || static_cast<std::uint64_t>(value) > left / each + 1)
    {
        fail(fmt::format("bad {}", what), fmt::format("{}", value),
             fmt::format("a number from 0 on that the {} bytes left can hold", left));
    }
    return value;
}

} // namespace corticle::formats
