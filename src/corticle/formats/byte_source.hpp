// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/text_scan.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace corticle::formats
{

/// Takes bytes off raw or base64 text; padding inside base64 ends one stretch and begins the next, as VTK writes it.
class ByteSource
{
  public:
    ByteSource(std::string_view text, bool base64) : text_(text), base64_(base64) {}

    /// Appends `count` bytes; false when there are not that many.
    bool take(std::size_t count, std::string& bytes)
    {
        if (!base64_)
        {
            if (count > text_.size())
            {
                return false;
            }
            bytes.append(text_.substr(0, count));
            text_.remove_prefix(count);
            return true;
        }
        if (count / 3 > text_.size() / 4 + 1)
        {
            return false;
        }
        while (pending_.size() < count)
        {
            if (!decode_group())
            {
                return false;
            }
        }
        bytes.append(pending_, 0, count);
        pending_.erase(0, count);
        return true;
    }

    /// What is left of base64, up to its end or the first character that is not base64.
    std::string take_all()
    {
        while (decode_group())
        {
        }
        return std::exchange(pending_, {});
    }

  private:
    static int digit(char c)
    {
        if (c >= 'A' && c <= 'Z')
        {
            return c - 'A';
        }
        if (c >= 'a' && c <= 'z')
        {
            return c - 'a' + 26;
        }
        if (c >= '0' && c <= '9')
        {
            return c - '0' + 52;
        }
        return c == '+' ? 62 : (c == '/' ? 63 : -1);
    }

    bool decode_group()
    {
        unsigned bits = 0;
        int digits = 0;
        int padding = 0;
        while (digits < 4)
        {
            while (!text_.empty() && is_space(text_.front()))
            {
                text_.remove_prefix(1);
            }
            const int value = text_.empty() ? -1 : digit(text_.front());
            const bool pads = !text_.empty() && text_.front() == '=' && digits >= 2;
            if ((value < 0 && !pads) || (padding > 0 && !pads))
            {
                return false;
            }
            padding += pads ? 1 : 0;
            bits = bits << 6 | static_cast<unsigned>(pads ? 0 : value);
            text_.remove_prefix(1);
            ++digits;
        }
        for (int i = 0; i < 3 - padding; ++i)
        {
            pending_.push_back(static_cast<char>(bits >> (16 - 8 * i) & 0xff));
        }
        return true;
    }

    std::string_view text_;
    bool base64_;
    std::string pending_; ///< decoded, not yet taken
};

} // namespace corticle::formats
