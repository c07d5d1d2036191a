// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/PresetFile.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QRegularExpression>

#include "core/base/WholeFile.h"
#include "core/settings/StabilityBound.h"
#include "lessons/JsonFiles.h"
#include "lessons/JsonKeys.h"

namespace lessons {
namespace {

using core::settings::FeelPreset;
using Field = core::NumberField<FeelPreset>;

const QString kKind = QStringLiteral("cusp-hardness-preset");
constexpr const char* kBothCaries = "caries";

QString groupOf(const Field& field)
{
    const QString id = QLatin1String(field.id);
    return id.contains(u'.') ? id.section(u'.', 0, 0) : QString();
}

QByteArray keyOf(const Field& field)
{
    return QByteArray(field.id).mid(QByteArray(field.id).indexOf('.') + 1);
}

void takeNumber(JsonKeys& keys, const Field& field, FeelPreset& preset)
{
    preset.*field.value =
        keys.number(keyOf(field).constData(), field.minimum, field.maximum, field.unit, preset.*field.value);
}

void takeNumbers(JsonKeys& keys, FeelPreset& preset)
{
    using core::settings::Substance;
    if (auto both = keys.object(kBothCaries)) {
        for (const Substance one : {Substance::SoftCaries, Substance::FirmCaries}) {
            takeNumber(*both, core::settings::rateField(one), preset);
            takeNumber(*both, core::settings::thresholdField(one), preset);
        }
        both->nameTheRest();
    }
    std::map<QString, std::optional<JsonKeys>> groups;
    for (const Field& field : core::settings::feelFields()) {
        const QString group = groupOf(field);
        if (group.isEmpty()) {
            takeNumber(keys, field, preset);
            continue;
        }
        auto found = groups.find(group);
        if (found == groups.end())
            found = groups.emplace(group, keys.object(group.toUtf8().constData())).first;
        if (found->second)
            takeNumber(*found->second, field, preset);
    }
    for (auto& [name, group] : groups)
        if (group)
            group->nameTheRest();
}

/// Returns whether the file contains a field. "caries" stands for both kinds of caries.
bool says(const QJsonObject& whole, const Field& field)
{
    const QString group = groupOf(field);
    const QString key = QString::fromLatin1(keyOf(field));
    if (group.isEmpty())
        return whole.contains(key);
    const bool isCaries = group == u"soft_caries" || group == u"firm_caries";
    return whole.value(group).toObject().contains(key) ||
           (isCaries && whole.value(QLatin1String(kBothCaries)).toObject().contains(key));
}

/// Returns whether a field was added by format 2. A file without these fields is complete and has the effect of format
/// 1.
bool isOfFormat2(const Field& field)
{
    return field.value == &FeelPreset::flatEndShare || field.value == &FeelPreset::fullLoadN;
}

bool isOfFormat1(const FeelPreset& preset)
{
    return preset == core::settings::withoutEndsAndFullLoad(preset);
}

QStringList leftOutOf(const QJsonObject& whole)
{
    QStringList left;
    for (const Field& field : core::settings::feelFields()) {
        if (says(whole, field) || isOfFormat2(field))
            continue;
        const QString group = groupOf(field);
        const auto fields = core::settings::feelFields();
        const bool isAllOfIt = !group.isEmpty() && std::none_of(fields.begin(), fields.end(), [&](const Field& other) {
            return groupOf(other) == group && says(whole, other);
        });
        left << (isAllOfIt ? group : QString::fromLatin1(field.id));
    }
    left.removeDuplicates();
    return left;
}

/// Returns whether a name fits in one line of a table.
bool isOneLine(const std::string& name)
{
    return std::none_of(name.begin(), name.end(), [](char c) { return c == '\n' || c == '\t'; });
}

core::LocalizableText tooLarge(qint64 bytes)
{
    return {QT_TRANSLATE_NOOP("Fault", "has %1; a hardness preset has at most %2"),
            {sizeWords(bytes), sizeWords(kLargestPresetBytes)}};
}

}  // namespace

ReadPreset readPresetText(const QByteArray& json, const QString& file)
{
    ReadPreset read;
    read.file = file;
    const auto complain = [&](core::LocalizableText what, const QString& key = {}) {
        read.faults.push_back({file, key, std::move(what), true});
        return read;
    };
    if (json.size() > kLargestPresetBytes)
        return complain(tooLarge(json.size()));
    const auto whole = parseObject(json, file, read.faults);
    if (!whole)
        return read;
    JsonKeys keys(*whole, file, {}, read.faults);
    if (const qint64 format = keys.whole("format", 1, kNewestPresetVersion, 1); format > kPresetFormat)
        return complain(
            {QT_TRANSLATE_NOOP("Fault", "is %1, from a newer Cusp; this one reads %2. Update Cusp to use it"),
             {noted(format), noted(kPresetFormat)}},
            QStringLiteral("format"));
    if (keys.has("kind") && keys.text("kind") != kKind.toStdString())
        return complain({QT_TRANSLATE_NOOP("Fault", "says that this is no hardness preset; choose a file that Cusp has "
                                                    "exported")},
                        QStringLiteral("kind"));
    FeelPreset preset = core::settings::withoutEndsAndFullLoad(FeelPreset{});
    preset.name = keys.has("name") ? keys.visibleText("name", kLongestPresetName)
                                   : QFileInfo(file).completeBaseName().left(kLongestPresetName).toStdString();
    if (preset.name.empty() || !isOneLine(preset.name))
        keys.fault("name",
                   {QT_TRANSLATE_NOOP("Fault", "must be one line of 1 to %1 characters"), {noted(kLongestPresetName)}});
    preset.version = static_cast<int>(keys.whole("version", 1, kNewestPresetVersion, 1));
    preset.notes = keys.visibleText("notes", kLongestPresetNotes);
    takeNumbers(keys, preset);
    keys.nameTheRest();
    if (anyGrave(read.faults))
        return read;
    if (const core::Status held = core::settings::checkStability(preset); !held) {
        read.beyondBound = preset;
        return complain(core::wordsOf(held.error()), QStringLiteral("force"));
    }
    read.preset = hashed(std::move(preset));
    read.leftOut = leftOutOf(*whole);
    return read;
}

std::optional<ValidationIssue> leftOutFault(const ReadPreset& read)
{
    if (read.leftOut.isEmpty())
        return std::nullopt;
    return ValidationIssue{read.file,
                           {},
                           {QT_TRANSLATE_NOOP("Fault", "says nothing of %1: that is as shipped"),
                            {noted(read.leftOut.join(QStringLiteral(", ")))}},
                           false};
}

ReadPreset readPreset(const QString& path)
{
    ReadPreset read;
    read.file = path;
    const auto complain = [&](core::LocalizableText what) {
        read.faults.push_back({path, {}, std::move(what), true});
        return read;
    };
    if (!QFileInfo::exists(path))
        return complain({QT_TRANSLATE_NOOP("Fault", "is not there; check the name")});
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return complain({QT_TRANSLATE_NOOP("Fault", "cannot be read; name a file that you may read")});
    if (file.size() > kLargestPresetBytes)
        return complain(tooLarge(file.size()));
    return readPresetText(file.read(kLargestPresetBytes + 1), path);
}

core::Status checkPreset(const FeelPreset& preset)
{
    // A preset that can be written must be readable.
    const ReadPreset read = readPresetText(QJsonDocument(toJson(preset)).toJson(), QString::fromStdString(preset.name));
    if (read.preset)
        return {};
    const auto grave =
        std::find_if(read.faults.begin(), read.faults.end(), [](const ValidationIssue& fault) { return fault.grave; });
    if (grave->key.isEmpty())
        return core::unexpected(core::ErrorCode::OutOfRange, grave->what);
    return core::unexpected(core::ErrorCode::OutOfRange,
                            core::LocalizableText{"%1 %2", {noted(grave->key), grave->what}});
}

QJsonObject toJson(const FeelPreset& preset)
{
    const bool isFormat1 = isOfFormat1(preset);
    QJsonObject object{{"format", isFormat1 ? 1 : kPresetFormat},
                       {"kind", kKind},
                       {"name", QString::fromStdString(preset.name)},
                       {"version", preset.version}};
    if (!preset.notes.empty())
        object.insert(QStringLiteral("notes"), QString::fromStdString(preset.notes));
    for (const Field& field : core::settings::feelFields()) {
        if (isFormat1 && isOfFormat2(field))
            continue;
        const QString group = groupOf(field);
        const QString key = QString::fromLatin1(keyOf(field));
        const double value = preset.*field.value;
        if (group.isEmpty()) {
            object.insert(key, value);
        } else {
            QJsonObject inside = object.value(group).toObject();
            inside.insert(key, value);
            object.insert(group, inside);
        }
    }
    return object;
}

std::string hashOf(const FeelPreset& preset)
{
    return QCryptographicHash::hash(QJsonDocument(toJson(preset)).toJson(QJsonDocument::Compact),
                                    QCryptographicHash::Sha256)
        .toHex()
        .toStdString();
}

FeelPreset hashed(FeelPreset preset)
{
    preset.hash = hashOf(preset);
    return preset;
}

core::Status writePreset(const QString& file, const FeelPreset& preset)
{
    return core::writeWhole(std::filesystem::path(file.toStdU16String()),
                            QJsonDocument(toJson(preset)).toJson().toStdString(), "The hardness preset");
}

const std::vector<FeelPreset>& shippedPresets()
{
    static const std::vector<FeelPreset> kShipped = [] {
        FeelPreset newest;
        newest.version = 2;
        return std::vector<FeelPreset>{hashed(newest), hashed(core::settings::withoutEndsAndFullLoad(FeelPreset{}))};
    }();
    return kShipped;
}

PresetUsed presetUsed(const std::string& label, bool isChanged)
{
    static const QRegularExpression kLabel(QStringLiteral("^(.*) v([0-9]{1,7})(?: #([0-9a-f]{8,64}))?(, changed)?$"),
                                           QRegularExpression::DotMatchesEverythingOption);
    const QString text = QString::fromStdString(label);
    const auto parts = kLabel.match(text);
    if (!parts.hasMatch())
        return {text, 0, {}, isChanged};
    return {parts.captured(1), parts.captured(2).toInt(), parts.captured(3), isChanged || !parts.captured(4).isEmpty()};
}

PresetUsed presetUsed(const core::recording::Recording& recording)
{
    return presetUsed(recording.settings().hardness.name, recording.isRetuned());
}

}  // namespace lessons
