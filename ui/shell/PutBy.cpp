// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/PutBy.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

#include "ui/shell/SavedFile.h"

namespace ui::shell {
namespace {

constexpr qint64 kLargestBytes = qint64{16} << 20;
constexpr int kMostWindows = 1000;
const QString kAll = QStringLiteral("typed");
const QString kSchool = QStringLiteral("school");

struct Content
{
    QJsonArray all;
    QString school;  ///< empty: an earlier program did not say
};

/// Nothing: it is damaged, or something else, and stays where it is.
std::optional<Content> readAll(const QString& file)
{
    QFile in(file);
    if (!QFileInfo(file).isFile() || in.size() > kLargestBytes || !in.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QJsonObject content = QJsonDocument::fromJson(in.read(kLargestBytes)).object();
    const QJsonValue all = content.value(kAll);
    return all.isArray() ? std::optional(Content{all.toArray(), content.value(kSchool).toString()}) : std::nullopt;
}

}  // namespace

PutBy::PutBy(QString folder, QString school) : m_folder(std::move(folder)), m_school(std::move(school))
{
    const auto isOwn = [this](const std::optional<Content>& content) {
        return content && (content->school.isEmpty() || content->school == m_school);
    };
    bool isNamed = true;
    for (const QString& name : QDir(m_folder).entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
        const QString file = QDir(m_folder).filePath(name);
        // Another school's is not even held: a window of that may be looking for it.
        if (!isOwn(readAll(file)) || !hold(file))
            continue;
        const auto content = readAll(file);  // as the window that held it has left it
        if (!isOwn(content)) {
            m_held.pop_back();
            continue;
        }
        isNamed = isNamed && content->school == m_school;
        for (const QJsonValue one : content->all)
            if (!m_found.contains(one))  // a window that was killed may have left it twice
                m_found.append(one);
    }
    m_kept = m_held.size() == 1 && isNamed ? m_found : QJsonArray();
}

bool PutBy::hold(const QString& file)
{
    core::FileLock lock((file + QStringLiteral(".lock")).toStdU16String());
    if (!lock.isHeld())
        return false;
    m_held.push_back({file, std::move(lock)});
    return true;
}

bool PutBy::holdNew()
{
    if (!QDir().mkpath(m_folder))
        return false;
    for (int number = 1; number <= kMostWindows; ++number) {
        const QString file = QDir(m_folder).filePath(QStringLiteral("%1.json").arg(number));
        if (QFileInfo::exists(file) || !hold(file))
            continue;
        if (!QFileInfo::exists(file))
            return true;
        m_held.pop_back();  // another window has just closed
    }
    return false;
}

bool PutBy::keep(const QJsonArray& all)
{
    if (!all.isEmpty() && all != m_kept) {
        if (m_held.empty() && !holdNew())
            return false;
        const QByteArray bytes = QJsonDocument(QJsonObject{{kSchool, m_school}, {kAll, all}}).toJson();
        QSaveFile out(m_held.front().file);
        if (bytes.size() > kLargestBytes || !openForOwner(out) || out.write(bytes) != bytes.size() || !out.flush() ||
            !out.commit())
            return false;
    }
    m_kept = all;
    // Where one cannot be removed it comes back, and harms nothing.
    const auto firstToGo = m_held.begin() + (all.isEmpty() ? 0 : 1);
    for (auto gone = firstToGo; gone != m_held.end(); ++gone)
        QFile::remove(gone->file);
    m_held.erase(firstToGo, m_held.end());
    return true;
}

}  // namespace ui::shell
