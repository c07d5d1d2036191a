// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/Drafts.h"

#include <utility>

#include "lessons/LessonCatalog.h"
#include "ui/admin/PeoplePart.h"
#include "ui/people/TalkPanel.h"
#include "ui/presets/PresetsPage.h"
#include "ui/shell/MessageBar.h"
#include "ui/study/LessonEditor.h"

namespace ui::shell {
namespace {

constexpr int kBeatMs = 5000;  ///< so much typing a power cut may take

}  // namespace

Drafts::Drafts(const Pages& pages, MessageBar& messages, Reader reader, QObject* parent)
    : QObject(parent), m_pages(pages), m_messages(messages), m_reader(std::move(reader))
{
    // The program may be killed, or the computer switched off.
    connect(&m_beat, &QTimer::timeout, this, &Drafts::putBy);
    m_beat.start(kBeatMs);
}

void Drafts::setFolder(const QString& folder, const QString& school)
{
    m_putBy = std::make_unique<PutBy>(folder, school);
    for (const QJsonValue one : m_putBy->found())
        if (!goOnWith(one.toObject()))
            m_unclaimed.append(one);
}

/// False: another has its place, or it is nothing.
bool Drafts::goOnWith(const QJsonObject& typed)
{
    return m_pages.editor.goOnWith(typed, lessons::teachersFolder()) || m_pages.talk.goOnWith(typed) ||
           m_pages.presets.goOnWith(typed) || m_pages.people.goOnWith(typed);
}

bool Drafts::mayDecideOn(const QJsonObject& typed) const
{
    const QString person = typed["person"].toString();
    return person.isEmpty() ? m_reader.mayEdit() : m_reader.isWriter(person);
}

/// Two windows may have had a draft of the same.
void Drafts::tell()
{
    QJsonArray left;
    for (const QJsonValue one : std::as_const(m_unclaimed))
        if (!mayDecideOn(one.toObject()) || !goOnWith(one.toObject()))  // its place may be free by now
            left.append(one);
    m_unclaimed = left;
    for (const QJsonValue one : left)
        if (mayDecideOn(one.toObject()) && !m_told.contains(one)) {
            m_told.append(one);
            tellOf(one.toObject());
        }
}

void Drafts::tellOf(const QJsonObject& typed)
{
    m_messages.say([this, typed] {
        MessageBar::Message message;
        message.kind = MessageBar::Kind::Warning;
        message.topic = MessageBar::Topic::Drafts;
        for (const QString& words :
             {people::TalkPanel::words(typed), presets::PresetsPage::words(typed), study::LessonEditor::words(typed)})
            if (message.sentence.isEmpty())
                message.sentence = words;
        const bool isNothing = message.sentence.isEmpty();
        if (isNothing)
            message.sentence = tr("Something that was typed and kept nowhere waits on this computer, but this Cusp "
                                  "cannot read it.");
        // Of a lesson whose file is gone nothing can be made.
        if (!isNothing && (!typed.contains("lesson") || m_pages.editor.isTaken(typed))) {
            message.actionText = tr("Take it instead");
            message.action = [this, typed] { takeInstead(typed); };
        }
        message.declining = {tr("Throw it away"), [this, typed] { drop(typed); }};
        return message;
    });
}

/// What is there waits from now on, and can be taken back in the same way.
void Drafts::takeInstead(const QJsonObject& typed)
{
    const bool isLesson = typed.contains("lesson");
    const bool isTalk = typed.contains("attempt");
    const QJsonObject before = isLesson ? m_pages.editor.trade(typed)
                               : isTalk ? m_pages.talk.trade(typed)
                                        : m_pages.presets.trade(typed);
    m_told.append(before);
    m_unclaimed.append(before);
    drop(typed);
    if (isTalk)
        emit attemptWanted(typed["attempt"].toInteger());
    else if (!isLesson)
        emit presetsWanted();
    tellOf(before);
}

void Drafts::tellOfNothing(qint64 attempt)
{
    m_messages.say([this, attempt, typed = m_pages.talk.typedOn(attempt)] {
        MessageBar::Message message;
        message.kind = MessageBar::Kind::Warning;
        message.topic = MessageBar::Topic::Drafts;
        message.sentence = tr("The attempt that you typed this on is there no more.");
        message.detail = typed;
        message.declining = {tr("Throw it away"), [this, attempt] {
                                 m_pages.talk.forget(attempt);
                                 putBy();
                             }};
        return message;
    });
}

void Drafts::drop(const QJsonObject& typed)
{
    QJsonArray left;
    for (const QJsonValue one : std::as_const(m_unclaimed))
        if (one != QJsonValue(typed))
            left.append(one);
    m_unclaimed = left;
    putBy();
}

void Drafts::forgetTold()
{
    m_told = {};
}

/// @param lessons  drafts of them, too
/// @param withOwn  and what who works here has typed
QJsonArray Drafts::all(bool lessons, bool withOwn) const
{
    QJsonArray found = m_unclaimed;
    const auto add = [&found](const QJsonArray& more) {
        for (const QJsonValue one : more)
            found.append(one);
    };
    if (lessons)
        add(m_pages.editor.unsavedDrafts());
    add(m_pages.talk.waiting(withOwn));
    add(m_pages.presets.waiting(withOwn));
    add(m_pages.people.waiting(withOwn));
    return found;
}

void Drafts::putBy()
{
    if (m_putBy)
        static_cast<void>(m_putBy->keep(all(true, true)));
}

bool Drafts::putOthersBy()
{
    const QJsonArray others = all(!m_reader.mayEdit(), m_reader.isLockedOut());
    return m_putBy ? m_putBy->keep(others) : others.isEmpty();
}

void Drafts::stop()
{
    m_beat.stop();
}

}  // namespace ui::shell
