// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/mesh/FormatReaders.h"
#include "core/mesh/Polygons.h"
#include "core/mesh/TextScanner.h"

namespace core::mesh {
namespace {

enum class Scalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

std::optional<Scalar> scalarNamed(std::string_view word)
{
    static constexpr std::pair<std::string_view, Scalar> kNames[] = {
        {"char", Scalar::Int8},      {"int8", Scalar::Int8},       {"uchar", Scalar::UInt8},
        {"uint8", Scalar::UInt8},    {"short", Scalar::Int16},     {"int16", Scalar::Int16},
        {"ushort", Scalar::UInt16},  {"uint16", Scalar::UInt16},   {"int", Scalar::Int32},
        {"int32", Scalar::Int32},    {"uint", Scalar::UInt32},     {"uint32", Scalar::UInt32},
        {"float", Scalar::Float32},  {"float32", Scalar::Float32}, {"double", Scalar::Float64},
        {"float64", Scalar::Float64}};
    for (const auto& [name, scalar] : kNames)
        if (word == name)
            return scalar;
    return std::nullopt;
}

std::size_t sizeOf(Scalar type)
{
    switch (type) {
    case Scalar::Int8:
    case Scalar::UInt8:
        return 1;
    case Scalar::Int16:
    case Scalar::UInt16:
        return 2;
    case Scalar::Int32:
    case Scalar::UInt32:
    case Scalar::Float32:
        return 4;
    case Scalar::Float64:
        return 8;
    }
    return 1;
}

struct Property
{
    std::string name;
    Scalar type = Scalar::Float32;
    std::optional<Scalar> countType;  ///< type of the length of a list; empty for a scalar
};

struct Element
{
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

enum class Encoding { Ascii, LittleEndian, BigEndian };

/// Reads the values of the body in order, in any encoding. A double can store every PLY scalar exactly.
class Body
{
public:
    Body(std::string_view bytes, Encoding encoding) : m_rest(bytes), m_encoding(encoding) {}

    /// Returns the next value: NaN for a word that is no number, empty at the end of the file. Columns that are not
    /// read may hold anything.
    std::optional<double> take(Scalar type) { return m_encoding == Encoding::Ascii ? takeText() : takeBinary(type); }

    [[nodiscard]] std::size_t bytesLeft() const { return m_rest.size(); }
    /// Returns the word that was taken last; empty in a binary file.
    [[nodiscard]] std::string_view word() const { return m_word; }

    /// Returns the smallest number of bytes of one such value.
    [[nodiscard]] std::size_t leastBytes(Scalar type) const { return m_encoding == Encoding::Ascii ? 1 : sizeOf(type); }

private:
    std::optional<double> takeText()
    {
        std::size_t begin = 0;
        while (begin < m_rest.size() && (isBlank(m_rest[begin]) || m_rest[begin] == '\n'))
            ++begin;
        std::size_t end = begin;
        while (end < m_rest.size() && !isBlank(m_rest[end]) && m_rest[end] != '\n')
            ++end;
        std::string_view word = m_rest.substr(begin, end - begin);
        m_rest.remove_prefix(end);
        m_word = word;
        if (word.empty())
            return std::nullopt;
        if (word.starts_with('+'))
            word.remove_prefix(1);
        double value = 0.0;
        const auto [stop, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || stop != word.data() + word.size())
            return std::numeric_limits<double>::quiet_NaN();
        if (failure == std::errc::result_out_of_range)
            return word.find_first_of("eE") != std::string_view::npos && word.find('-', 1) != std::string_view::npos
                       ? 0.0
                       : std::numeric_limits<double>::infinity();
        return value;
    }

    std::optional<double> takeBinary(Scalar type)
    {
        const std::size_t size = sizeOf(type);
        if (m_rest.size() < size)
            return std::nullopt;
        std::uint64_t word = 0;
        for (std::size_t k = 0; k < size; ++k) {
            const std::size_t place = m_encoding == Encoding::LittleEndian ? k : size - 1 - k;
            word |= static_cast<std::uint64_t>(static_cast<unsigned char>(m_rest[k])) << (8 * place);
        }
        m_rest.remove_prefix(size);
        switch (type) {
        case Scalar::Int8:
            return static_cast<std::int8_t>(word);
        case Scalar::Int16:
            return static_cast<std::int16_t>(word);
        case Scalar::Int32:
            return static_cast<std::int32_t>(word);
        case Scalar::Float32:
            return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(word)));
        case Scalar::Float64:
            return std::bit_cast<double>(word);
        default:
            return static_cast<double>(word);
        }
    }

