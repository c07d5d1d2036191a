// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/mesh/FormatReaders.h"
#include "core/mesh/TextScanner.h"

namespace core::mesh {
namespace {

constexpr std::size_t kHeaderBytes = 84;  // 80 of text, 4 of count
constexpr std::size_t kRecordBytes = 50;  // normal, three corners, two unused bytes
constexpr std::size_t kNormalBytes = 12;
constexpr std::uint32_t kBlankCount = 0x20202020;  // four blanks

std::uint32_t littleEndian(std::string_view bytes, std::size_t at)
{
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
    return word;
}

/// "1 triangle", "3 triangles"
std::string counted(std::uint64_t triangles)
{
    return std::to_string(triangles) + (triangles == 1 ? " triangle" : " triangles");
}

Status addTriangle(MeshFile& file, const std::array<glm::vec3, 3>& corners, std::string_view name)
{
    if (file.mesh.triangles.size() == kMaxTriangles)
        return tooManyTriangles(name);
    const auto first = static_cast<std::uint32_t>(file.mesh.vertices.size());
    file.mesh.vertices.insert(file.mesh.vertices.end(), corners.begin(), corners.end());
    file.mesh.triangles.push_back({first, first + 1, first + 2});
    return {};
}

/// Reads `count` records. `stated` is the count in the header.
Result<MeshFile> readBinary(std::string_view bytes, std::uint64_t count, std::uint32_t stated, const std::string& name,
                            const glm::dvec3& originInFile)
{
    if (count > kMaxTriangles)
        return tooManyTriangles(name);
    if (count == 0)
        return unexpected(ErrorCode::NoTriangles, name + " states 0 triangles; export the mesh again");
    MeshFile file;
    file.originInFile = originInFile;
    file.mesh.vertices.reserve(3 * static_cast<std::size_t>(count));
    file.mesh.triangles.reserve(static_cast<std::size_t>(count));
    for (std::size_t t = 0; t < count; ++t) {
        std::array<glm::vec3, 3> corners{};
        std::size_t at = kHeaderBytes + kRecordBytes * t + kNormalBytes;
        for (glm::vec3& corner : corners)
            for (int k = 0; k < 3; ++k, at += 4) {
                const float value = std::bit_cast<float>(littleEndian(bytes, at));
                if (!std::isfinite(value))
                    return unexpected(ErrorCode::BadNumber, name + ", triangle " + std::to_string(t + 1) +
                                                                ": a coordinate is not a finite number; export the "
                                                                "mesh again");
                corner[k] = static_cast<float>(static_cast<double>(value) - originInFile[k]);
            }
        if (Status status = addTriangle(file, corners, name); !status)
            return tl::unexpected(std::move(status).error());
    }
    if (count != stated)
        file.warnings.push_back("the header states " + counted(stated) + ", but " + std::to_string(count) +
                                " are there; all of them were read");
    const std::size_t extra = bytes.size() - kHeaderBytes - kRecordBytes * static_cast<std::size_t>(count);
    if (extra > 0)
        file.warnings.push_back(std::to_string(extra) + (extra == 1 ? " byte" : " bytes") +
                                " after the last triangle passed over");
    return file;
}

/// Returns whether a byte separates words: blanks, line ends, and NUL, which some programs pad names with.
bool separates(char c)
{
    return isBlank(c) || c == '\n' || c == '\0';
}

/// The words of an ASCII STL, wherever its lines end. A word that begins with # is a comment up to the end of its line.
class Words
{
public:
    explicit Words(std::string_view text) : m_text(text) {}

    /// Returns the next word; empty at the end of the text.
    std::string_view take()
    {
        for (;;) {
            while (m_at < m_text.size() && separates(m_text[m_at]))
                step();
            if (m_at == m_text.size() || m_text[m_at] != '#')
                break;
            skipLine();
        }
        const std::size_t begin = m_at;
        while (m_at < m_text.size() && !separates(m_text[m_at]))
            ++m_at;
        return m_text.substr(begin, m_at - begin);
    }

    /// Skips a name: the rest of the line, or up to the next facet where a file has no lines.
    void skipName()
    {
        while (m_at < m_text.size() && m_text[m_at] != '\n' && m_text[m_at] != '\r') {
            const std::size_t begin = m_at;
            while (m_at < m_text.size() && !separates(m_text[m_at]))
                ++m_at;
            if (m_at == begin) {
                ++m_at;  // a blank, or a NUL behind the name
                continue;
            }
            if (!equalsIgnoringCase(m_text.substr(begin, m_at - begin), "facet"))
                continue;
            const std::size_t end = m_at;
            const std::size_t line = m_line;
            const bool isFacet = equalsIgnoringCase(take(), "normal");
            m_at = isFacet ? begin : end;
            m_line = line;
            if (isFacet)
                return;
        }
    }

    [[nodiscard]] std::size_t line() const { return m_line; }  ///< of the word taken last, from 1

private:
    void step()
    {
        const char c = m_text[m_at++];
        const bool endsLine = c == '\n' || (c == '\r' && (m_at == m_text.size() || m_text[m_at] != '\n'));
        m_line += endsLine ? 1 : 0;
    }
    void skipLine() { m_at = std::min(m_text.find_first_of("\r\n", m_at), m_text.size()); }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::size_t m_line = 1;
};

class AsciiStl
{
public:
    AsciiStl(std::string_view text, const std::string& name, const glm::dvec3& originInFile)
        : m_words(text), m_name(name)
    {
        m_file.originInFile = originInFile;
    }

