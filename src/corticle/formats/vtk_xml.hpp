// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/xml_tag.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace corticle::formats
{

// A reader of VTK's XML files (.vtp, .vtu, .pvd) for bytes from anywhere. VTK's own readers trust the sizes a file
// announces.

/// A DataArray as announced; its numbers are decoded on demand.
struct VtkXmlArray
{
    std::string section; ///< "Points", "Polys", "PointData", ...
    std::string name;
    std::string type;   ///< "Float64", "Int32", ...
    std::string format; ///< "ascii", "binary" (inline base64) or "appended"
    std::int64_t components = 1;
    std::int64_t offset = 0;  ///< in the appended data
    std::string_view content; ///< inline text
};

struct VtkXmlPiece
{
    std::map<std::string, std::int64_t> counts; ///< "NumberOfPoints", ...
    std::vector<VtkXmlArray> arrays;

    std::int64_t count(const std::string& key) const;
    /// nullptr when there is none; an empty `name` matches every name.
    const VtkXmlArray* find(std::string_view section, std::string_view name) const;
};

class ByteSource;

/// A VTK XML file taken apart; it refers to the bytes it was made from.
class VtkXmlFile
{
  public:
    /// @param type "PolyData" or "UnstructuredGrid"
    /// @param largest_growth the decoded arrays together take at most this many times the bytes (and 64 kB)
    /// @throws InputError, one line, when the bytes are not such a file.
    VtkXmlFile(std::string_view bytes, std::string type, std::string file, std::size_t largest_growth);

    const std::vector<VtkXmlPiece>& pieces() const { return pieces_; }
    const std::string& file() const { return file_; }

    /// An array of a piece. @throws InputError when it is not there
    const VtkXmlArray& required(const VtkXmlPiece& piece, std::string_view section, std::string_view name) const;

    /// Decodes an array of exactly `count` numbers. @throws InputError when it does not hold them.
    std::vector<double> doubles(const VtkXmlArray& array, std::int64_t count) const;
    std::vector<std::int64_t> integers(const VtkXmlArray& array, std::int64_t count) const;

  private:
    void read_header(const XmlTag& tag);
    void add_piece(const XmlTag& tag);
    void add_array(const XmlTag& tag, std::string_view section);
    void find_appended_data(std::string_view bytes, const XmlTag& tag);
    void parse(std::string_view bytes);
    template <class Number>
    std::vector<Number> numbers(const VtkXmlArray& array, std::int64_t count) const;
    template <class Number>
    std::vector<Number> text_numbers(const VtkXmlArray& array, std::size_t count) const;
    std::uint64_t take_size(ByteSource& source, const VtkXmlArray& array) const;
    std::string unpacked_blocks(ByteSource& source, const VtkXmlArray& array, std::size_t size) const;
    std::string decoded_bytes(const VtkXmlArray& array, std::size_t size) const;
    [[noreturn]] void fail(std::string_view what, std::string_view got, std::string_view expected) const;

    std::string type_;
    std::string file_;
    std::string compressor_;
    bool big_endian_ = false;
    bool appended_base64_ = false;
    bool has_root_ = false;
    std::size_t header_bytes_ = 4;
    std::string_view appended_;
    std::vector<VtkXmlPiece> pieces_;
    mutable std::size_t budget_ = 0; ///< bytes that may still be decoded
};

} // namespace corticle::formats
