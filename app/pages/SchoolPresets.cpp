// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/SchoolPresets.h"

#include <utility>

#include <QByteArray>
#include <QJsonDocument>

#include "database/SchoolSettings.h"
#include "lessons/PresetShelf.h"

namespace app {
namespace {

using core::settings::FeelPreset;
using database::Login;
using database::Repositories;
using lessons::ReadPreset;

constexpr qsizetype kLongestRetired = 16'000;  ///< characters of the names of all retired presets
constexpr int kTries = 16;

core::Result<std::vector<ReadPreset>> readStored(const Repositories& school, const Login& who)
{
    const auto stored = school.presets.list(who);
    if (!stored)
        return tl::unexpected(stored.error());
    std::vector<ReadPreset> all;
    for (const database::KeptPreset& one : *stored)
        all.push_back(lessons::readPresetText(QByteArray::fromStdString(one.json), QString::fromStdString(one.name)));
    return all;
}

QStringList retiredIn(const std::string& setting)
{
    return QString::fromStdString(setting).split(u'\n', Qt::SkipEmptyParts);
}

}  // namespace

core::Result<SchoolPresets> readPresets(const Repositories& school, const Login& who)
{
    auto all = readStored(school, who);
    auto settings = school.settings.read(who);
    if (!all || !settings)
        return tl::unexpected(all ? settings.error() : all.error());
    return SchoolPresets{std::move(*all), QString::fromStdString((*settings)[database::kPresetInUse]),
                         retiredIn((*settings)[database::kRetiredPresets])};
}

core::Result<FeelPreset> savePreset(const Repositories& school, const Login& who, FeelPreset wanted)
{
    core::Error why;
    for (int attempt = 0; attempt < kTries; ++attempt) {
        auto all = readStored(school, who);
        if (!all)
            return tl::unexpected(all.error());
        const auto placed = lessons::place(wanted, lessons::shelved(std::move(*all)));
        if (!placed || placed->isThere)
            return placed.map([](const lessons::Placed& at) { return at.preset; });
        const FeelPreset& preset = placed->preset;
        const QByteArray json = QJsonDocument(lessons::toJson(preset)).toJson(QJsonDocument::Compact);
        const auto added = school.presets.add(who, {preset.name, preset.version, preset.hash, json.toStdString()});
        if (added)
            return preset;
        why = added.error();
        if (why.code != core::ErrorCode::OutOfRange)
            break;
        wanted.version = 0;  // another station has just saved this version: take the next one
    }
    return tl::unexpected(why);
}

core::Result<bool> retirePreset(const Repositories& school, const Login& who, const QString& name, bool isRetired)
{
    for (int attempt = 0; attempt < kTries; ++attempt) {
        auto settings = school.settings.read(who);
        if (!settings)
            return tl::unexpected(settings.error());
        if (isRetired && lessons::presetUsed((*settings)[database::kPresetInUse], false).name == name)
            return false;
        const std::string before = (*settings)[database::kRetiredPresets];
        QStringList retired = retiredIn(before);
        if (!isRetired && !retired.contains(name))
            return true;
        retired.removeAll(name);
        if (isRetired)
            retired << name;
        const QString all = retired.join(u'\n');
        if (all.size() > kLongestRetired)
            return false;
        const auto replaced = school.settings.replace(who, database::kRetiredPresets, all.toStdString(), before);
        if (!replaced)
            return tl::unexpected(replaced.error());
        if (replaced->isDone)
            return true;
    }
    return core::unexpected(core::ErrorCode::Busy, "others are changing which presets are retired");
}

core::Result<ChosenPreset> choosePreset(const Repositories& school, const Login& who, const QString& name,
                                        const std::optional<QString>& insteadOf)
{
    auto settings = school.settings.read(who);
    if (!settings)
        return tl::unexpected(settings.error());
    const QString preset = lessons::presetUsed(name.toStdString(), false).name;
    const auto replaced = school.settings.replace(who, database::kPresetInUse, name.toStdString(),
                                                  insteadOf ? std::optional(insteadOf->toStdString()) : std::nullopt);
    if (!replaced)
        return tl::unexpected(replaced.error());
    // The preset in use is offered, although another admin may just have retired it.
    if (replaced->isDone)
        if (const auto offered = retirePreset(school, who, preset, false); !offered)
            return tl::unexpected(offered.error());
    return ChosenPreset{replaced->isDone, replaced->before,
                        retiredIn((*settings)[database::kRetiredPresets]).contains(preset)};
}

}  // namespace app
