// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/HardnessController.h"

#include <numeric>

#include <QRandomGenerator>

#include "core/settings/FeelPreset.h"
#include "ui/console/Console.h"
#include "ui/console/Registration.h"
#include "ui/kit/MessageBar.h"
#include "ui/presets/PresetsPage.h"
#include "ui/presets/TrialCard.h"
#include "ui/text/PresetTexts.h"
#include "ui/window/CommandSender.h"
#include "ui/window/FileDialogs.h"
#include "ui/window/PracticeRoom.h"
#include "ui/window/UnsavedWork.h"

namespace ui::window {

using core::settings::FeelPreset;
using kit::MessageBar;
using presets::PresetsPage;
using presets::TrialCard;

HardnessController::HardnessController(const PracticeState& state, PracticeRoom& room, PresetsPage& page,
                                       console::Console& console, MessageBar& messages, FileDialogs& files,
                                       UnsavedWork& unsaved, CommandSender& commands)
    : QObject(&room), m_state(state), m_room(room), m_page(page), m_console(console), m_messages(messages),
      m_files(files), m_unsaved(unsaved), m_commands(commands), m_card(new TrialCard(&room))
{
    room.setTrial(m_card);
    connectPage();
    connectCard();
    connectConsole();
}

void HardnessController::connectPage()
{
    connect(&m_page, &PresetsPage::saveRequested, this, &HardnessController::saveRequested);
    connect(&m_page, &PresetsPage::useRequested, this, &HardnessController::useRequested);
    connect(&m_page, &PresetsPage::retireRequested, this, &HardnessController::retireRequested);
    connect(&m_page, &PresetsPage::importRequested, this, [this] {
        m_files.open(tr("Import a hardness preset"), FileDialogs::Kind::Preset,
                     [this](const QString& path) { emit importRequested(path); });
    });
    connect(&m_page, &PresetsPage::exportRequested, this, [this](const FeelPreset& preset) {
        m_files.save(tr("Export the hardness preset"), FileDialogs::Kind::Preset,
                     QStringLiteral("%1-v%2.%3")
                         .arg(QString::fromStdString(preset.name).replace(u'/', u'-'))
                         .arg(preset.version)
                         .arg(FileDialogs::suffixOf(FileDialogs::Kind::Preset)),
                     [this, preset](const QString& path) { emit exportRequested(preset, path); });
    });
    connect(&m_page, &PresetsPage::tryRequested, this, [this](const FeelPreset& base, const FeelPreset& preset) {
        m_unsaved.leaveWork([this, base, preset] {
            m_blindTrial.reset();
            m_tried.emplace(base, preset);
            emit trialRequested(preset);
        });
    });
    connect(&m_page, &PresetsPage::compareRequested, this,
            [this](const FeelPreset& first, const FeelPreset& second, int trials) {
                m_unsaved.leaveWork([this, first, second, trials] {
                    m_blindTrial.emplace(first, second, trials, QRandomGenerator::global()->generate64());
                    m_tried.reset();
                    emit trialRequested(first);
                });
            });
}

void HardnessController::connectCard()
{
    connect(m_card, &TrialCard::felt, this, [this](const FeelPreset& preset) {
        m_feel = preset;
        emit trialFelt(preset);
    });
    connect(m_card, &TrialCard::blockChosen, this, &HardnessController::trialBlockChosen);
    connect(m_card, &TrialCard::freshBlockRequested, this, [this] { m_commands.send(core::session::Reload{}); });
    connect(m_card, &TrialCard::done, this, [this] {
        if (const auto tuned = m_card->tuned())
            m_page.setDraft(*tuned);
        emit presetsRequested();
        emit pageRequested();
    });
    connect(m_card, &TrialCard::csvRequested, this, [this](const QByteArray& csv) {
        m_files.saveComparison(tr("Save the comparison"),
                               FileDialogs::newFileName(m_state.tooth->name, FileDialogs::Kind::Table), csv);
    });
}

void HardnessController::connectConsole()
{
    m_console.setPresets(
        [this](const QString& name) {
            FeelPreset preset = m_feel;
            preset.name = name.toStdString();
            preset.version = 0;
            emit saveRequested(preset);  // the receiver calls showSaved() or showFault()
            return QString();
        },
        [this](const QString& name) { return useByName(name); }, [this] { return lessons::namesOf(m_page.all()); });
}

QString HardnessController::useByName(const QString& name)
{
    const auto found = lessons::findPreset(m_page.all(), name);
    if (!found)
        return tr("There is no hardness preset \"%1\". There are: %2.")
            .arg(name, lessons::namesOf(m_page.all()).join(QStringLiteral(", ")));
    const std::string refused = feelByHand(*found);
    //: %1 is a hardness preset
    return refused.empty() ? tr("It feels like %1 now.").arg(text::presetWords(*found))
                           : QString::fromStdString(refused);
}

void HardnessController::addTo(core::settings::Parameters& parameters)
{
    console::registerFeel(
        parameters, [this] { return m_feel; }, [this] { return m_usualFeel; },
        [this](const FeelPreset& next) { return feelByHand(next); });
}

/// Returns the usual preset if all numbers are equal to its numbers, otherwise `wanted`.
FeelPreset HardnessController::usualIfEqual(const FeelPreset& wanted) const
{
    FeelPreset next = m_usualFeel;
    for (const auto& field : core::settings::feelFields())
        next.*field.value = wanted.*field.value;
    return next == m_usualFeel ? m_usualFeel : wanted;
}

QString HardnessController::whyNotByHand(const FeelPreset& next) const
{
    if (m_state.isExamRunning())
        return tr("The hardness cannot be changed during an exam.");
    if (m_state.isReplaying)
        return tr("A replay uses the recorded hardness.");
    if (isTrial() && m_card->isComparing())
        return tr("A blind comparison of two presets is running. Finish it first.");
    // If the lesson has its own hardness, only the forces can be changed.
    FeelPreset forces = next;
    for (const auto& field : core::settings::feelFields().subspan(0, core::settings::kCuttingFields))
        forces.*field.value = m_feel.*field.value;
    const auto& assignment = m_state.assignment;
    if (assignment && assignment->lesson && assignment->lesson->hardness && !(forces == next))
        return tr("This lesson sets its own hardness. Only the forces can be changed.");
    return {};
}

std::string HardnessController::feelByHand(const FeelPreset& wanted)
{
    const FeelPreset next = usualIfEqual(wanted);
    if (const QString whyNot = whyNotByHand(next); !whyNot.isEmpty())
        return whyNot.toStdString();
    m_feel = next;
    if (!isTrial()) {
        emit feelRequested(next);
        return {};
    }
    if (m_card->tuned())
        m_card->tune(m_card->base(), next);
    emit trialFelt(next);
    return {};
}

void HardnessController::setPresets(std::vector<lessons::ReadPreset> all, const FeelPreset& inUse)
{
    m_page.setPresets(std::move(all), inUse);
}

void HardnessController::setMayKeep(const database::Login& who, bool may)
{
    m_page.setMayKeep(may);
    m_page.setMayRetire(may && !who.isGuest());
}

void HardnessController::showSaved(const FeelPreset& preset, const QString& note)
{
    m_page.select(preset);
    m_page.setFault(note);
    const QString said = tr("The hardness preset was saved: %1.").arg(text::presetWords(preset));
    if (m_console.isVisible())
        m_console.say(note.isEmpty() ? said : said + u'\n' + note);
    else
        m_messages.say({MessageBar::Kind::News, said, {}, {}, {}, MessageBar::Topic::Preset});
}

void HardnessController::showFault(const QString& sentence)
{
    m_messages.withdraw(MessageBar::Topic::Preset);
    m_page.setFault(sentence);
    if (m_console.isVisible() && !sentence.isEmpty())
        m_console.say(sentence);
}

void HardnessController::setFeel(const FeelPreset& now, const FeelPreset& usual)
{
    m_feel = now;
    m_usualFeel = usual;
    emit feelChanged();
}

void HardnessController::beginTrial()
{
    if (m_blindTrial)
        m_card->compare(*m_blindTrial);
    else if (m_tried)
        m_card->tune(m_tried->first, m_tried->second);
    m_blindTrial.reset();
    m_tried.reset();
    m_room.setHintVisible(false);
}

void HardnessController::endTrial()
{
    m_card->hide();
}

bool HardnessController::isTrial() const
{
    return m_card->isVisibleTo(&m_room);
}

void HardnessController::follow(const core::servo::ServoState& servo)
{
    if (!m_card->isVisible())
        return;
    const core::terrain::PerMaterial cut = m_state.ownWork();
    m_card->follow(servo.burIndex, servo.handpieceIndex, std::accumulate(cut.begin(), cut.end(), 0.0));
}

}  // namespace ui::window
