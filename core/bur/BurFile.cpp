// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bur/BurFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>

namespace core::bur {
namespace {

constexpr std::size_t kMostBytes = 65536;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kLongestId = 24;
constexpr std::size_t kMostElements = 16;
constexpr double kThinnestNeckMm = 0.05;
constexpr double kOffMm = 0.002;      ///< largest distance of an end from its arc
constexpr double kOffTangent = 0.01;  ///< sine of the largest angle between an arc and the line that continues it
constexpr double kSameMm = 1.0e-9;

/// Number of chords of a quarter circle. With 32 chords, a ball of 0.5 mm has an error of 0.15 um.
constexpr int kArcSteps = 32;

using Point = Bur::Point;

/// Returns a point of the unit quarter circle from (0, -1) to (1, 0), in equal steps of the half-angle tangent. The
/// points are rational, so that the outline is the same with every compiler and needs no library function.
Point unitArc(int step)
{
    // Two octants. In each, t = tan(angle / 2) increases up to tan(22.5 degrees).
    constexpr double kTanEighth = 0.41421356237309503;
    const int half = kArcSteps / 2;
    const bool second = step > half;
    const double t = kTanEighth * (second ? kArcSteps - step : step) / half;
    const double sine = 2.0 * t / (1.0 + t * t);
    const double cosine = (1.0 - t * t) / (1.0 + t * t);
    return second ? Point{cosine, -sine} : Point{sine, -cosine};
}

/// One element of a profile: its end, and the radius if it is an arc.
struct Element
{
    enum class Kind { Flat, Arc, Line };
    Kind kind;
    Point end;
    double radiusMm;
    std::size_t line;
};

tl::unexpected<Error> wrong(ErrorCode code, std::size_t line, const std::string& what)
{
    return unexpected(code, "Line " + std::to_string(line) + " of the bur file: " + what);
}

tl::unexpected<Error> wrong(const Element& element, const std::string& what)
{
    return wrong(ErrorCode::BadStructure, element.line, what);
}

double cross(const Point& a, const Point& b, const Point& c)
{
    return (b.radiusMm - a.radiusMm) * (c.heightMm - a.heightMm) -
           (b.heightMm - a.heightMm) * (c.radiusMm - a.radiusMm);
}

/// Returns whether two chords of a profile cross.
bool cross(const Point& a, const Point& b, const Point& c, const Point& d)
{
    return cross(a, b, c) * cross(a, b, d) < 0.0 && cross(c, d, a) * cross(c, d, b) < 0.0;
}

/// Builds the geometry of a bur from a profile, element by element.
class Profile
{
public:
    Profile(const std::vector<Element>& elements, Bur& bur) : m_elements(elements), m_bur(bur) {}

    Status make()
    {
        if (Status status = checkPoints(); !status)
            return status;
        for (const Element& element : m_elements)
            m_bur.headRadiusMm = std::max(m_bur.headRadiusMm, element.end.radiusMm);
        if (m_bur.headRadiusMm < kThinnestHeadMm)
            return wrong(ErrorCode::OutOfRange, m_elements.front().line, "a head has at least 0.2 mm of radius.");
        if (Status status = makeEnd(); !status)
            return status;
        while (m_next < m_elements.size())
            if (Status status = goOn(m_elements[m_next++]); !status)
                return status;
        m_bur.headLengthMm = m_at.heightMm;
        return {};
    }

private:
    /// Checks that each point is inside the space of a bur, and that no chords cross.
    [[nodiscard]] Status checkPoints() const
    {
        std::vector<Point> points{{0.0, 0.0}};
        for (const Element& element : m_elements) {
            const Point& end = element.end;
            if (end.radiusMm < 0.0 || end.heightMm < 0.0 || element.radiusMm < 0.0)
                return wrong(ErrorCode::OutOfRange, element.line, "a radius or a height is negative.");
            if (end.radiusMm > kWidestHeadMm || end.heightMm > kChuckMm)
                return wrong(ErrorCode::OutOfRange, element.line,
                             "a head has at most 1.5 mm of radius and 8 mm of length.");
            for (std::size_t k = 1; k + 1 < points.size(); ++k)
                if (cross(points[k - 1], points[k], points.back(), end))
                    return wrong(element, "the profile crosses itself here.");
            points.push_back(end);
        }
        return {};
    }

