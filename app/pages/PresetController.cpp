// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/PresetController.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <QDir>
#include <QJsonDocument>
#include <QTimer>

#include "ui/kit/AppSettings.h"
#include "ui/text/PresetTexts.h"
#include "ui/text/Texts.h"
#include "ui/text/ValidationTexts.h"

namespace app {
namespace {

using core::settings::FeelPreset;
using database::Login;
using database::Repositories;
using database::Role;
using lessons::ReadPreset;
using ui::window::MainWindow;

const QString kInUse = QStringLiteral("presets/inUse");  ///< the preset in use of guests, in the settings of Cusp
constexpr int kLongestWaitMs = 1500;                     ///< of whenRead()

std::string nameOf(const FeelPreset& preset)
{
    return preset.name + " v" + std::to_string(preset.version);
}

/// The preset as it would be read after it was saved, with its faults.
ReadPreset readBack(FeelPreset preset)
{
    preset.version = std::max(preset.version, 1);  // 0 is the next one
    return lessons::readPresetText(QJsonDocument(lessons::toJson(preset)).toJson(),
                                   QString::fromStdString(preset.name));
}

QString saveFault(const core::Error& error)
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
    connect(&m_window.hardness(), &ui::window::HardnessController::presetsRequested, this, &PresetController::refresh);
    connect(&m_window.hardness(), &ui::window::HardnessController::useRequested, this,
            [this](const FeelPreset& preset) { use(QString::fromStdString(nameOf(preset)), {}); });
    connect(&m_window.hardness(), &ui::window::HardnessController::saveRequested, this,
            [this](const FeelPreset& preset) { save(preset, {}); });
    connect(&m_window.hardness(), &ui::window::HardnessController::retireRequested, this, &PresetController::retire);
    connect(&m_window.hardness(), &ui::window::HardnessController::importRequested, this, &PresetController::import);
    connect(&m_window.hardness(), &ui::window::HardnessController::exportRequested, this, &PresetController::exportTo);
}

void PresetController::setSchool(SchoolAccess* school)
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
    if (m_pendingReads == 0) {
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

void PresetController::read(bool showsError)
{
    const Login who = m_who();
    m_window.hardness().setMayKeep(who, who.isGuest() || who.role() == Role::Admin);
    if (!m_school) {
        apply(who, {});
        return;
    }
    ++m_pendingReads;
    m_school->ask(
        this, [who](const Repositories& school) { return readPresets(school, who); },
        [this, who, showsError](core::Result<SchoolPresets>& found) {
            if (who.person() == m_who().person()) {
                if (found) {
                    if (std::exchange(m_showsReadError, false))
                        m_window.hardness().showFault({});
                    apply(who, std::move(*found));
                } else if (m_all.empty()) {
                    apply(who, {});
                } else if (showsError) {  // the preset in use stays as it is: the same for the whole class
                    m_showsReadError = true;
                    m_window.hardness().showFault(
                        ui::text::errorText(found.error(), ui::text::FailedOperation::ReadingSchool));
                }
            }
            if (--m_pendingReads == 0)
                emit isRead();
        });
}

void PresetController::apply(const Login& who, SchoolPresets found)
{
    for (ReadPreset& one : found.all)
        one.isRetired = one.preset && found.retired.contains(QString::fromStdString(one.preset->name));
    if (who.isGuest()) {
        for (ReadPreset& own : m_folder.list())
            if (!own.file.isEmpty())
                found.all.push_back(std::move(own));
        found.inUse = ui::kit::memory().value(kInUse, found.inUse).toString();  // a guest's own choice comes first
    }
    m_all = lessons::shelved(std::move(found.all));
    const auto chosen = lessons::findPreset(m_all, found.inUse);
    const FeelPreset before = std::exchange(m_inUse, chosen.value_or(lessons::usualPreset(m_all)));
    m_window.hardness().setPresets(m_all, m_inUse);
    if (!(before == m_inUse))
        emit inUseChanged();
}

/// Uses a preset for new teeth. The tooth that is loaded keeps its own.
/// @param name       with its version; empty: the one that guests use until they choose one
/// @param insteadOf  uses it only if this one is in use, as another admin may have chosen another; empty: in any case
void PresetController::use(const QString& name, const std::optional<QString>& insteadOf)
{
    const Login who = m_who();
    if (who.isGuest()) {
        const QString before = ui::kit::memory().value(kInUse).toString();
        if (name.isEmpty())
            ui::kit::memory().remove(kInUse);
        else
            ui::kit::memory().setValue(kInUse, name);
        showUsed(name, before, tr("The next tooth feels like this."));
        return;
    }
    if (!m_school)
        return;
    m_school->ask(
        this, [who, name, insteadOf](const Repositories& school) { return choosePreset(school, who, name, insteadOf); },
        [this, name](const core::Result<ChosenPreset>& choice) {
            if (choice)
                showChoice(name, *choice);
            else
                m_window.hardness().showFault(
                    ui::text::errorText(choice.error(), ui::text::FailedOperation::ChangingSchool));
        });
}

void PresetController::showChoice(const QString& name, const ChosenPreset& choice)
{
    if (choice.isDone) {
        const QString before =
            QString::fromStdString(choice.before.empty() ? nameOf(lessons::usualPreset(m_all)) : choice.before);
        showUsed(name, before,
                 choice.wasRetired ? tr("The next tooth of everybody here feels like this. An admin had retired "
                                        "it; it is offered again.")
                                   : tr("The next tooth of everybody here feels like this."));
        return;
    }
    refresh();
    //: %1 is a hardness preset
    m_window.showMessage(tr("Somebody else has chosen %1 for everybody here meanwhile. That stays.")
                             .arg(ui::text::presetWords(lessons::presetUsed(choice.before, false))));
}

void PresetController::showUsed(const QString& name, const QString& before, const QString& said)
{
    refresh();
    m_window.hardness().showFault({});
    if (before == name)
        m_window.showMessage(said);
    else
        m_window.showUndoable(said, [this, name, before] { use(before, name); });
}

/// Retires all versions of a preset, or offers them again. Attempts that were made with it still name it.
void PresetController::retire(const QString& name, bool isRetired)
{
    if (!m_school)
        return;
    m_school->ask(
        this,
        [who = m_who(), name, isRetired](const Repositories& school) {
            return retirePreset(school, who, name, isRetired);
        },
        [this, name, isRetired](const core::Result<bool>& done) {
            if (!done) {
                m_window.hardness().showFault(
                    ui::text::errorText(done.error(), ui::text::FailedOperation::ChangingSchool));
                return;
            }
            refresh();
            if (!*done) {
                m_window.hardness().showFault(
                    tr("%1 was not retired: teeth feel like it now, or too many are retired.").arg(name));
                return;
            }
            m_window.hardness().showFault({});
            m_window.showUndoable(isRetired
                                      ? tr("%1 is offered to nobody any more. Attempts go on naming it.").arg(name)
                                      : tr("%1 is offered again.").arg(name),
                                  [this, name, isRetired] { retire(name, !isRetired); });
        });
}

void PresetController::save(const FeelPreset& preset, const QString& note)
{
    if (const ReadPreset read = readBack(preset); !read.preset) {
        m_window.hardness().showFault(tr("Not kept: %1").arg(ui::text::faultWords(read)));
        return;
    }
    const Login who = m_who();
    if (who.isGuest() || !m_school) {
        showSaved(m_folder.save(preset), note);
        return;
    }
    m_school->ask(
        this, [who, preset](const Repositories& school) { return savePreset(school, who, preset); },
        [this, note, who](const core::Result<FeelPreset>& saved) {
            if (who.person() == m_who().person())
                showSaved(saved, note);
            else if (saved)  // another user has logged in meanwhile
                refresh();
        });
}

void PresetController::showSaved(const core::Result<FeelPreset>& saved, const QString& note)
{
    if (!saved) {
        m_window.hardness().showFault(saveFault(saved.error()));
        return;
    }
    // With a name, as a preset from a file or from the school has: only the shipped presets have none.
    const ReadPreset one{QString::fromStdString(saved->name), *saved, {}};
    const bool isThere = std::any_of(m_all.begin(), m_all.end(), [&saved](const ReadPreset& other) {
        return other.preset && other.preset->hash == saved->hash;
    });
    if (!isThere) {
        m_all.push_back(one);
        m_all = lessons::shelved(std::move(m_all));
    }
    m_window.hardness().setPresets(m_all, m_inUse);
    m_window.hardness().showSaved(*saved, note);
    if (m_school != nullptr)
        readAgain();  // another admin may have retired it, or chosen another one
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
        save(*read.preset, note.join(u'\n'));
        return;
    }
    m_window.hardness().showFault(tr("Not imported: %1").arg(ui::text::faultWords(read)));
}

void PresetController::exportTo(const FeelPreset& preset, const QString& path)
{
    if (const auto written = lessons::writePreset(path, preset)) {
        m_window.hardness().showFault({});
        m_window.showMessage(tr("The preset was exported as %1.").arg(QDir::toNativeSeparators(path)));
    } else
        m_window.hardness().showFault(
            tr("Not exported: the file cannot be written. Choose another folder, or make room on the disk.") + u'\n' +
            QString::fromStdString(written.error().detail));
}

}  // namespace app
