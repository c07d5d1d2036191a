// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/PresetShelf.h"

#include <algorithm>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

namespace lessons {
namespace {

using core::settings::FeelPreset;

constexpr int kTries = 16;
/// Largest number of files that are read from a folder. It limits the time if the folder is not one of presets.
constexpr qsizetype kMostPresets = 2000;

/// Returns a file name that is valid on all systems. Different preset names get different file names.
QString fileNameOf(const FeelPreset& preset)
{
    QString plain;
    for (const QChar c : QString::fromStdString(preset.name).toLower())
        plain += c.isLetterOrNumber() && c.unicode() < 128 ? c : QChar(u'-');
    return QStringLiteral("%1-v%2-%3.%4")
        .arg(plain)
        .arg(preset.version)
        .arg(QString::fromStdString(preset.hash).left(8), QLatin1String(kPresetSuffix));
}

/// Returns a shipped preset. If the school made that version before Cusp shipped it, the version is the next free one.
FeelPreset besideOwn(FeelPreset shipped, const std::vector<ReadPreset>& kept)
{
    const auto isTaken = [&](const ReadPreset& read) {
        return read.preset && read.preset->name == shipped.name && read.preset->version == shipped.version &&
               read.preset->hash != shipped.hash;
    };
    if (shipped.version == 1)  // version 1 was in the first Cusp, so it cannot be the school's
        return shipped;
    while (std::any_of(kept.begin(), kept.end(), isTaken)) {
        ++shipped.version;
        shipped = hashed(std::move(shipped));
    }
    return shipped;
}

bool before(const ReadPreset& a, const ReadPreset& b)
{
    if (a.preset.has_value() != b.preset.has_value())
        return a.preset.has_value();
    if (!a.preset)
        return a.file < b.file;
    if (a.preset->name != b.preset->name)
        return a.preset->name < b.preset->name;
    return a.preset->version > b.preset->version;
}

}  // namespace

FeelPreset usualPreset(const std::vector<ReadPreset>& all)
{
    const FeelPreset& usual = shippedPresets().front();
    for (const ReadPreset& read : all) {
        if (!read.preset)
            continue;
        FeelPreset same = usual;
        same.version = read.preset->version;
        if (hashOf(same) == read.preset->hash)
            return *read.preset;
    }
    return usual;
}

std::vector<ReadPreset> shelved(std::vector<ReadPreset> kept)
{
    std::vector<ReadPreset> all;
    for (const FeelPreset& shipped : shippedPresets())
        all.push_back({{}, besideOwn(shipped, kept), {}});
    for (ReadPreset& read : kept) {
        const auto isSameVersion = [&](const ReadPreset& other) {
            return read.preset && other.preset && other.preset->name == read.preset->name &&
                   other.preset->version == read.preset->version;
        };
        const auto other = std::find_if(all.begin(), all.end(), isSameVersion);
        if (other != all.end() && other->preset->hash == read.preset->hash)
            continue;
        if (other != all.end()) {
            read.faults.push_back(
                {read.file,
                 QStringLiteral("version"),
                 {QT_TRANSLATE_NOOP("Fault", "there is another %1 of version %2; give this one another number"),
                  {core::noted(read.preset->name), noted(read.preset->version)}},
                 true});
            read.preset.reset();
        }
        all.push_back(std::move(read));
    }
    std::stable_sort(all.begin(), all.end(), before);
    return all;
}

core::Result<Placed> place(FeelPreset preset, const std::vector<ReadPreset>& all)
{
    const int wanted = preset.version;
    int newest = 0;
    bool isTaken = wanted <= 0;
    for (const ReadPreset& other : all) {
        if (!other.preset || other.preset->name != preset.name)
            continue;
        const bool isNewest = other.preset->version > newest;  // the newest version of a name comes first
        newest = std::max(newest, other.preset->version);
        preset.version = other.preset->version;
        if ((wanted > 0 ? preset.version == wanted : isNewest) && hashOf(preset) == other.preset->hash)
            return Placed{*other.preset, true};
        isTaken = isTaken || other.preset->version == wanted;
    }
    preset.version = isTaken ? newest + 1 : wanted;
    if (preset.version > kNewestPresetVersion)
        return core::unexpected(
            core::ErrorCode::OutOfRange,
            core::LocalizableText{QT_TRANSLATE_NOOP("Fault",
                                                    "%1 has the last version that there can be, %2; keep this under "
                                                    "another name"),
                                  {core::noted(preset.name), noted(kNewestPresetVersion)}});
    if (auto sound = checkPreset(preset); !sound)
        return tl::unexpected(sound.error());
    return Placed{hashed(std::move(preset))};
}

std::vector<ReadPreset> PresetFolder::list() const
{
    const QDir folder(m_folder);
    const QStringList names =
        folder.entryList({QStringLiteral("*.") + QLatin1String(kPresetSuffix)}, QDir::Files, QDir::Name);
    std::vector<ReadPreset> kept;
    for (const QString& name : names.mid(0, kMostPresets))
        kept.push_back(readPreset(folder.filePath(name)));
    return shelved(std::move(kept));
}

core::Result<FeelPreset> PresetFolder::save(const FeelPreset& preset) const
{
    if (!QDir().mkpath(m_folder))
        return core::unexpected(core::ErrorCode::FileUnwritable, "The folder of presets " + m_folder.toStdString() +
                                                                     " cannot be made; check the rights.");
    FeelPreset wanted = preset;
    for (int attempt = 0; attempt < kTries; ++attempt) {
        const auto placed = place(wanted, list());
        if (!placed)
            return tl::unexpected(placed.error());
        if (placed->isThere)
            return placed->preset;
        const QString file = QDir(m_folder).filePath(fileNameOf(placed->preset));
        const QString part = file + QStringLiteral(".part");
        if (auto written = writePreset(part, placed->preset); !written)
            return tl::unexpected(written.error());
        if (QFile::rename(part, file))  // rename() does not replace an existing file
            return placed->preset;
        QFile::remove(part);
        if (!QFileInfo::exists(file))
            break;
        wanted.version = 0;
    }
    return core::unexpected(core::ErrorCode::FileUnwritable, "The hardness preset could not be kept in " +
                                                                 m_folder.toStdString() + "; check the rights.");
}

QString presetsFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath(QStringLiteral("presets"));
}

QStringList namesOf(const std::vector<ReadPreset>& all)
{
    QStringList names;
    for (const ReadPreset& read : all)
        if (read.preset && !read.isRetired)
            names << QString::fromStdString(read.preset->name);
    names.removeDuplicates();
    return names;
}

core::Result<FeelPreset> findPreset(const std::vector<ReadPreset>& all, const QString& name)
{
    for (const ReadPreset& read : all) {
        if (!read.preset)
            continue;
        const QString own = QString::fromStdString(read.preset->name);
        if (name == own || name == QStringLiteral("%1 v%2").arg(own).arg(read.preset->version))
            return *read.preset;
    }
    return core::unexpected(core::ErrorCode::UnknownName,
                            QStringLiteral("There is no hardness preset '%1'; known: %2.")
                                .arg(name.left(80), namesOf(all).join(QStringLiteral(", ")))
                                .toStdString());
}

}  // namespace lessons
