// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/gifti.hpp"

#include "corticle/formats/byte_source.hpp"
#include "corticle/formats/encoding.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/gifti_numbers.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/formats/xml_tag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <utility>

namespace corticle::formats
{

namespace
{

/// The decoded arrays take at most this many times the bytes of the file: numbers that are all the same shrink about a
/// thousand times.
constexpr std::size_t largest_growth = 4096;
constexpr std::size_t free_growth = 1 << 16;
constexpr int most_dimensions = 6;

/// Text of an element, with its entities or CDATA resolved.
std::string text_of(std::string_view content)
{
    while (!content.empty() && is_space(content.front()))
    {
        content.remove_prefix(1);
    }
    while (!content.empty() && is_space(content.back()))
    {
        content.remove_suffix(1);
    }
    constexpr std::string_view open = "<![CDATA[";
    constexpr std::string_view close = "]]>";
    if (content.starts_with(open) && content.ends_with(close))
    {
        return std::string(content.substr(open.size(), content.size() - open.size() - close.size()));
    }
    return unescape_xml(content);
}

/// How the numbers of an array are stored.
struct Storage
{
    std::string_view type;
    std::size_t bytes_per_number = 0;
    std::string_view encoding;
    bool big_endian = false;
    bool column_major = false;
    std::string external; ///< name of the file that holds the numbers
};

class Parser
{
  public:
    Parser(std::string_view bytes, const std::string& name)
        : bytes_(bytes), name_(name), budget_(free_growth + largest_growth * bytes.size())
    {
    }

    GiftiFile parse();

  private:
    void open_element(const XmlTag& tag);
    void close_element(const XmlTag& tag, std::string_view content);
    void close_transform_element(const XmlTag& tag, std::string_view content);
    void open_array(const XmlTag& tag);
    void open_external(const XmlTag& tag);
    void read_external(const XmlTag& tag);
    std::int64_t take_dimensions(const XmlTag& tag);
    void read_data(std::string_view content);
    std::vector<double> text_numbers(std::string_view text, std::size_t count, const std::string& what) const;
    std::vector<double> binary_numbers(std::string_view text, std::size_t count) const;
    void sort_by_rows();
    bool is_inside(std::string_view element) const { return !open_.empty() && open_.back() == element; }
    std::string array_name() const { return fmt::format("DataArray {}", file_.arrays.size() - 1); }
    [[noreturn]] void fail(std::string_view what, std::string_view got, std::string_view expected) const
    {
        fail_reading(name_, what, got, expected);
    }

