// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace corticle::formats
{

/// Takes numbers off a file, whether they are words of text or bytes, from a position on.
class NumberSource
{
  public:
    enum class Form
    {
        text,
        little_endian,
        big_endian
    };

    /// @param end position after the last byte that may be taken
    NumberSource(std::string_view bytes, std::size_t begin, std::size_t end, Form form, std::string_view file)
        : bytes_(bytes.substr(0, end)), position_(begin), form_(form), file_(file)
    {
    }

    bool is_text() const { return form_ == Form::text; }

    /// A whole number; `size` is 4 or 8 bytes, of no matter in text. `what` is named when it is not there.
    std::int64_t integer(int size, std::string_view what);
    double real(std::string_view what);
    /// A whole number from 0 on that counts what takes at least `bytes_each` bytes here: in text, two a number, the
    /// least a digit and a blank can be.
    std::int64_t count(int size, std::size_t binary_bytes_each, std::size_t numbers_each, std::string_view what);
    /// The next word of text; empty at the end.
    std::string_view word();
    /// Leaves out the rest of the line.
    void skip_line();
    bool is_at_end() const;

    [[noreturn]] void fail(std::string_view what, std::string_view got, std::string_view expected) const;

  private:
    std::string_view take_bytes(std::size_t size, std::string_view what);

    std::string_view bytes_;
    std::size_t position_;
    Form form_;
    std::string_view file_;
};

} // namespace corticle::formats
