// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <cstdint>

#include "core/mesh/FormatReaders.h"
#include "core/mesh/Polygons.h"
#include "core/mesh/TextScanner.h"

namespace core::mesh {
namespace {

class ObjParser
{
public:
    ObjParser(std::string_view name, const glm::dvec3& originInFile) : m_name(name)
    {
        m_file.originInFile = originInFile;
    }

    Result<MeshFile> parse(std::string_view text)
    {
        Lines lines(withoutMark(text));
        std::string joined;
        for (std::string_view line; lines.next(line);) {
            m_line = lines.number();
            if (!isRead(line))
                continue;
            if (continues(line)) {
                joined.clear();
                do {
                    joined.append(line.substr(0, line.size() - 1)).push_back(' ');
                } while (lines.next(line) && continues(line));
                if (!line.ends_with('\\'))
                    joined.append(line);
                line = joined;
            }
            if (Status status = takeLine(line); !status)
                return tl::unexpected(std::move(status).error());
        }
        return finish();
    }

private:
    /// Returns whether this is a line of a vertex or a face. All others are ignored, also where they end in a
    /// backslash: a comment or the name of a group may.
    static bool isRead(std::string_view line)
    {
        const std::string_view keyword = takeWord(line);
        return keyword == "v" || keyword == "f";
    }

    /// Returns whether the next line belongs to this one. A backslash at the end of a comment is part of the comment.
    static bool continues(std::string_view line)
    {
        return line.ends_with('\\') && line.find('#') == std::string_view::npos;
    }

    Status takeLine(std::string_view line) { return takeWord(line) == "v" ? takeVertex(line) : takeFace(line); }

    Status takeVertex(std::string_view line)
    {
        glm::vec3 position{};
        for (int k = 0; k < 3; ++k) {
            const std::string_view word = takeWord(line);
            if (word.empty())
                return failure(ErrorCode::BadStructure, "a vertex with fewer than three numbers");
            const auto number = finiteNumber(word);
            if (!number)
                return failure(ErrorCode::BadNumber, whyNoCoordinate(word));
            position[k] = static_cast<float>(*number - m_file.originInFile[k]);
        }
        if (m_file.mesh.vertices.size() == kMaxVertices)
            return tooManyTriangles(m_name);
        m_file.mesh.vertices.push_back(position);
        return {};
    }

    Status takeFace(std::string_view line)
    {
        std::uint32_t first = 0;
        std::uint32_t previous = 0;
        std::size_t corners = 0;
        for (std::string_view word = takeWord(line); !word.empty() && word[0] != '#'; word = takeWord(line)) {
            const auto index = cornerIndex(word);
            if (!index)
                return failure(ErrorCode::BadStructure, "the face corner " + quoted(word) + " names no vertex");
            if (corners == 0)
                first = *index;
            if (corners >= 2) {
                if (m_file.mesh.triangles.size() == kMaxTriangles)
                    return tooManyTriangles(m_name);
                m_file.mesh.triangles.push_back({first, previous, *index});
            }
            previous = *index;
            ++corners;
        }
        if (corners < 3)
            ++m_thinFaces;
        if (corners > 3)
            m_polygons.push_back({static_cast<std::uint32_t>(m_file.mesh.triangles.size() - (corners - 2)),
                                  static_cast<std::uint32_t>(corners)});
        return {};
    }

    /// Returns the index of the position from "7", "7/1", "7//3" or "-1/1/1". A face may refer to vertices that follow
    /// it in the file.
    std::optional<std::uint32_t> cornerIndex(std::string_view word)
    {
        std::int64_t number = 0;
        const char* const end = word.data() + word.size();
        const auto [stop, status] = std::from_chars(word.data(), end, number);
        if (status != std::errc() || (stop != end && *stop != '/') || number == 0)
            return std::nullopt;
        const auto known = static_cast<std::int64_t>(m_file.mesh.vertices.size());
        if (number < -known || number > static_cast<std::int64_t>(kMaxVertices))
            return std::nullopt;
        const auto index = static_cast<std::uint32_t>(number < 0 ? known + number : number - 1);
        if (index >= m_highest) {
            m_highest = index;
            m_highestLine = m_line;
        }
        return index;
    }

    Result<MeshFile> finish()
    {
        const TriangleMesh& mesh = m_file.mesh;
        if (mesh.vertices.empty() && mesh.triangles.empty())
            return unexpected(ErrorCode::WrongKind,
                              m_name + " does not look like an OBJ file: it has no vertex and no face; check that "
                                       "it is the mesh you meant");
        if (mesh.triangles.empty() && m_thinFaces > 0)
            return onlyThinFaces(m_name);
        if (mesh.triangles.empty())
            return unexpected(ErrorCode::NoTriangles,
                              m_name + " has vertices but no face; export the surface, not only its points");
        if (m_highest >= mesh.vertices.size()) {
            m_line = m_highestLine;
            return failure(ErrorCode::BadStructure, "a face names vertex " + std::to_string(m_highest + 1ULL) +
                                                        " of only " + std::to_string(mesh.vertices.size()));
        }
        if (Status status = cutPolygons(m_file, m_polygons, m_name); !status)
            return tl::unexpected(std::move(status).error());
        if (m_thinFaces > 0)
            m_file.warnings.push_back(thinFaces(m_thinFaces));
        return std::move(m_file);
    }

    tl::unexpected<Error> failure(ErrorCode code, const std::string& what) const
    {
        return unexpected(code, m_name + ", line " + std::to_string(m_line) + ": " + what + "; export the mesh again");
    }

    std::string m_name;
    MeshFile m_file;
    std::vector<Polygon> m_polygons;  ///< triangulated when all vertices are known
    std::size_t m_line = 0;
    std::size_t m_thinFaces = 0;
    std::uint32_t m_highest = 0;
    std::size_t m_highestLine = 0;
};

}  // namespace

Result<MeshFile> readObj(std::string_view text, std::string_view name, const glm::dvec3& originInFile)
{
    return ObjParser(name, originInFile).parse(text);
}

}  // namespace core::mesh
