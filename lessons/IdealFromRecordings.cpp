// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/IdealFromRecordings.h"

#include <array>
#include <map>
#include <vector>

#include <QCryptographicHash>
#include <QJsonArray>

#include "core/recording/Replay.h"

namespace lessons {
namespace {

using core::preparation::Tolerances;

struct Meant
{
    const char* measure;
    double Tolerances::*tolerance;
};
constexpr std::array<Meant, 4> kMeant{{{"outline_p95_mm", &Tolerances::outlineMm},
                                       {"depth_error_p95_mm", &Tolerances::depthMm},
                                       {"wall_angle_error_deg", &Tolerances::wallDeg},
                                       {"floor_flatness_mm", &Tolerances::floorMm}}};

std::string hashOf(const std::string& bytes)
{
    return QCryptographicHash::hash(QByteArray::fromStdString(bytes), QCryptographicHash::Sha256).toStdString();
}

}  // namespace

core::Result<core::preparation::CapturedIdeal> captureFrom(std::span<const std::filesystem::path> recordings,
                                                           const Tolerances& tolerances,
                                                           const std::function<bool()>& mayGoOn)
{
    std::vector<core::terrain::Tooth> teeth;
    std::vector<std::string> sources;
    std::map<std::string, std::string> known;  // file name by content
    for (const std::filesystem::path& path : recordings) {
        if (mayGoOn && !mayGoOn())
            return core::unexpected(core::ErrorCode::BadStructure, "The capture was called off.");
        const auto recording = core::recording::readRecording(path);
        if (!recording)
            return tl::unexpected(recording.error());
        const auto [same, isNew] = known.try_emplace(hashOf(recording->toBytes()), path.filename().string());
        if (!isNew)
            return core::unexpected(
                core::ErrorCode::OutOfRange,
                QStringLiteral("%1 is the attempt of %2 once more, and would count twice; name it once.")
                    .arg(QString::fromStdString(path.filename().string()), QString::fromStdString(same->second))
                    .toStdString());
        auto outcome = core::recording::replay(*recording);
        if (!outcome)
            return core::unexpected(outcome.error().code, path.string() + ": " + outcome.error().detail);
        teeth.push_back(std::move(outcome->tooth));
        sources.push_back(path.filename().string());
    }
    std::vector<const core::terrain::Tooth*> attempts;
    attempts.reserve(teeth.size());
    for (const core::terrain::Tooth& tooth : teeth)
        attempts.push_back(&tooth);
    return core::preparation::capture(attempts, tolerances, std::move(sources));
}

QJsonObject withTolerances(QJsonObject rubric, const Tolerances& tolerances)
{
    QJsonArray criteria = rubric.value(QStringLiteral("criteria")).toArray();
    for (qsizetype k = 0; k < criteria.size(); ++k) {
        QJsonObject criterion = criteria[k].toObject();
        for (const Meant& meant : kMeant)
            if (criterion.contains(QStringLiteral("weight")) &&
                criterion.value(QStringLiteral("measure")).toString() == QLatin1String(meant.measure))
                criterion.insert(QStringLiteral("tolerance"), tolerances.*meant.tolerance);
        criteria[k] = criterion;
    }
    rubric.insert(QStringLiteral("criteria"), criteria);
    return rubric;
}

Tolerances tolerancesOf(const Rubric& rubric, Tolerances otherwise)
{
    for (const CriterionRule& rule : rubric.criteria)
        for (const Meant& meant : kMeant)
            if (!rule.critical && rule.measure == meant.measure)
                otherwise.*meant.tolerance = rule.tolerance;
    return otherwise;
}

}  // namespace lessons
