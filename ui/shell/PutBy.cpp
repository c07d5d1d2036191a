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
#include <QLockFile>
#include <QSaveFile>

#include "ui/shell/SavedFile.h"

namespace ui::shell {
namespace {

constexpr qint64 kLargestBytes = qint64{16} << 20;
constexpr int kMostWindows = 1000;
const QString kAll = QStringLiteral("typed");

/// Nothing: it is damaged, or something else, and stays where it is.
std::optional<QJsonArray> readAll(const QString& file)
{
    QFile in(file);
    if (!QFileInfo(file).isFile() || in.size() > kLargestBytes || !in.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QJsonValue all = QJsonDocument::fromJson(in.read(kLargestBytes)).object().value(kAll);
    return all.isArray() ? std::optional(all.toArray()) : std::nullopt;
}

}  // namespace

PutBy::PutBy(QString folder) : m_folder(std::move(folder))
{
    for (const QString& name : QDir(m_folder).entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
        if (!hold(QDir(m_folder).filePath(name)))
            continue;
        const auto all = readAll(m_held.back().file);
        if (!all) {
            m_held.pop_back();
            continue;
        }
        for (const QJsonValue one : *all)
            if (!m_found.contains(one))  // a window that was killed may have left it twice
                m_found.append(one);
    }
}

PutBy::~PutBy() = default;

/// A window that was killed holds nothing, however long ago.
bool PutBy::hold(const QString& file)
{
    auto lock = std::make_unique<QLockFile>(file + QStringLiteral(".lock"));
    lock->setStaleLockTime(0);
    if (!lock->tryLock())
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
    if (!all.isEmpty()) {
        if (m_held.empty() && !holdNew())
            return false;
        const QByteArray bytes = QJsonDocument(QJsonObject{{kAll, all}}).toJson();
        QSaveFile out(m_held.front().file);
        if (!openForOwner(out) || out.write(bytes) != bytes.size() || !out.flush() || !out.commit())
            return false;
    }
    const auto firstToGo = m_held.begin() + (all.isEmpty() ? 0 : 1);
    const bool areGone = std::all_of(
        firstToGo, m_held.end(), [](const Held& one) { return !QFile::exists(one.file) || QFile::remove(one.file); });
    if (areGone)
        m_held.erase(firstToGo, m_held.end());
    return areGone;
}

}  // namespace ui::shell