    /// Adds the flat disc, the arc beside it and the cone.
    [[nodiscard]] Status makeEnd()
    {
        double flat = 0.0;
        if (m_elements[m_next].kind == Element::Kind::Flat)
            flat = m_elements[m_next++].end.radiusMm;
        if (m_next == m_elements.size() || m_elements[m_next].kind != Element::Kind::Arc)
            return wrong(m_elements[std::min(m_next, m_elements.size() - 1)],
                         "a profile begins with an arc, or with a flat and an arc.");
        const Element& arc = m_elements[m_next++];
        const double corner = arc.radiusMm;
        m_bur.cornerMm = corner;
        if (corner < kSharpestCornerMm)
            return wrong(ErrorCode::OutOfRange, arc.line, "an edge is rounded with at least 0.02 mm.");
        const double out = arc.end.radiusMm - flat;
        const double down = corner - arc.end.heightMm;
        if (!(out > 0.0) || down < -kOffMm || std::abs(std::sqrt(out * out + down * down) - corner) > kOffMm)
            return wrong(arc, "the arc is not tangent to the flat end: its end does not lie on the circle that stands "
                              "on the rim of the end.");
        if (flat > 0.0)
            m_bur.outline.push_back({0.0, 0.0});
        m_at = arc.end;
        if (m_bur.headRadiusMm - arc.end.radiusMm > kSameMm)
            return makeCone(flat, arc);
        if (std::abs(down) > kOffMm || std::abs(out - corner) > kOffMm)
            return wrong(arc, "the arc ends neither upright, as high as its radius, nor at a line that goes on "
                              "outwards.");
        m_at.heightMm = corner;
        const double left = m_bur.headRadiusMm - corner;
        for (int k = 0; k <= kArcSteps; ++k) {
            const Point p = unitArc(k);
            m_bur.outline.push_back({left + corner * p.radiusMm, corner * (1.0 + p.heightMm)});
        }
        return {};
    }

    [[nodiscard]] Status makeCone(double flat, const Element& arc)
    {
        if (m_next == m_elements.size())
            return wrong(arc, "the arc ends neither upright nor at a line that goes on outwards.");
        const Element& line = m_elements[m_next++];
        const double width = line.end.radiusMm - arc.end.radiusMm;
        const double height = line.end.heightMm - arc.end.heightMm;
        if (line.kind != Element::Kind::Line || !(width > 0.0) || !(height > 0.0) ||
            line.end.radiusMm < m_bur.headRadiusMm)
            return wrong(line, "behind the first arc comes a line outwards and up to the largest radius.");
        const double out = arc.end.radiusMm - flat;
        const double down = m_bur.cornerMm - arc.end.heightMm;
        const double length = std::sqrt(width * width + height * height);
        if (std::abs(down * height - out * width) > kOffTangent * length * m_bur.cornerMm)
            return wrong(line, "the line is not tangent to the arc before it.");
        m_bur.coneSlope = height / width;
        m_bur.coneFlatMm = flat;
        const double bend = flat + m_bur.bendMm();
        for (int k = 0; k <= kArcSteps; ++k) {
            const Point p = unitArc(k);
            const double radius = flat + m_bur.cornerMm * p.radiusMm;
            if (radius >= bend)
                break;
            m_bur.outline.push_back({radius, m_bur.cornerMm * (1.0 + p.heightMm)});
        }
        m_bur.outline.push_back({bend, m_bur.undersideMm(bend)});
        m_at = {line.end.radiusMm, m_bur.undersideMm(line.end.radiusMm)};
        m_bur.outline.push_back(m_at);
        return {};
    }

    /// Appends an element of the side or the upper side.
    [[nodiscard]] Status goOn(const Element& element)
    {
        const Point& end = element.end;
        if (element.kind == Element::Kind::Flat)
            return wrong(element, "only the end of a bur is flat.");
        if (end.radiusMm > m_at.radiusMm)
            return wrong(element, "past the largest radius the profile never goes outwards again.");
        if (end.heightMm < m_at.heightMm - kOffMm)
            return wrong(element, "past the largest radius the profile never goes down again.");
        if (element.kind == Element::Kind::Arc) {
            const double left = m_at.radiusMm - element.radiusMm;  // of the circle; its middle is at the height of m_at
            const double out = end.radiusMm - left;
            const double up = end.heightMm - m_at.heightMm;
            if (!(end.radiusMm < m_at.radiusMm) || out < 0.0 ||
                std::abs(std::sqrt(out * out + up * up) - element.radiusMm) > kOffMm)
                return wrong(element, "the arc does not begin upright: its end does not lie on that circle.");
            for (int k = kArcSteps - 1; k >= 0; --k) {
                const Point p = unitArc(k);
                const double radius = left + element.radiusMm * p.radiusMm;
                if (!(radius > end.radiusMm))
                    break;
                m_bur.outline.push_back(
                    {radius, m_at.heightMm - element.radiusMm + element.radiusMm * (1.0 - p.heightMm)});
            }
        }
        m_at = {end.radiusMm, std::max(end.heightMm, m_bur.outline.back().heightMm)};
        m_bur.outline.push_back(m_at);
        return {};
    }