    Result<MeshFile> parse()
    {
        for (std::string_view word = m_words.take(); !word.empty(); word = m_words.take()) {
            const bool ends = equalsIgnoringCase(word, "end");  // "end facet" is "endfacet"
            if (ends)
                word = m_words.take();
            if (Status status = takeKeyword(word, ends); !status)
                return tl::unexpected(std::move(status).error());
        }
        if (m_file.mesh.triangles.empty())
            return unexpected(m_corner > 0 ? ErrorCode::FileTruncated : ErrorCode::WrongKind,
                              m_name + " begins like an ASCII STL but holds no whole facet; check that it is the mesh "
                                       "you meant");
        if (m_corner != 0 || !m_hasEnded)
            return unexpected(ErrorCode::FileTruncated, m_name + " is cut short: it ends after " +
                                                            counted(m_file.mesh.triangles.size()) +
                                                            " without \"endsolid\"; copy the file again");
        return std::move(m_file);
    }

private:
    Status takeKeyword(std::string_view word, bool ends)
    {
        if (equalsIgnoringCase(word, ends ? "solid" : "endsolid")) {
            m_hasEnded = true;
            m_words.skipName();
        } else if (equalsIgnoringCase(word, "solid")) {
            m_hasEnded = false;
            m_words.skipName();
        } else if (!ends && equalsIgnoringCase(word, "facet")) {
            m_hasEnded = false;  // a file without lines hides the next "solid" in a name
        } else if (equalsIgnoringCase(word, ends ? "facet" : "endfacet")) {
            if (m_corner != 3)
                return failure(ErrorCode::BadStructure, "a facet with fewer than three corners");
            m_corner = 0;
            return addTriangle(m_file, m_corners, m_name);
        } else if (!ends && equalsIgnoringCase(word, "vertex")) {
            return takeVertex();
        }
        return {};
    }

    Status takeVertex()
    {
        if (m_corner == 3)
            return failure(ErrorCode::BadStructure, "a facet with more than three corners");
        for (int k = 0; k < 3; ++k) {
            const std::string_view word = m_words.take();
            const auto number = finiteNumber(word);
            if (word.empty())
                return {};  // parse() reports the end of the file
            if (!number)
                return failure(ErrorCode::BadNumber, whyNoCoordinate(word));
            m_corners[m_corner][k] = static_cast<float>(*number - m_file.originInFile[k]);
        }
        ++m_corner;
        return {};
    }

    tl::unexpected<Error> failure(ErrorCode code, const std::string& what) const
    {
        return unexpected(code, m_name + ", line " + std::to_string(m_words.line()) + ": " + what +
                                    "; export the mesh again");
    }

    Words m_words;
    std::string m_name;
    MeshFile m_file;
    std::array<glm::vec3, 3> m_corners{};  ///< of the facet that is being read
    std::size_t m_corner = 0;              ///< number of them that have been read
    bool m_hasEnded = false;               ///< the last solid has
};

}  // namespace

bool looksLikeAsciiStl(std::string_view start)
{
    Words words(withoutMark(start).substr(0, kBytesThatTell));
    if (!equalsIgnoringCase(words.take(), "solid"))
        return false;
    words.skipName();
    return equalsIgnoringCase(words.take(), "facet");
}

Result<MeshFile> readStl(std::string_view bytes, std::string_view name, const glm::dvec3& originInFile)
{
    const std::string file(name);
    // Binary files may also begin with "solid". A file is binary if its size matches the count exactly.
    const bool hasHeader = bytes.size() >= kHeaderBytes;
    const std::uint32_t count = hasHeader ? littleEndian(bytes, kHeaderBytes - 4) : 0;
    const std::uint64_t stated = kHeaderBytes + kRecordBytes * static_cast<std::uint64_t>(count);
    if (hasHeader && bytes.size() == stated)
        return readBinary(bytes, count, count, file, originInFile);
    const bool isText = bytes.substr(0, kBytesThatTell).find('\0') == std::string_view::npos;
    const bool isSolid = equalsIgnoringCase(Words(withoutMark(bytes)).take().substr(0, 5), "solid");
    if (looksLikeAsciiStl(bytes) || (isSolid && isText))
        return AsciiStl(withoutMark(bytes), file, originInFile).parse();
    const std::uint64_t whole = hasHeader ? (bytes.size() - kHeaderBytes) / kRecordBytes : 0;
    const bool fits = hasHeader && whole > 0 && (bytes.size() - kHeaderBytes) % kRecordBytes == 0;
    // Some programs leave the count 0, -1 or blank. A count that is possible and larger means a file cut short.
    if (fits && (!isText || count >= kBlankCount) && (count < whole || count > kMaxTriangles))
        return readBinary(bytes, whole, count, file, originInFile);
    if (isText)
        return unexpected(ErrorCode::WrongKind, file + " is not an STL file: neither binary of its stated length nor "
                                                       "text that begins with \"solid\"; check that it is the mesh "
                                                       "you meant");
    if (!hasHeader)
        return unexpected(ErrorCode::FileTruncated, file + " is cut short: " + std::to_string(bytes.size()) +
                                                        " bytes are less than an STL header; copy the file again");
    if (bytes.size() < stated)
        return unexpected(ErrorCode::FileTruncated, file + " is cut short: its header states " + counted(count) +
                                                        ", of which only " + std::to_string(whole) +
                                                        " can be there; copy the file again");
    return readBinary(bytes, count, count, file, originInFile);
}

}  // namespace core::mesh