    std::string_view bytes_;
    const std::string& name_;
    std::size_t budget_; ///< bytes that may still be decoded
    GiftiFile file_;
    std::vector<std::string_view> open_; ///< names of the elements around the current position
    std::string key_;                    ///< of the metadata entry at hand
    Storage storage_;
    std::int64_t count_ = 0;
    bool has_data_ = true;
    std::map<std::string, std::string> externals_; ///< bytes of other files
};

GiftiFile Parser::parse()
{
    XmlTag tag;
    bool complete = false;
    std::size_t content = 0;
    for (std::size_t position = 0; !complete && next_tag(bytes_, position, tag); position = tag.end)
    {
        if (!tag.closes)
        {
            open_element(tag);
            content = tag.end;
        }
        if (tag.closes || tag.is_empty)
        {
            if (!is_inside(tag.name))
            {
                fail("malformed XML", fmt::format("</{}>", tag.name), "the tag opened last");
            }
            open_.pop_back();
            close_element(tag, tag.is_empty ? std::string_view{} : bytes_.substr(content, tag.begin - content));
            complete = open_.empty();
        }
    }
    if (!complete)
    {
        fail("truncated or malformed GIFTI file", open_.empty() ? "no GIFTI" : fmt::format("no </{}>", open_.back()),
             "a complete GIFTI file");
    }
    return std::move(file_);
}

void Parser::open_element(const XmlTag& tag)
{
    if (open_.empty() && tag.name != "GIFTI")
    {
        fail("not a GIFTI file", fmt::format("<{}>", tag.name), "<GIFTI>");
    }
    if (tag.name == "DataArray" && is_inside("GIFTI"))
    {
        open_array(tag);
    }
    else if (tag.name == "CoordinateSystemTransformMatrix" && is_inside("DataArray") && open_.size() == 2)
    {
        file_.arrays.back().transforms.emplace_back();
    }
    constexpr std::size_t deepest = 64;
    if (open_.size() == deepest)
    {
        fail("not a GIFTI file", fmt::format("elements {} deep", deepest), "at most 5");
    }
    open_.push_back(tag.name);
}

void Parser::close_element(const XmlTag& tag, std::string_view content)
{
    if (is_inside("MD") && open_.size() >= 3)
    {
        const bool of_array = open_[1] == "DataArray" && !file_.arrays.empty();
        GiftiMetaData& metadata = of_array ? file_.arrays.back().metadata : file_.metadata;
        if (tag.name == "Name")
        {
            key_ = text_of(content);
        }
        else if (tag.name == "Value")
        {
            metadata[key_] = text_of(content);
        }
    }
    else if (is_inside("CoordinateSystemTransformMatrix") && !file_.arrays.empty() &&
             !file_.arrays.back().transforms.empty())
    {
        close_transform_element(tag, content);
    }
    else if (is_inside("DataArray") && tag.name == "Data" && open_.size() == 2)
    {
        read_data(content);
    }
    else if (is_inside("GIFTI") && tag.name == "DataArray" && !has_data_)
    {
        fail(fmt::format("{} is damaged", array_name()), "no Data", fmt::format("{} numbers", count_));
    }
}

void Parser::close_transform_element(const XmlTag& tag, std::string_view content)
{
    GiftiTransform& transform = file_.arrays.back().transforms.back();
    if (tag.name == "DataSpace")
    {
        transform.data_space = text_of(content);
    }
    else if (tag.name == "TransformedSpace")
    {
        transform.transformed_space = text_of(content);
    }
    else if (tag.name == "MatrixData")
    {
        const std::vector<double> numbers = text_numbers(content, 16, "the matrix of " + array_name());
        std::copy(numbers.begin(), numbers.end(), transform.matrix.begin());
    }
}

std::int64_t Parser::take_dimensions(const XmlTag& tag)
{
    int dimensionality = 0;
    if (!to_number(tag.attribute("Dimensionality"), dimensionality) || dimensionality < 1 ||
        dimensionality > most_dimensions)
    {
        fail(fmt::format("{} has a bad Dimensionality", array_name()), tag.attribute("Dimensionality", "none"),
             "1 to 6");
    }
    std::int64_t count = 1;
    const auto most = static_cast<std::int64_t>(budget_ / sizeof(double));
    for (int k = 0; k < dimensionality; ++k)
    {
        const std::string key = fmt::format("Dim{}", k);
        std::int64_t size = 0;
        if (!to_number(tag.attribute(key), size) || size < 0 || (count > 0 && size > most / count))
        {
            fail(fmt::format("{} is larger than the file can hold, or has a bad {}", array_name(), key),
                 tag.attribute(key, "none"), fmt::format("0 to {}", count > 0 ? most / count : most));
        }
        count *= size;
        file_.arrays.back().dimensions.push_back(size);
    }
    budget_ -= static_cast<std::size_t>(count) * sizeof(double);
    return count;
}

void Parser::open_array(const XmlTag& tag)
{
    file_.arrays.emplace_back();
    GiftiArray& array = file_.arrays.back();
    array.intent = tag.attribute("Intent");
    storage_.encoding = tag.attribute("Encoding");
    if (storage_.encoding == "ExternalFileBinary")
    {
        open_external(tag);
    }
    count_ = take_dimensions(tag);
    storage_.type = tag.attribute("DataType");
    storage_.bytes_per_number = bytes_of_gifti(storage_.type);
    if (storage_.bytes_per_number == 0)
    {
        fail(fmt::format("{} has a DataType that is not read", array_name()), storage_.type,
             "NIFTI_TYPE_FLOAT32, FLOAT64, or INT or UINT of 8 to 64 bits");
    }
    constexpr std::array<std::string_view, 4> encodings{"ASCII", "Base64Binary", "GZipBase64Binary",
                                                        "ExternalFileBinary"};
    if (std::ranges::find(encodings, storage_.encoding) == encodings.end())
    {
        fail(fmt::format("{} has an unknown Encoding", array_name()), storage_.encoding,
             "ASCII, Base64Binary, GZipBase64Binary or ExternalFileBinary");
    }
    storage_.big_endian = tag.attribute("Endian") == "BigEndian";
    storage_.column_major = tag.attribute("ArrayIndexingOrder") == "ColumnMajorOrder";
    if (storage_.column_major && array.dimensions.size() > 2)
    {
        fail(fmt::format("{} is stored by columns", array_name()),
             fmt::format("{} dimensions", array.dimensions.size()), "at most 2");
    }
    has_data_ = count_ == 0;
    if (storage_.encoding == "ExternalFileBinary")
    {
        read_external(tag);
    }
}

/// A file of numbers beside the GIFTI; it may be named by many arrays, and counts once for what they may take.
void Parser::open_external(const XmlTag& tag)
{
    const std::string name = unescape_xml(tag.attribute("ExternalFileName"));
    const std::filesystem::path file(name);
    if (name.empty() || file.has_parent_path() || name == "..")
    {
        fail(fmt::format("{} lies in another file", array_name()), name.empty() ? "no ExternalFileName" : name,
             "the name of a file in the folder of this one");
    }
    storage_.external = name;
    const auto [found, is_new] = externals_.try_emplace(name);
    if (is_new)
    {
        found->second = read_whole_file(std::filesystem::path(name_).parent_path() / file);
        budget_ += sizeof(double) * found->second.size();
    }
}

void Parser::read_external(const XmlTag& tag)
{
    const std::string_view bytes = externals_.at(storage_.external);
    const std::size_t size = static_cast<std::size_t>(count_) * storage_.bytes_per_number;
    std::size_t offset = 0;
    if (!to_number(tag.attribute("ExternalFileOffset", "0"), offset) || offset > bytes.size() ||
        size > bytes.size() - offset)
    {
        fail(fmt::format("{} is longer than {}", array_name(), storage_.external),
             fmt::format("{} bytes from byte {} on", size, tag.attribute("ExternalFileOffset", "0")),
             fmt::format("at most {}", bytes.size()));
    }
    file_.arrays.back().values = gifti_numbers(bytes.substr(offset, size), storage_.type, storage_.big_endian);
    sort_by_rows();
    has_data_ = true;
}

void Parser::read_data(std::string_view content)
{
    if (storage_.encoding == "ExternalFileBinary")
    {
        return; // an empty element
    }
    if (has_data_ && count_ > 0)
    {
        fail(fmt::format("{} is damaged", array_name()), "Data twice", "once");
    }
    const auto count = static_cast<std::size_t>(count_);
    file_.arrays.back().values =
        storage_.encoding == "ASCII" ? text_numbers(content, count, array_name()) : binary_numbers(content, count);
    sort_by_rows();
    has_data_ = true;
}

std::vector<double> Parser::text_numbers(std::string_view text, std::size_t count, const std::string& what) const
{
    std::vector<double> values;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text))
    {
        double value = 0.0;
        if (values.size() == count || !to_number(word, value))
        {
            fail(fmt::format("bad number in {}", what), word, fmt::format("{} numbers", count));
        }
        values.push_back(value);
    }
    if (values.size() != count)
    {
        fail(fmt::format("{} has too few numbers", what), fmt::format("{}", values.size()), fmt::format("{}", count));
    }
    return values;
}