    std::string_view m_rest;
    std::string_view m_word;
    Encoding m_encoding;
};

class PlyParser
{
public:
    PlyParser(std::string_view name, const glm::dvec3& originInFile) : m_name(name)
    {
        m_file.originInFile = originInFile;
    }

    Result<MeshFile> parse(std::string_view bytes)
    {
        bytes = withoutMark(bytes);
        const std::optional<std::size_t> bodyAt = readHeader(bytes);
        if (!bodyAt)
            return unexpected(ErrorCode::WrongKind, m_name + " is not a PLY file that Cusp reads: its header " +
                                                        m_headerFault + "; check that it is the mesh you meant");
        Body body(bytes.substr(*bodyAt), m_encoding);
        for (const Element& element : m_elements)
            if (Status status = takeElement(element, body); !status)
                return tl::unexpected(std::move(status).error());
        return finish();
    }

private:
    /// Returns the offset of the body; empty, with m_headerFault set, if there is no usable header.
    std::optional<std::size_t> readHeader(std::string_view bytes)
    {
        bool encodingGiven = false;
        // All lines end as the first one does. After "end_header" and a CR, an LF may be the first byte of the body.
        const std::size_t firstEnd = bytes.find_first_of("\r\n");
        const bool endsWithReturn =
            firstEnd != std::string_view::npos && bytes[firstEnd] == '\r' && bytes.substr(firstEnd + 1, 1) != "\n";
        std::size_t at = 0;
        for (int number = 1; at < bytes.size(); ++number) {
            const std::size_t end = bytes.find(endsWithReturn ? '\r' : '\n', at);
            if (end == std::string_view::npos)
                break;
            std::string_view line = bytes.substr(at, end - at);
            at = end + 1;
            const std::string_view keyword = takeWord(line);
            if (number == 1 && keyword != "ply") {
                m_headerFault = "does not begin with \"ply\"";
                return std::nullopt;
            }
            if (keyword == "format") {
                const std::string_view encoding = takeWord(line);
                encodingGiven =
                    encoding == "ascii" || encoding == "binary_little_endian" || encoding == "binary_big_endian";
                m_encoding = encoding == "ascii"                  ? Encoding::Ascii
                             : encoding == "binary_little_endian" ? Encoding::LittleEndian
                                                                  : Encoding::BigEndian;
            } else if (keyword == "element" || keyword == "property") {
                if (!(keyword == "element" ? addElement(line) : addProperty(line))) {
                    m_headerFault = "has a faulty line " + std::to_string(number);
                    return std::nullopt;
                }
            } else if (keyword == "end_header") {
                if (encodingGiven)
                    return at;
                m_headerFault = "names no known encoding";
                return std::nullopt;
            }
        }
        m_headerFault = "has no end";
        return std::nullopt;
    }

    bool addElement(std::string_view line)
    {
        Element element;
        element.name = takeWord(line);
        const std::string_view count = takeWord(line);
        const auto [stop, failure] = std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (element.name.empty() || count.empty() || failure != std::errc() || stop != count.data() + count.size())
            return false;
        m_elements.push_back(std::move(element));
        return true;
    }

    bool addProperty(std::string_view line)
    {
        if (m_elements.empty())
            return false;
        Property property;
        std::string_view type = takeWord(line);
        if (type == "list") {
            property.countType = scalarNamed(takeWord(line));
            if (!property.countType || *property.countType >= Scalar::Float32)
                return false;
            type = takeWord(line);
        }
        const auto scalar = scalarNamed(type);
        property.name = takeWord(line);
        if (!scalar || property.name.empty())
            return false;
        property.type = *scalar;
        m_elements.back().properties.push_back(std::move(property));
        return true;
    }

