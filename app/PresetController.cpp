// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/PresetController.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <QDir>
#include <QJsonDocument>
#include <QTimer>

#include "database/sql/Presets.h"
#include "database/sql/Settings.h"
#include "ui/kit/AppSettings.h"
#include "ui/text/PresetTexts.h"
#include "ui/text/Texts.h"
#include "ui/text/ValidationTexts.h"

namespace app {
namespace {

using core::settings::FeelPreset;
using database::Login;
using database::Role;
using database::sql::DatabaseContext;
using lessons::ReadPreset;
using ui::window::MainWindow;

const QString kInUse = QStringLiteral("presets/inUse");  ///< of who practises without a login
const std::string kSchoolsInUse = "preset.in_use";       ///< among the school's settings
/// The same: names, one a line.
const std::string kSchoolsRetired = "preset.retired";
constexpr qsizetype kLongestRetired = 16'000;  ///< characters of all those names
constexpr int kTries = 16;
constexpr int kLongestWaitMs = 1500;  ///< that a tooth waits for what it is to feel like

std::string nameOf(const FeelPreset& preset)
{
    return preset.name + " v" + std::to_string(preset.version);
}

core::Result<std::vector<ReadPreset>> readAll(const DatabaseContext& school, const Login& who)
{
    const auto kept = database::sql::listPresets(school, who);
    if (!kept)
        return tl::unexpected(kept.error());
    std::vector<ReadPreset> all;
    for (const database::sql::KeptPreset& one : *kept)
        all.push_back(lessons::readPresetText(QByteArray::fromStdString(one.json), QString::fromStdString(one.name)));
    return all;
}

/// Another station may keep one of the same name at the same time: then it becomes the version after that.
core::Result<FeelPreset> keepInSchool(const DatabaseContext& school, const Login& who, FeelPreset wanted)
{
    core::Error why;
    for (int attempt = 0; attempt < kTries; ++attempt) {
        auto all = readAll(school, who);
        if (!all)
            return tl::unexpected(all.error());
        const auto placed = lessons::place(wanted, lessons::shelved(std::move(*all)));
        if (!placed || placed->isThere)
            return placed.map([](const lessons::Placed& at) { return at.preset; });
        const FeelPreset& preset = placed->preset;
        const QByteArray json = QJsonDocument(lessons::toJson(preset)).toJson(QJsonDocument::Compact);
        const auto kept =
            database::sql::addPreset(school, who, {preset.name, preset.version, preset.hash, json.toStdString()});
        if (kept)
            return preset;
        why = kept.error();
        if (why.code != core::ErrorCode::OutOfRange)
            break;
        wanted.version = 0;
    }
    return tl::unexpected(why);
}

QStringList retiredIn(const std::string& setting)
{
    return QString::fromStdString(setting).split(u'\n', Qt::SkipEmptyParts);
}

/// Another admin may retire another at the same time. Not what is in use: OutOfRange.
core::Result<bool> retireInSchool(const DatabaseContext& school, const Login& who, const QString& name, bool isRetired)
{
    for (int attempt = 0; attempt < kTries; ++attempt) {
        auto settings = database::sql::readSettings(school, who);
        if (!settings)
            return tl::unexpected(settings.error());
        if (isRetired && lessons::presetUsed((*settings)[kSchoolsInUse], false).name == name)
            return false;
        const std::string before = (*settings)[kSchoolsRetired];
        QStringList retired = retiredIn(before);
        if (!isRetired && !retired.contains(name))
            return true;
        retired.removeAll(name);
        if (isRetired)
            retired << name;
        const QString all = retired.join(u'\n');
        if (all.size() > kLongestRetired)
            return false;
        const auto replaced = database::sql::replaceSetting(school, who, kSchoolsRetired, all.toStdString(), before);
        if (!replaced)
            return tl::unexpected(replaced.error());
        if (replaced->isDone)
            return true;
    }
    return core::unexpected(core::ErrorCode::Busy, "others are changing which presets are retired");
}

/// What reading it would find, were it kept.
ReadPreset readBack(FeelPreset preset)
{
    preset.version = std::max(preset.version, 1);  // 0 is the next one
    return lessons::readPresetText(QJsonDocument(lessons::toJson(preset)).toJson(),
                                   QString::fromStdString(preset.name));
}

QString keptFault(const core::Error& error)
{
    if (error.code == core::ErrorCode::NotAllowed)
        return PresetController::tr("Not kept: only an admin keeps the school's presets.");
    if (error.code == core::ErrorCode::OutOfRange)
        return PresetController::tr("Not kept: %1").arg(ui::text::faultWords(core::wordsOf(error)));
    if (error.code == core::ErrorCode::FileUnwritable)
        return PresetController::tr(
                   "Not kept: the file cannot be written. Make room on the disk, or check the rights.") +
               u'\n' + QString::fromStdString(error.detail);
    return ui::text::errorText(error, ui::text::FailedOperation::ChangingSchool);
}

}  // namespace

PresetController::PresetController(MainWindow& window, std::function<Login()> who)
    : m_window(window), m_who(std::move(who)), m_folder(lessons::presetsFolder()),
      m_inUse(lessons::shippedPresets().front())
{
    connectPage();
    refresh();
}

void PresetController::connectPage()
{
    connect(&m_window, &MainWindow::presetsRequested, this, &PresetController::refresh);
    connect(&m_window, &MainWindow::presetUseRequested, this,
            [this](const FeelPreset& preset) { use(QString::fromStdString(nameOf(preset)), {}); });
    connect(&m_window, &MainWindow::presetSaveRequested, this, [this](const FeelPreset& preset) { keep(preset, {}); });
    connect(&m_window, &MainWindow::presetRetireRequested, this, &PresetController::retire);
    connect(&m_window, &MainWindow::presetImportRequested, this, &PresetController::import);
    connect(&m_window, &MainWindow::presetExportRequested, this, &PresetController::exportTo);
}

void PresetController::setSchool(SchoolService* school)
{
    m_school = school;
    refresh();
}

void PresetController::refresh()
{
    read(true);
}

void PresetController::readAgain()
{
    read(false);
}

void PresetController::whenRead(const std::function<void()>& goOn)
{
    if (m_asked == 0) {
        goOn();
        return;
    }
    const auto once = [goOn, isOver = std::make_shared<bool>(false)] {
        if (!std::exchange(*isOver, true))
            goOn();
    };
    connect(this, &PresetController::isRead, this, once, Qt::SingleShotConnection);
    QTimer::singleShot(kLongestWaitMs, this, once);
}

void PresetController::read(bool tellsFault)
{
    const Login who = m_who();
    m_window.setMayKeepPresets(who, who.isGuest() || who.role() == Role::Admin);
    // The guest's own presets come first.
    const auto takeWith = [this, who](std::vector<ReadPreset> all, QString inUse, const QStringList& retired = {}) {
        for (ReadPreset& one : all)
            one.isRetired = one.preset && retired.contains(QString::fromStdString(one.preset->name));
        if (who.isGuest()) {
            for (ReadPreset& own : m_folder.list())
                if (!own.file.isEmpty())
                    all.push_back(std::move(own));
            inUse = ui::kit::memory().value(kInUse, inUse).toString();
        }
        take(lessons::shelved(std::move(all)), inUse);
    };
    if (!m_school) {
        takeWith({}, {});
        return;
    }
    struct Found
    {
        std::vector<ReadPreset> all;
        QString inUse;
        QStringList retired;
    };
    ++m_asked;
    m_school->ask(
        this,
        [who](const DatabaseContext& school) -> core::Result<Found> {
            auto all = readAll(school, who);
            auto settings = database::sql::readSettings(school, who);
            if (!all || !settings)
                return tl::unexpected(all ? settings.error() : all.error());
            return Found{std::move(*all), QString::fromStdString((*settings)[kSchoolsInUse]),
                         retiredIn((*settings)[kSchoolsRetired])};
        },
        [this, who, takeWith, tellsFault](const core::Result<Found>& found) {
            if (who.person() == m_who().person()) {
                if (found) {
                    if (std::exchange(m_isUnread, false))
                        m_window.showPresetFault({});
                    takeWith(found->all, found->inUse, found->retired);
                } else if (m_all.empty()) {
                    takeWith({}, {});
                } else if (tellsFault) {  // the preset in use stays: all of a class drill with the same
                    m_isUnread = true;
                    m_window.showPresetFault(
                        ui::text::errorText(found.error(), ui::text::FailedOperation::ReadingSchool));
                }
            }
            if (--m_asked == 0)
                emit isRead();
        });
}

void PresetController::take(std::vector<ReadPreset> all, const QString& inUse)
{
    m_all = std::move(all);
    const auto chosen = lessons::findPreset(m_all, inUse);
    const FeelPreset before = std::exchange(m_inUse, chosen.value_or(lessons::usualPreset(m_all)));
    m_window.setPresets(m_all, m_inUse);
    if (!(before == m_inUse))
        emit inUseChanged();
}

/// Chooses a preset for the next tooth. The tooth on the table keeps its own.
/// @param name       with its version; empty: the default, for a guest
/// @param insteadOf  changes only if this one is still in use: another admin may have chosen meanwhile
void PresetController::use(const QString& name, const std::optional<QString>& insteadOf)
{
    const Login who = m_who();
    if (who.isGuest()) {
        const QString before = ui::kit::memory().value(kInUse).toString();
        if (name.isEmpty())
            ui::kit::memory().remove(kInUse);
        else
            ui::kit::memory().setValue(kInUse, name);
        tellUsed(name, before, tr("The next tooth feels like this."));
        return;
    }
    if (!m_school)
        return;
    struct Used
    {
        database::sql::ReplacedSetting replaced;
        bool wasRetired = false;
    };
    m_school->ask(
        this,
        [who, name, insteadOf](const DatabaseContext& school) -> core::Result<Used> {
            auto settings = database::sql::readSettings(school, who);
            if (!settings)
                return tl::unexpected(settings.error());
            const QString preset = lessons::presetUsed(name.toStdString(), false).name;
            const auto replaced =
                database::sql::replaceSetting(school, who, kSchoolsInUse, name.toStdString(),
                                              insteadOf ? std::optional(insteadOf->toStdString()) : std::nullopt);
            if (!replaced)
                return tl::unexpected(replaced.error());
            // What is in use is not retired, though another admin may just have retired it.
            if (replaced->isDone)
                if (const auto up = retireInSchool(school, who, preset, false); !up)
                    return tl::unexpected(up.error());
            return Used{*replaced, retiredIn((*settings)[kSchoolsRetired]).contains(preset)};
        },
        [this, name](const core::Result<Used>& used) {
            if (!used) {
                m_window.showPresetFault(ui::text::errorText(used.error(), ui::text::FailedOperation::ChangingSchool));
                return;
            }
            const database::sql::ReplacedSetting& replaced = used->replaced;
            const QString before =
                QString::fromStdString(replaced.before.empty() ? nameOf(lessons::usualPreset(m_all)) : replaced.before);
            if (replaced.isDone) {
                tellUsed(name, before,
                         used->wasRetired ? tr("The next tooth of everybody here feels like this. An admin had retired "
                                               "it; it is offered again.")
                                          : tr("The next tooth of everybody here feels like this."));
                return;
            }
            refresh();
            //: %1 is a hardness preset
            m_window.showMessage(tr("Somebody else has chosen %1 for everybody here meanwhile. That stays.")
                                     .arg(ui::text::presetWords(lessons::presetUsed(replaced.before, false))));
        });
}

void PresetController::tellUsed(const QString& name, const QString& before, const QString& said)
{
    refresh();
    m_window.showPresetFault({});
    if (before == name)
        m_window.showMessage(said);
    else
        m_window.showUndoable(said, [this, name, before] { use(before, name); });
}

/// In all its versions. What was made with it goes on naming it.
void PresetController::retire(const QString& name, bool isRetired)
{
    if (!m_school)
        return;
    m_school->ask(
        this,
        [who = m_who(), name, isRetired](const DatabaseContext& school) {
            return retireInSchool(school, who, name, isRetired);
        },
        [this, name, isRetired](const core::Result<bool>& done) {
            if (!done) {
                m_window.showPresetFault(ui::text::errorText(done.error(), ui::text::FailedOperation::ChangingSchool));
                return;
            }
            refresh();
            if (!*done) {
                m_window.showPresetFault(
                    tr("%1 was not retired: teeth feel like it now, or too many are retired.").arg(name));
                return;
            }
            m_window.showPresetFault({});
            m_window.showUndoable(isRetired
                                      ? tr("%1 is offered to nobody any more. Attempts go on naming it.").arg(name)
                                      : tr("%1 is offered again.").arg(name),
                                  [this, name, isRetired] { retire(name, !isRetired); });
        });
}

void PresetController::keep(const FeelPreset& preset, const QString& note)
{
    if (const ReadPreset read = readBack(preset); !read.preset) {
        m_window.showPresetFault(tr("Not kept: %1").arg(ui::text::faultWords(read)));
        return;
    }
    const Login who = m_who();
    if (who.isGuest() || !m_school) {
        tellKept(m_folder.save(preset), note);
        return;
    }
    m_school->ask(
        this, [who, preset](const DatabaseContext& school) { return keepInSchool(school, who, preset); },
        [this, note, who](const core::Result<FeelPreset>& kept) {
            if (who.person() == m_who().person())
                tellKept(kept, note);
            else if (kept)  // another user has logged in meanwhile
                refresh();
        });
}

void PresetController::tellKept(const core::Result<FeelPreset>& kept, const QString& note)
{
    if (!kept) {
        m_window.showPresetFault(keptFault(kept.error()));
        return;
    }
    // Named, as what lies in a file or in the school is: only what is shipped has no place.
    const ReadPreset one{QString::fromStdString(kept->name), *kept, {}};
    const bool isThere = std::any_of(m_all.begin(), m_all.end(), [&kept](const ReadPreset& other) {
        return other.preset && other.preset->hash == kept->hash;
    });
    if (!isThere) {
        m_all.push_back(one);
        m_all = lessons::shelved(std::move(m_all));
    }
    m_window.setPresets(m_all, m_inUse);
    m_window.showPresetKept(*kept, note);
    if (m_school != nullptr)
        readAgain();  // another admin may have retired it, or chosen another
}

void PresetController::import(const QString& path)
{
    const ReadPreset read = lessons::readPreset(path);
    if (read.preset) {
        QStringList note;
        if (!read.faults.empty())
            note << ui::text::faultWords(read);
        if (const auto left = lessons::leftOutFault(read))
            note << ui::text::faultWords(*left);
        keep(*read.preset, note.join(u'\n'));
        return;
    }
    m_window.showPresetFault(tr("Not imported: %1").arg(ui::text::faultWords(read)));
}

void PresetController::exportTo(const FeelPreset& preset, const QString& path)
{
    if (const auto written = lessons::writePreset(path, preset)) {
        m_window.showPresetFault({});
        m_window.showMessage(tr("The preset was exported as %1.").arg(QDir::toNativeSeparators(path)));
    } else
        m_window.showPresetFault(
            tr("Not exported: the file cannot be written. Choose another folder, or make room on the disk.") + u'\n' +
            QString::fromStdString(written.error().detail));
}

}  // namespace app