std::vector<double> Parser::binary_numbers(std::string_view text, std::size_t count) const
{
    const std::size_t size = count * storage_.bytes_per_number;
    std::string bytes;
    bool good = false;
    if (storage_.encoding == "GZipBase64Binary")
    {
        ByteSource source(text, true);
        const std::string packed = source.take_all();
        bytes.resize(size);
        good = size == 0 || unpack_zlib(packed, bytes.data(), size);
    }
    else
    {
        good = ByteSource(text, true).take(size, bytes);
    }
    if (!good)
    {
        fail(fmt::format("truncated or damaged {}", array_name()), fmt::format("{} characters", text.size()),
             fmt::format("{} bytes of {} data", size, storage_.encoding));
    }
    return gifti_numbers(bytes, storage_.type, storage_.big_endian);
}

void Parser::sort_by_rows()
{
    GiftiArray& array = file_.arrays.back();
    if (!storage_.column_major || array.dimensions.size() != 2)
    {
        return;
    }
    const auto rows = static_cast<std::size_t>(array.dimensions[0]);
    const auto columns = static_cast<std::size_t>(array.dimensions[1]);
    std::vector<double> by_rows(array.values.size());
    for (std::size_t i = 0; i < by_rows.size(); ++i)
    {
        by_rows[i % rows * columns + i / rows] = array.values[i];
    }
    array.values = std::move(by_rows);
}

} // namespace

GiftiFile parse_gifti(std::string_view bytes, const std::string& name)
{
    return Parser(bytes, name).parse();
}

} // namespace corticle::formats