    const std::vector<Element>& m_elements;
    Bur& m_bur;
    std::size_t m_next = 0;
    Point m_at{0.0, 0.0};  ///< the end of the profile so far
};

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/// Removes the first word from a line and returns it; empty if the line has none.
std::string_view takeWord(std::string_view& line)
{
    while (!line.empty() && isBlank(line.front()))
        line.remove_prefix(1);
    std::size_t end = 0;
    while (end < line.size() && !isBlank(line[end]))
        ++end;
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
}

std::optional<double> numberIn(std::string_view word)
{
    double value = 0.0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string quoted(std::string_view word)
{
    std::string text = "'";
    text += word.substr(0, kLongestId);
    return text += '\'';
}

class Reader
{
public:
    Result<std::vector<Bur>> read(std::string_view text)
    {
        if (text.find('\0') != std::string_view::npos)
            return unexpected(ErrorCode::WrongKind, "The bur file is not plain text.");
        if (text.starts_with(kByteOrderMark))  // some editors write a byte order mark
            text.remove_prefix(kByteOrderMark.size());
        while (!text.empty()) {
            const std::size_t end = text.find('\n');
            ++m_line;
            if (Status status = take(text.substr(0, end)); !status)
                return tl::unexpected(std::move(status).error());
            text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        }
        if (m_isOpen)
            return wrong(ErrorCode::FileTruncated, m_line, "the text ends within a bur; its last line is \"end\".");
        if (m_burs.empty())
            return unexpected(ErrorCode::FileEmpty, "There is no bur in the text; one begins with \"bur NAME\".");
        return std::move(m_burs);
    }

private:
    [[nodiscard]] Status take(std::string_view line)
    {
        line = line.substr(0, line.find('#'));
        if (std::any_of(line.begin(), line.end(), [](char c) { return static_cast<signed char>(c) < 0; }))
            return wrong(ErrorCode::WrongKind, m_line, "only a comment may have letters that are not ASCII.");
        const std::string_view key = takeWord(line);
        if (key.empty())
            return {};
        if (key == "bur")
            return begin(line);
        if (!m_isOpen)
            return wrong(ErrorCode::WrongKind, m_line, "a bur begins with \"bur NAME\", not with " + quoted(key) + ".");
        if (key == "end")
            return end();
        if (key == "shape")
            return takeShape(takeWord(line));
        if (key == "material")
            return takeMaterial(line);
        if (key == "iso6360")
            return takeIso(line);
        if (key == "neck")
            return takeNeck(line);
        if (key == "flat" || key == "arc" || key == "line")
            return takeElement(key, line);
        return wrong(ErrorCode::BadStructure, m_line, "there is nothing called " + quoted(key) + ".");
    }

    [[nodiscard]] Status begin(std::string_view line)
    {
        if (m_isOpen)
            return wrong(ErrorCode::FileTruncated, m_line, "the bur before it has no \"end\".");
        const std::string_view id = takeWord(line);
        if (id.empty() || id.size() > kLongestId)
            return wrong(ErrorCode::BadStructure, m_line, "a bur is called by one word of up to 24 characters.");
        if (std::any_of(m_burs.begin(), m_burs.end(), [&](const Bur& bur) { return bur.id == id; }))
            return wrong(ErrorCode::BadStructure, m_line, "there is a bur " + quoted(id) + " already.");
        m_bur = {};
        m_bur.id = std::string(id);
        m_elements.clear();
        m_hasShape = m_hasMaterial = false;
        m_isOpen = true;
        return {};
    }

    [[nodiscard]] Status end()
    {
        if (!m_hasShape || !m_hasMaterial || !(m_bur.shankRadiusMm > 0.0) || m_elements.empty())
            return wrong(ErrorCode::BadStructure, m_line,
                         "the bur lacks one of its lines: shape, material, neck and a profile.");
        if (Status status = Profile(m_elements, m_bur).make(); !status)
            return status;
        if (m_bur.shankRadiusMm > m_elements.back().end.radiusMm + kOffMm)
            return wrong(ErrorCode::BadStructure, m_line, "the neck is thicker than the end of the profile.");
        m_burs.push_back(std::move(m_bur));
        m_isOpen = false;
        return {};
    }

    [[nodiscard]] Status takeShape(std::string_view word)
    {
        for (std::size_t k = 0; k < kBurShapes; ++k) {
            if (word == shapeWord(static_cast<BurShape>(k))) {
                m_bur.shape = static_cast<BurShape>(k);
                m_hasShape = true;
                return {};
            }
        }
        std::string known;
        for (std::size_t k = 0; k < kBurShapes; ++k)
            known.append(k == 0 ? "" : ", ").append(shapeWord(static_cast<BurShape>(k)));
        return wrong(ErrorCode::UnknownName, m_line,
                     "there is no shape " + quoted(word) + "; choose one of " + known + ".");
    }

    [[nodiscard]] Status takeMaterial(std::string_view line)
    {
        const std::string_view material = takeWord(line);
        const auto grit = numberIn(takeWord(line));
        m_hasMaterial = true;
        if (material == "carbide" && !grit)
            return {};
        constexpr double kMostGrit = 999.0;
        if (material != "diamond" || !grit || !(*grit >= 1.0 && *grit <= kMostGrit) || *grit != std::floor(*grit))
            return wrong(ErrorCode::BadStructure, m_line,
                         "the material is carbide, or diamond and the number of its grit, such as \"diamond 524\".");
        m_bur.grit = static_cast<int>(*grit);
        return {};
    }

    [[nodiscard]] Status takeIso(std::string_view line)
    {
        constexpr std::size_t kGroups = 5;
        constexpr std::size_t kDigits = 3;
        m_bur.iso6360.clear();
        for (std::size_t group = 0; group < kGroups; ++group) {
            const std::string_view digits = takeWord(line);
            if (digits.size() != kDigits || digits.find_first_not_of("0123456789") != std::string_view::npos)
                return wrong(ErrorCode::BadStructure, m_line, "a number of ISO 6360 is five groups of three digits.");
            if (group > 0)
                m_bur.iso6360 += ' ';
            m_bur.iso6360 += digits;
        }
        return takeNoMore(line);
    }

    [[nodiscard]] Status takeNeck(std::string_view line)
    {
        const auto radius = numberIn(takeWord(line));
        if (!radius)
            return wrong(ErrorCode::BadNumber, m_line, "the radius of the neck is not a number.");
        if (*radius < kThinnestNeckMm || *radius > kWidestHeadMm)
            return wrong(ErrorCode::OutOfRange, m_line, "the radius of the neck is from 0.05 to 1.5 mm.");
        m_bur.shankRadiusMm = *radius;
        return takeNoMore(line);
    }

    [[nodiscard]] Status takeElement(std::string_view key, std::string_view line)
    {
        const std::size_t wanted = key == "flat" ? 1 : key == "line" ? 2 : 3;
        std::array<double, 3> numbers{};
        for (std::size_t k = 0; k < wanted; ++k) {
            const auto number = numberIn(takeWord(line));
            if (!number)
                return wrong(ErrorCode::BadNumber, m_line,
                             quoted(key) + " has " + std::to_string(wanted) + " numbers, in mm.");
            numbers.at(k) = *number;
        }
        if (m_elements.size() == kMostElements)
            return wrong(ErrorCode::OutOfRange, m_line, "a profile has at most 16 elements.");
        const auto kind = key == "flat" ? Element::Kind::Flat : key == "arc" ? Element::Kind::Arc : Element::Kind::Line;
        m_elements.push_back({kind, {numbers[0], numbers[1]}, numbers[2], m_line});
        return takeNoMore(line);
    }

    [[nodiscard]] Status takeNoMore(std::string_view line) const
    {
        const std::string_view word = takeWord(line);
        return word.empty() ? Status{}
                            : Status(wrong(ErrorCode::BadStructure, m_line, quoted(word) + " is one word too many."));
    }

    std::vector<Bur> m_burs;
    Bur m_bur;
    std::vector<Element> m_elements;
    std::size_t m_line = 0;
    bool m_isOpen = false;
    bool m_hasShape = false;
    bool m_hasMaterial = false;
};

}  // namespace

Result<std::vector<Bur>> parseBurs(std::string_view text)
{
    return Reader().read(text);
}

Result<Bur> readBur(const std::filesystem::path& path)
{
    const std::string name = path.string();
    std::error_code failure;
    if (!std::filesystem::exists(path, failure))
        return unexpected(ErrorCode::FileMissing, "There is no bur file " + name + ".");
    if (std::filesystem::is_directory(path, failure))
        return unexpected(ErrorCode::FileUnreadable, "The bur file " + name + " is a folder.");
    std::ifstream file(path, std::ios::binary);
    std::string text(kMostBytes + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad() || !file.is_open())
        return unexpected(ErrorCode::FileUnreadable, "The bur file " + name + " could not be read; check its rights.");
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > kMostBytes)
        return unexpected(ErrorCode::FileTooLarge, "The bur file " + name + " is larger than 64 KiB.");
    auto burs = parseBurs(text);
    if (!burs)
        return tl::unexpected(std::move(burs).error());
    if (burs->size() != 1)
        return unexpected(ErrorCode::BadStructure, "A bur file has one bur; " + name + " has more.");
    return std::move(burs->front());
}

}  // namespace core::bur
