// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/PutBy.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSaveFile>

#include "ui/shell/SavedFile.h"

namespace ui::study {
namespace {

constexpr qint64 kLargestBytes = qint64{16} << 20;

}  // namespace

bool putBy(const QString& file, const std::vector<PutByDraft>& drafts)
{
    if (drafts.empty())
        return !QFile::exists(file) || QFile::remove(file);
    QJsonArray all;
    for (const PutByDraft& draft : drafts)
        all.append(QJsonObject{{"from", draft.from}, {"lesson", draft.object}});
    const QByteArray bytes = QJsonDocument(QJsonObject{{"drafts", all}}).toJson();
    QDir().mkpath(QFileInfo(file).absolutePath());
    QSaveFile out(file);
    return shell::openForOwner(out) && out.write(bytes) == bytes.size() && out.flush() && out.commit();
}

std::vector<PutByDraft> putByIn(const QString& file)
{
    QFile in(file);
    if (!QFileInfo(file).isFile() || in.size() > kLargestBytes || !in.open(QIODevice::ReadOnly))
        return {};
    std::vector<PutByDraft> drafts;
    for (const QJsonValue one : QJsonDocument::fromJson(in.read(kLargestBytes)).object()["drafts"].toArray())
        drafts.push_back({one["from"].toString(), one["lesson"].toObject()});
    return drafts;
}

}  // namespace ui::study