    Status takeElement(const Element& element, Body& body)
    {
        // The count in the file may be any number, so the remaining bytes limit the loop.
        std::size_t rowBytes = 0;
        for (const Property& property : element.properties)
            rowBytes += body.leastBytes(property.countType.value_or(property.type));
        if (rowBytes == 0)
            return {};
        const bool vertices = element.name == "vertex";
        const bool faces = element.name == "face" || element.name == "tristrips";
        if (element.count > body.bytesLeft() / rowBytes)
            return unexpected(ErrorCode::FileTruncated,
                              m_name + " is cut short: its header states " + std::to_string(element.count) + " of " +
                                  quoted(std::string_view(element.name)) + ", more than the " +
                                  std::to_string(body.bytesLeft()) +
                                  " bytes left can hold; copy the file again or export it anew");
        if ((vertices && element.count > kMaxVertices) || (faces && element.count > kMaxTriangles))
            return tooManyTriangles(m_name);
        if (vertices)
            m_file.mesh.vertices.reserve(static_cast<std::size_t>(element.count));
        for (std::uint64_t row = 0; row < element.count; ++row) {
            glm::vec3 position{};
            int coordinates = 0;
            for (const Property& property : element.properties) {
                const bool corners = faces && isCorners(property);
                Status status;
                if (property.countType)
                    status = takeList(element, property, row, corners, body);
                else
                    status = takeScalar(element, property, row, vertices, position, coordinates, body);
                if (!status)
                    return status;
            }
            if (vertices && coordinates != 3)
                return unexpected(ErrorCode::BadStructure,
                                  m_name + ": its vertices have no x, y and z; export the mesh again");
            if (vertices)
                m_file.mesh.vertices.push_back(position);
        }
        return {};
    }

    Status takeScalar(const Element& element, const Property& property, std::uint64_t row, bool vertices,
                      glm::vec3& position, int& coordinates, Body& body) const
    {
        const auto value = body.take(property.type);
        if (!value)
            return cutShort(element.name + " " + std::to_string(row + 1));
        const bool coordinate = property.name == "x" || property.name == "y" || property.name == "z";
        if (!vertices || !coordinate)
            return {};
        // Converting a value outside the range of float would be undefined behaviour.
        if (!(std::abs(*value) <= static_cast<double>(std::numeric_limits<float>::max())))
            return unexpected(ErrorCode::BadNumber, m_name + ", vertex " + std::to_string(row + 1) + ": " +
                                                        (body.word().empty() ? "a coordinate is not a finite number"
                                                                             : whyNoCoordinate(body.word())) +
                                                        "; export the mesh again");
        const int axis = property.name[0] - 'x';
        position[axis] = static_cast<float>(*value - m_file.originInFile[axis]);
        ++coordinates;
        return {};
    }

    static bool isCorners(const Property& property)
    {
        return property.countType && (property.name == "vertex_indices" || property.name == "vertex_index");
    }

    Status takeList(const Element& element, const Property& property, std::uint64_t row, bool corners, Body& body)
    {
        const std::string where = element.name + " " + std::to_string(row + 1);
        const auto length = body.take(*property.countType);
        if (!length || *length > static_cast<double>(body.bytesLeft()))
            return cutShort(where);
        if (!(*length >= 0.0))
            return unexpected(ErrorCode::BadStructure,
                              m_name + ", " + where + ": the length of a list is no number; export the mesh again");
        const auto count = static_cast<std::uint64_t>(*length);
        const bool isStrip = corners && element.name == "tristrips";
        Fan fan;
        for (std::uint64_t k = 0; k < count; ++k) {
            const auto value = body.take(property.type);
            if (!value)
                return cutShort(where);
            if (!corners)
                continue;
            if (isStrip && *value < 0.0) {
                fan = {};
                continue;
            }
            if (!(*value >= 0.0 && *value < static_cast<double>(kMaxVertices)))
                return unexpected(ErrorCode::BadStructure,
                                  m_name + ", " + where + " names a vertex that cannot be; export the mesh again");
            if (Status status = addCorner(fan, static_cast<std::uint32_t>(*value), isStrip); !status)
                return status;
        }
        if (!corners || isStrip)
            return {};
        m_thinFaces += count < 3 ? 1 : 0;
        if (count > 3)
            m_polygons.push_back({static_cast<std::uint32_t>(m_file.mesh.triangles.size() - (count - 2)),
                                  static_cast<std::uint32_t>(count)});
        return {};
    }

