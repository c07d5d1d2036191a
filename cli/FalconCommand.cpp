// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>
#include <QFile>

#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/FalconParts.h"
#include "core/base/WholeFile.h"
#include "database/Csv.h"
#include "haptics/falcon/Kinematics.h"

namespace cli {
namespace {

constexpr std::array kColumns{"x_m", "y_m", "z_m", "fx_N", "fy_N", "fz_N"};
constexpr const char* kHeader = "theta1_rad,theta2_rad,theta3_rad,tick1,tick2,tick3,tau1_Nm,tau2_Nm,tau3_Nm,"
                                "fk_x_m,fk_y_m,fk_z_m,reachable\n";
constexpr int kDigits = 12;
constexpr qint64 kLargestBytes = qint64{16} << 20;

/// Position of the grip, m, and force on the hand, N: a number for each of kColumns.
using Row = std::array<double, kColumns.size()>;

core::Error fault(core::ErrorCode code, const QString& file, const std::string& what)
{
    return {code, printable(file).toStdString() + ": " + what};
}

std::optional<double> numberIn(const std::string& cell)
{
    const std::size_t begin = std::min(cell.find_first_not_of(' '), cell.size());
    const std::size_t end = cell.find_last_not_of(' ') + 1;
    double value = 0.0;
    const auto [stop, failure] = std::from_chars(cell.data() + begin, cell.data() + std::max(begin, end), value);
    if (failure != std::errc{} || stop != cell.data() + end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

core::Result<std::vector<Row>> readRows(const QString& name)
{
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(fault(core::ErrorCode::FileUnreadable, name, file.errorString().toStdString()));
    const QByteArray bytes = file.read(kLargestBytes + 1);
    const auto lines = database::readCsv({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    if (!lines && lines.error().kind == database::CsvFault::Kind::TooLarge)
        return tl::unexpected(fault(core::ErrorCode::FileTooLarge, name, "the table is larger than 16 MiB; split it"));
    if (!lines)
        return tl::unexpected(fault(core::ErrorCode::BadStructure, name,
                                    "line " + std::to_string(lines.error().line) + " is no CSV in UTF-8"));
    if (lines->empty())
        return tl::unexpected(fault(core::ErrorCode::FileEmpty, name,
                                    "the table is empty; its first line names the columns x_m,y_m,z_m,fx_N,fy_N,fz_N"));
    std::array<std::size_t, kColumns.size()> places{};
    const std::vector<std::string>& header = lines->front().fields;
    for (std::size_t k = 0; k < kColumns.size(); ++k) {
        places.at(k) =
            static_cast<std::size_t>(std::find(header.begin(), header.end(), kColumns.at(k)) - header.begin());
        if (places.at(k) == header.size())
            return tl::unexpected(fault(core::ErrorCode::BadStructure, name,
                                        std::string("the first line names no column \"") + kColumns.at(k) +
                                            "\"; it has to name x_m,y_m,z_m,fx_N,fy_N,fz_N"));
    }
    std::vector<Row> rows;
    for (auto line = lines->begin() + 1; line != lines->end(); ++line) {
        Row& row = rows.emplace_back();
        for (std::size_t k = 0; k < kColumns.size(); ++k) {
            const auto value = places.at(k) < line->fields.size() ? numberIn(line->fields[places.at(k)]) : std::nullopt;
            if (!value)
                return tl::unexpected(
                    fault(core::ErrorCode::BadStructure, name,
                          "line " + std::to_string(line->line) + " has no number for " + kColumns.at(k)));
            row.at(k) = *value;
        }
    }
    return rows;
}

/// Returns one line of the result. A position out of reach has no numbers.
QByteArray solved(const Row& row)
{
    constexpr double kMmPerM = 1000.0;
    const auto arms = haptics::falcon::armsAt(kMmPerM * glm::dvec3(row[0], row[1], row[2]));
    const auto grip =
        arms ? haptics::falcon::gripAt(arms->angleRad, haptics::falcon::kCentreMm) : std::optional<glm::dvec3>();
    std::array<glm::dvec3, 4> values;
    values.fill(glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
    if (grip)
        values = {arms->angleRad, haptics::falcon::countsAt(arms->angleRad),
                  haptics::falcon::torquesNm(*arms, {row[3], row[4], row[5]}), *grip / kMmPerM};
    QByteArray line;
    for (const glm::dvec3& value : values)
        for (int axis = 0; axis < 3; ++axis)
            line += QByteArray::number(value[axis], 'g', kDigits) + ',';
    return line + (grip ? "1\n" : "0\n");
}

int kinematicsPart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Computes the mechanism of a Novint Falcon. Each row of IN, with x_m,y_m,z_m (position of the grip) "
        "and fx_N,fy_N,fz_N (force on the hand), becomes a row of OUT: angles, encoder counts and torques "
        "of the three arms, and the position that forward kinematics finds again from the angles. The "
        "user faces the device: x right, y up, z out of the device."));
    parser.addPositionalArgument(QStringLiteral("IN"), QStringLiteral("A table (CSV) with a header."));
    parser.addPositionalArgument(QStringLiteral("OUT"), QStringLiteral("The table to write."));
    if (const auto code = parse(parser, arguments, QStringLiteral("cusp falcon kinematics IN.csv OUT.csv")))
        return *code;
    const QStringList names = parser.positionalArguments();
    if (names.size() != 2)
        return wrongUsage(QStringLiteral("name two files; usage: cusp falcon kinematics IN.csv OUT.csv"));
    if (core::isSameFile(names.front().toStdString(), names.back().toStdString()))
        return wrongUsage(QStringLiteral("IN and OUT are the same file; name another for OUT"));
    const auto rows = readRows(names.front());
    if (!rows)
        return failed(rows.error());
    QByteArray text(kHeader);
    for (const Row& row : *rows)
        text += solved(row);
    const auto written = core::writeWhole(names.back().toStdString(),
                                          {text.constData(), static_cast<std::size_t>(text.size())}, "The table");
    return written ? kDone : failed(written.error());
}

constexpr CommandPart kParts[] = {
    {"list", "list the Falcons that are plugged in", falconListPart},
    {"probe", "open a Falcon, load its firmware and measure the exchange of packets", falconProbePart},
    {"home", "wait until the grip has been moved past the index marks", falconHomePart},
    {"test", "push the grip in six directions", falconTestPart},
    {"rules", "print the udev rule that lets users open a Falcon", falconRulesPart},
    {"calibrate", "measure angles and forces with a ruler and a weight", falconCalibratePart},
    {"kinematics", "compute angles, counts and torques of the arms from positions and forces", kinematicsPart},
};

}  // namespace

int falconCommand(const QStringList& arguments)
{
    return runPart(QStringLiteral("falcon"), kParts, arguments);
}

}  // namespace cli
