// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/ScoreSheetJson.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace lessons {
namespace {

constexpr int kFormat = 1;

QString text(const std::string& utf8)
{
    return QString::fromStdString(utf8);
}

}  // namespace

QByteArray toJson(const ScoreSheet& sheet)
{
    QJsonArray criteria;
    for (const Criterion& criterion : sheet.criteria)
        criteria.append(QJsonObject{
            {"id", text(criterion.id)},
            {"measured", criterion.measured},
            {"unit", text(criterion.unit)},
            {"free", criterion.free},
            {"rule", criterion.rule == PointRule::Once ? "once" : "per_unit"},
            {"points_per_unit", criterion.pointsPerUnit},
            {"max_points", criterion.maxPoints},
            {"critical", criterion.critical},
            {"points_lost", criterion.pointsLost},
        });
    const QJsonObject object{
        {"format", kFormat},    {"rubric", text(sheet.rubricId)}, {"rubric_version", sheet.rubricVersion},
        {"criteria", criteria}, {"total", sheet.total},           {"pass_mark", sheet.passMark},
    };
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

}  // namespace lessons