    /// The corners of a face or strip so far, as far as the next triangle needs them.
    struct Fan
    {
        std::uint32_t first = 0;  ///< the first corner of a face; in a strip, the one before the last
        std::uint32_t last = 0;
        std::uint64_t count = 0;
    };

    /// Adds a corner and, from the third on, a triangle. Every second triangle of a strip is turned round.
    Status addCorner(Fan& fan, std::uint32_t index, bool isStrip)
    {
        if (fan.count == 0)
            fan.first = index;
        const bool isThin = isStrip && (fan.first == fan.last || fan.last == index || index == fan.first);
        if (fan.count >= 2 && !isThin) {
            if (m_file.mesh.triangles.size() == kMaxTriangles)
                return tooManyTriangles(m_name);
            const bool isTurned = isStrip && fan.count % 2 == 1;
            m_file.mesh.triangles.push_back({isTurned ? fan.last : fan.first, isTurned ? fan.first : fan.last, index});
        }
        if (isStrip && fan.count > 0)
            fan.first = fan.count == 1 ? fan.first : fan.last;
        fan.last = index;
        ++fan.count;
        return {};
    }

    Result<MeshFile> finish()
    {
        const TriangleMesh& mesh = m_file.mesh;
        if (mesh.triangles.empty() && m_thinFaces > 0)
            return onlyThinFaces(m_name);
        if (const std::string list = otherList(); mesh.triangles.empty() && !list.empty())
            return unexpected(ErrorCode::NoTriangles,
                              m_name +
                                  " has no list \"vertex_indices\" in an element \"face\" or \"tristrips\", only " +
                                  list + ", which Cusp does not read; export the mesh again, or as OBJ or STL");
        if (mesh.triangles.empty())
            return unexpected(ErrorCode::NoTriangles, m_name + " holds " + std::to_string(mesh.vertices.size()) +
                                                          (mesh.vertices.size() == 1 ? " point" : " points") +
                                                          " and no face; export the surface, not only its points");
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (const std::uint32_t index : mesh.triangles[t])
                if (index >= mesh.vertices.size())
                    return unexpected(ErrorCode::BadStructure, m_name + ": a face names vertex " +
                                                                   std::to_string(index) + " of only " +
                                                                   std::to_string(mesh.vertices.size()) +
                                                                   " (counted from 0); export the mesh again");
        if (Status status = cutPolygons(m_file, m_polygons, m_name); !status)
            return tl::unexpected(std::move(status).error());
        if (m_thinFaces > 0)
            m_file.warnings.push_back(thinFaces(m_thinFaces));
        return std::move(m_file);
    }

    /// Returns the first list that is there but is not read: "corners" in "polygon"; empty if there is none.
    [[nodiscard]] std::string otherList() const
    {
        for (const Element& element : m_elements)
            for (const Property& property : element.properties) {
                const bool isSurface = element.name == "face" || element.name == "tristrips";
                if (property.countType && element.count > 0 && !(isSurface && isCorners(property)))
                    return mesh::quoted(property.name) + " in " + mesh::quoted(element.name);
            }
        return {};
    }

    tl::unexpected<Error> cutShort(const std::string& where) const
    {
        return unexpected(ErrorCode::FileTruncated,
                          m_name + " is cut short, or holds something else than its header says, at " + where +
                              "; copy the file again or export it anew");
    }

    std::string m_name;
    std::string m_headerFault;
    Encoding m_encoding = Encoding::Ascii;
    std::vector<Element> m_elements;
    MeshFile m_file;
    std::vector<Polygon> m_polygons;  ///< triangulated when all vertices are known
    std::size_t m_thinFaces = 0;
};

}  // namespace

Result<MeshFile> readPly(std::string_view bytes, std::string_view name, const glm::dvec3& originInFile)
{
    return PlyParser(name, originInFile).parse(bytes);
}

}  // namespace core::mesh
